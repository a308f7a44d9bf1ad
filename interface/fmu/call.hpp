// SPDX-License-Identifier: BSD-3-Clause
// What the functions of both versions of the standard have in common: the instance behind a pointer, kept states, refusals.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "interface/fmu/instance.hpp"

namespace tiretherm::fmu {

inline constexpr std::initializer_list<Mode> any_mode{Mode::instantiated, Mode::initialization, Mode::step,
                                                      Mode::terminated};

/// A list of a caller. @errors std::invalid_argument where he gives none and says that it has items
template <typename Item>
std::span<Item> list(Item* items, std::size_t n) {
    if (items == nullptr && n > 0) {
        throw std::invalid_argument("a list is missing");
    }
    return {items, n};
}

inline void require(bool condition, const char* otherwise) {
    if (!condition) {
        throw std::invalid_argument(otherwise);
    }
}
inline void require_none(std::size_t n) { require(n == 0, "the FMU has no variables of this type"); }
/// @errors Discarded: the status that was asked for is not available
inline void require_status(bool available) {
    if (!available) {
        throw Discarded("there is no such status");
    }
}

/// A text with a character doubled that means something to whoever prints it.
[[nodiscard]] std::string doubled(const std::string& text, char special);

/// Runs a call on the instance behind a pointer. @returns a status of the standard
template <typename Call>
int call(void* instance, std::string_view name, std::initializer_list<Mode> allowed, const Call& work) {
    if (instance == nullptr) {
        return static_cast<int>(Status::error);
    }
    auto& it = *static_cast<Instance*>(instance);
    return static_cast<int>(it.run(name, allowed, [&] { work(it); }));
}

/// Makes an instance, or logs why there is none. @param folder gives the folder of resources after its own checks
template <typename Folder>
void* instantiate(const char* name, const char* token, const char* resources, Logger logger, bool logging,
                  const Folder& folder) {
    try {
        require(name != nullptr && std::string_view(name).find_first_not_of(" \t\r\n") != std::string_view::npos,
                "the instance has no name");
        require(token != nullptr && resources != nullptr, "the token or the folder of the resources is missing");
        return new Instance(folder(), token, logger, logging);
    } catch (const std::exception& reason) {
        if (logger) {
            logger(Status::error, log_error.data(), reason.what());
        }
        return nullptr;
    }
}

[[nodiscard]] int unsupported(void* instance, std::string_view name);

[[nodiscard]] int get_state(void* instance, std::string_view name, void** state);
[[nodiscard]] int set_state(void* instance, std::string_view name, void* state);
[[nodiscard]] int free_state(void* instance, std::string_view name, void** state);
[[nodiscard]] int serialised_size(void* instance, std::string_view name, void* state, std::size_t* size);
[[nodiscard]] int serialise(void* instance, std::string_view name, void* state, char* bytes, std::size_t size);
[[nodiscard]] int deserialise(void* instance, std::string_view name, const char* bytes, std::size_t size, void** state);

}  // namespace tiretherm::fmu
