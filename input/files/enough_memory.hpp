// SPDX-License-Identifier: BSD-3-Clause
// A file for which there is not enough memory is a mistake in the input with its place, not the end of the program.
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "input/text/input_error.hpp"

namespace tiretherm::input {

/// Calls what reads a file. Where the memory does not suffice, that is an error.
/// @param shown the file, as messages name it  @param place where it is mentioned; file -1: nowhere
/// @returns what `read` returns, an empty value after the error
template <typename Read>
[[nodiscard]] auto with_memory(const std::string& shown, const SourceLocation& place, InputErrors& errors,
                               const Read& read) -> decltype(read()) {
    ErrorText error;
    try {
        return read();
    } catch (const std::bad_alloc&) {
        error = {"there is not enough memory for the file " + shown, "split it, or leave out columns and samples"};
    } catch (const std::length_error&) {
        error = {"the file " + shown + " announces more values than any memory has", "export it again"};
    }
    errors.add(place.file >= 0 ? place : SourceLocation{.file = errors.add_file(shown, "")}, std::move(error));
    return {};
}

}  // namespace tiretherm::input
