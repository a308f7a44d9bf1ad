// SPDX-License-Identifier: BSD-3-Clause
// What keeps exceptions within the C interface.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "interface/tiretherm.h"

/// The C interface: handles, and what becomes of exceptions.
namespace tiretherm::interface {

/// Keeps a sentence, which may itself find no memory.
inline void keep(const char* sentence, std::string& message) {
    try {
        message = sentence;
    } catch (...) {
        message = "out of memory";  // within the string itself
    }
}

/// Makes a call. @param message out: of an exception; else what the call writes there
/// @returns what the call does, TIRETHERM_FAILED after an exception
template <typename Call>
int guarded(std::string& message, const Call& call) {
    try {
        message.clear();
        return call();
    } catch (const std::bad_alloc&) {
        keep("there is not enough memory", message);
    } catch (const std::exception& error) {
        keep(error.what(), message);
    } catch (...) {
        keep("an exception that says nothing", message);
    }
    return TIRETHERM_FAILED;
}

/// Says why a call is refused.
[[nodiscard]] inline int refuse(std::string& message, int result, std::string reason) {
    message = std::move(reason);
    return result;
}

/// As much of a text as there is room for.
inline void copy(const std::string& text, char* to, std::size_t size) {
    if (to != nullptr && size > 0) {
        const std::size_t n = std::min(text.size(), size - 1);
        std::memcpy(to, text.data(), n);
        to[n] = '\0';
    }
}

/// The handle that `make` makes. @param make takes the text that says why not  @returns NULL after an error
template <typename Make>
auto opened(char* message, std::size_t size, const Make& make) -> decltype(make(std::declval<std::string&>())) {
    std::string text;
    decltype(make(text)) handle = nullptr;
    static_cast<void>(guarded(text, [&] {
        handle = make(text);
        return TIRETHERM_OK;
    }));
    copy(text, message, size);
    return handle;
}

/// The item of a list at a number from C; null when there is none.
template <typename List>
auto item_of(List& list, int number) -> decltype(list.data()) {
    return number >= 0 && static_cast<std::size_t>(number) < list.size() ? list.data() + number : nullptr;
}

}  // namespace tiretherm::interface
