// SPDX-License-Identifier: BSD-3-Clause
// Bytes as text and back (RFC 4648).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tiretherm::post {

[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);

/// The bytes of such a text; nothing where it is none: another letter, or a length that is no multiple of four.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace tiretherm::post
