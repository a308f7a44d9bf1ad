// SPDX-License-Identifier: BSD-3-Clause
// What holds for everything that is read, whatever its content: errors or a result, in sentences that a terminal can show.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "input/text/input_error.hpp"

namespace tiretherm::fuzz {

/// A reader did not do what it promises.
class BrokenPromise : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// @errors BrokenPromise with `sentence` where `kept` is false
void promise(bool kept, const std::string& sentence);

/// Each message has a text of at most 4000 bytes, and an error has a place in a file.
/// @errors BrokenPromise
void check_messages(const std::vector<input::InputError>& errors, const std::vector<std::string>& warnings);

/// There is a result exactly when there is no error, and the messages are sound. @errors BrokenPromise
void check_outcome(bool result, const std::vector<input::InputError>& errors, const std::vector<std::string>& warnings);

/// A file in the scratch folder of this process, in memory where the system has /dev/shm. Replaced by the next of its name;
/// the shipped cases are beside it in `cases`.
[[nodiscard]] std::filesystem::path scratch_file(const std::string& name, std::string_view bytes);

/// A file of the shipped cases. @param name below cases/
[[nodiscard]] std::filesystem::path shipped(const std::string& name);

}  // namespace tiretherm::fuzz
