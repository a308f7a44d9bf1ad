// SPDX-License-Identifier: BSD-3-Clause
// Texts in other encodings than UTF-8, as programs that write logs still have them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tiretherm::input {

/// How many bytes the UTF-8 character at the start of a text has; 0 where there is none. @param text not empty
[[nodiscard]] std::size_t utf8_size(std::string_view text);

/// A text in UTF-8 with line feeds. UTF-16 is known by its mark, or by the zeros of Latin letters; of other texts each byte that is no UTF-8 is one
/// of Windows-1252. Where no line feed stands, carriage returns end the lines. Zeros at the end, of room that a logger
/// reserved and did not fill, are left out.
[[nodiscard]] std::string as_utf8(std::string bytes);

}  // namespace tiretherm::input
