// SPDX-License-Identifier: BSD-3-Clause
// Writes a value with all that it is made of to bytes, and reads it back in a program of the same build.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <ranges>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "physics/effect.hpp"
#include "physics/tire_laws/magic_formula.hpp"
#include "physics/tire_laws/measured_loss.hpp"
#include "solver/input_model.hpp"
#include "solver/input_signals.hpp"
#include "solver/members.hpp"

namespace tiretherm::solver {

/// Walks through a value in one order, writing it to bytes or reading it back. Of a struct it takes all members, which the compiler
/// counts: none can be forgotten. Effects and signals are written by their names. Input signals and what computes them are left
/// out: a session is given its inputs.
class ByteArchive {
public:
    static ByteArchive writing(std::string& bytes) { return {&bytes, {}}; }
    static ByteArchive reading(std::string_view bytes) { return {nullptr, bytes}; }

    template <typename Value>
    void operator()(Value& value) {
        if constexpr (std::is_same_v<Value, InputSignals> || std::is_same_v<Value, std::shared_ptr<const InputModel>>) {
            return;
        } else if constexpr (std::is_same_v<Value, std::shared_ptr<const physics::OwnLaw>>) {
            if (value != nullptr) {
                throw std::runtime_error("a law of the calling program cannot be stored");
            }
        } else if constexpr (std::is_same_v<Value, const physics::Effect*>) {
            take_effect(value);
        } else if constexpr (std::is_scalar_v<Value> || std::is_same_v<Value, physics::MagicFormula>) {
            static_assert(!std::is_pointer_v<Value>, "an address means nothing in another process");
            take_bytes(reinterpret_cast<char*>(&value), sizeof value);
        } else if constexpr (requires { value.visit_members([](const auto&) {}); }) {
            // The members are those of a value that may be changed, and are shown as constant ones.
            value.visit_members(
                [this]<typename Member>(const Member& member) { (*this)(const_cast<Member&>(member)); });
        } else if constexpr (requires { value.has_value(); }) {
            take_optional(value);
        } else if constexpr (requires { value.use_count(); }) {
            take_shared(value);
        } else if constexpr (std::ranges::range<Value>) {
            take_list(value);
        } else {
            for_each_member(value, [this](auto& member) { (*this)(member); });
        }
    }

    [[nodiscard]] bool is_reading() const { return out_ == nullptr; }
    /// Whether exactly all bytes were read, and each name was known.
    [[nodiscard]] bool complete() const { return !is_damaged_ && next_ == in_.size(); }

private:
    ByteArchive(std::string* out, std::string_view in) : out_(out), in_(in) {}

    void take_bytes(char* bytes, std::size_t n) {
        if (out_ != nullptr) {
            out_->append(bytes, n);
        } else if (n <= in_.size() - next_) {
            std::copy_n(in_.begin() + static_cast<std::ptrdiff_t>(next_), n, bytes);
            next_ += n;
        } else {
            is_damaged_ = true;
        }
    }

    void take_effect(const physics::Effect*& effect) {
        std::string id(is_reading() ? std::string_view() : effect->id);
        // An effect whose field follows time has more coefficients than that of the catalogue.
        bool framed = !is_reading() && effect != physics::find_effect(effect->id);
        (*this)(id);
        (*this)(framed);
        if (is_reading()) {
            effect = physics::find_effect(id);
            is_damaged_ = is_damaged_ || effect == nullptr;
            effect = effect != nullptr && framed ? &physics::in_frames(*effect) : effect;
        }
    }

    template <typename Optional>
    void take_optional(Optional& value) {
        bool has = value.has_value();
        (*this)(has);
        if (is_reading()) {
            value.reset();
            if (has) {
                value.emplace();
            }
        }
        if (has) {
            (*this)(*value);
        }
    }

    template <typename Pointee>
    void take_shared(std::shared_ptr<const Pointee>& value) {
        bool has = value != nullptr;
        (*this)(has);
        if (has) {
            auto copy = is_reading() ? std::make_shared<Pointee>() : std::make_shared<Pointee>(*value);
            (*this)(*copy);
            value = std::move(copy);
        }
    }

    template <typename List>
    void take_list(List& list) {
        if constexpr (requires { list.resize(0); }) {
            std::size_t length = list.size();
            (*this)(length);
            // Each item takes a byte at least: a damaged length is no reason to take all memory.
            is_damaged_ = is_damaged_ || (is_reading() && length > in_.size() - next_);
            list.resize(is_damaged_ ? 0 : length);
        }
        for (auto& item : list) {
            (*this)(item);
        }
    }

    std::string* out_;
    std::string_view in_;
    std::size_t next_ = 0;
    bool is_damaged_ = false;
};

}  // namespace tiretherm::solver
