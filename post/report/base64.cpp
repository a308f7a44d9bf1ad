// SPDX-License-Identifier: BSD-3-Clause
// Three bytes are four letters of six bits each; the last group is filled with '='.
#include "post/report/base64.hpp"

#include <algorithm>

namespace tiretherm::post {

namespace {

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64(std::span<const unsigned char> bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t b = 0; b < 3; ++b) {
            group = group << 8U | (b < left ? bytes[i + b] : 0U);
        }
        for (std::size_t b = 0; b < 4; ++b) {
            text += b <= left ? letters[group >> (18U - 6U * b) & 63U] : '=';
        }
    }
    return text;
}

std::optional<std::string> from_base64(std::string_view text) {
    if (text.size() % 4 != 0) {
        return std::nullopt;
    }
    const std::size_t fill = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    unsigned group = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t value = i + fill >= text.size() ? 0 : letters.find(text[i]);
        if (value == std::string_view::npos) {
            return std::nullopt;
        }
        group = group << 6U | static_cast<unsigned>(value);
        if (i % 4 == 3) {
            for (const unsigned shift : {16U, 8U, 0U}) {
                bytes += static_cast<char>(group >> shift & 255U);
            }
            group = 0;
        }
    }
    bytes.resize(bytes.size() - fill);
    return bytes;
}

}  // namespace tiretherm::post
