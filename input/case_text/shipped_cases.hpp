// SPDX-License-Identifier: BSD-3-Clause
// Cases of the library whose text is part of the program (cmake/shipped_cases.cmake), so that a new case has their values.
#pragma once

#include <string>
#include <string_view>

namespace tiretherm::input {

/// The text of cases/PATH, such as "section/common.toml".
/// @errors std::logic_error for a file that the program does not carry along
[[nodiscard]] std::string_view shipped_case(std::string_view path);

}  // namespace tiretherm::input
