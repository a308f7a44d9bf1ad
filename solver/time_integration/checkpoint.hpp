// SPDX-License-Identifier: BSD-3-Clause
// State of a run between two steps as numbers, from which a resumed run ends with the same digits, and the archive that
// writes and reads it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <ranges>
#include <span>
#include <type_traits>
#include <vector>

#include "solver/members.hpp"

namespace tiretherm::solver {

/// The state of a run between two steps, as numbers: enough to go on and end with the same digits. What it belongs to
/// is for the keeper of the file to remember; a state of another problem is refused by its length.
struct Checkpoint {
    std::vector<double> numbers;
};

/// Checkpoints of a run: where it starts from, how often it leaves one, and who keeps them.
///
/// Leaving a checkpoint changes nothing in a run: it ends with the same digits whether, when and how often it left one.
struct Continuation {
    const Checkpoint* from = nullptr;  ///< null: from the beginning
    long every = 0;                    ///< accepted steps between checkpoints; 0: none
    std::function<void(const Checkpoint&)> keep;
    std::function<bool()> due{};  ///< asked before one is left; empty: always
};

/// Walks through a state in one order, writing it to numbers or reading it back. Of a struct it takes all members, which the compiler
/// counts: none can be forgotten. A class with other members says itself in `visit` what its state is.
class Archive {
public:
    static Archive writing(std::vector<double>& numbers) { return Archive(&numbers, {}); }
    /// Writes nothing.
    static Archive counting() { return Archive(nullptr, {}, true); }
    static Archive reading(std::span<const double> numbers) { return Archive(nullptr, numbers); }

    /// Lists have the length that they have on both sides.
    template <typename Value>
    void operator()(Value& value) {
        take<false>(value);
    }
    /// The lengths of lists are part of the state.
    template <typename Value>
    void grown(Value& value) {
        take<true>(value);
    }

    /// What is not changed; only in writing and counting.
    void write(std::span<const double> numbers) {
        count_ += numbers.size();
        if (out_ != nullptr) {
            out_->insert(out_->end(), numbers.begin(), numbers.end());
        }
    }

    [[nodiscard]] bool is_reading() const { return out_ == nullptr && !is_counting_; }
    /// Numbers that were written or counted.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// Numbers that are left to be read.
    [[nodiscard]] std::size_t left() const { return in_.size() - next_; }
    /// Whether exactly all numbers were read.
    [[nodiscard]] bool complete() const { return !is_short_ && next_ == in_.size(); }

private:
    Archive(std::vector<double>* out, std::span<const double> in, bool is_counting = false)
        : out_(out), in_(in), is_counting_(is_counting) {}

    template <bool grows, typename Value>
    void take(Value& value) {
        if constexpr (std::is_arithmetic_v<Value>) {
            take_number(value);
        } else if constexpr (requires { value.visit(*this); }) {
            value.visit(*this);
        } else if constexpr (std::ranges::range<Value>) {
            if constexpr (grows && requires { value.resize(0); }) {
                std::size_t length = value.size();
                take_number(length);
                value.resize(is_reading() ? std::min(length, left()) : length);  // a damaged archive will be refused
            }
            for (auto& item : value) {
                take<grows>(item);
            }
        } else {
            for_each_member(value, [this](auto& member) { take<grows>(member); });
        }
    }

    /// Whole numbers up to 2^53 and truths pass through a double unharmed.
    template <typename Number>
    void take_number(Number& value) {
        if (!is_reading()) {
            const auto number = static_cast<double>(value);
            write({&number, 1});
        } else if (next_ < in_.size()) {
            value = static_cast<Number>(in_[next_++]);
        } else {
            is_short_ = true;
        }
    }

    std::vector<double>* out_;
    std::span<const double> in_;
    std::size_t next_ = 0;
    std::size_t count_ = 0;
    bool is_counting_ = false;
    bool is_short_ = false;
};

}  // namespace tiretherm::solver
