// SPDX-License-Identifier: BSD-3-Clause
// Tells encodings apart by their bytes.

#include "input/text/encoding.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tiretherm::input {

namespace {

unsigned byte_of(char c) { return static_cast<unsigned char>(c); }

void append_utf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t bits) { text += static_cast<char>(static_cast<unsigned char>(bits)); };
    unsigned more = code < 0x80U ? 0U : code < 0x800U ? 1U : code < 0x10000U ? 2U : 3U;  // bytes of six bits each
    // The first byte begins with as many ones as there are bytes.
    put(more == 0U ? code : (0xFF00U >> (more + 1U) & 0xFFU) | code >> 6U * more);
    while (more-- > 0U) {
        put(0x80U | (code >> 6U * more & 0x3FU));
    }
}

/// Windows-1252 is Latin-1 but for 32 characters.
std::uint32_t code_of_windows(unsigned byte) {
    constexpr std::array<std::uint16_t, 32> others{0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                                   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};
    return byte >= 0x80U && byte < 0xA0U ? others[byte - 0x80U] : byte;
}

std::string from_windows(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size() + bytes.size() / 16);
    while (!bytes.empty()) {
        const std::size_t size = utf8_size(bytes);
        if (size == 0) {
            append_utf8(text, code_of_windows(byte_of(bytes.front())));
        } else {
            text.append(bytes.substr(0, size));
        }
        bytes.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return text;
}

enum class Order { none, low_first, high_first };

/// Whether a text is UTF-16, by its mark or by the zeros beside the letters of its first lines.
Order order_of(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE")) {
        return Order::low_first;
    }
    if (bytes.starts_with("\xFE\xFF")) {
        return Order::high_first;
    }
    // Headings are ASCII for the most part, in whatever language the channels are named.
    const std::size_t looked_at = std::min<std::size_t>(bytes.size() & ~std::size_t{1}, 512);
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < looked_at; ++i) {
        zeros[i % 2] += bytes[i] == '\0' ? 1 : 0;
    }
    // Nearly every second byte, and none of the others.
    const std::size_t most = looked_at / 2 - looked_at / 16;
    return looked_at < 8                      ? Order::none
           : zeros[0] == 0 && zeros[1] > most ? Order::low_first
           : zeros[1] == 0 && zeros[0] > most ? Order::high_first
                                              : Order::none;
}

std::string from_utf16(std::string_view bytes, Order order) {
    const std::size_t low = order == Order::low_first ? 0 : 1;
    const auto unit = [&](std::size_t at) { return byte_of(bytes[at + low]) | byte_of(bytes[at + 1 - low]) << 8U; };
    std::string text;
    text.reserve(bytes.size() / 2);
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        const bool is_first = code >= 0xD800U && code < 0xDC00U && at + 3 < bytes.size();
        if (const std::uint32_t next = is_first ? unit(at + 2) : 0; next >= 0xDC00U && next < 0xE000U) {
            code = 0x10000U + ((code - 0xD800U) << 10U) + (next - 0xDC00U);
            at += 2;
        }
        const bool is_half = code >= 0xD800U && code < 0xE000U;
        if (code != 0xFEFFU) {  // the mark
            append_utf8(text, is_half ? 0xFFFDU : code);
        }
    }
    return text;
}

}  // namespace

std::size_t utf8_size(std::string_view text) {
    const auto byte = [&](std::size_t i) { return byte_of(text[i]); };
    const std::size_t size = byte(0) < 0x80U ? 1 : byte(0) < 0xC2U ? 0 : byte(0) < 0xE0U ? 2 : byte(0) < 0xF0U ? 3 : 4;
    if (size == 0 || byte(0) > 0xF4U || size > text.size()) {
        return 0;
    }
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    // Overlong forms, surrogates and what lies beyond the last plane.
    const bool wrong = size > 2 && ((byte(0) == 0xE0U && byte(1) < 0xA0U) || (byte(0) == 0xEDU && byte(1) > 0x9FU) ||
                                    (byte(0) == 0xF0U && byte(1) < 0x90U) || (byte(0) == 0xF4U && byte(1) > 0x8FU));
    return wrong ? 0 : size;
}

std::string as_utf8(std::string bytes) {
    const Order order = order_of(bytes);
    if (order != Order::none) {
        bytes = from_utf16(bytes, order);
    } else if (std::ranges::any_of(bytes, [](char c) { return byte_of(c) >= 0x80U; })) {
        bytes = from_windows(bytes);
    }
    bytes.resize(bytes.find_last_not_of('\0') + 1);
    // Lines that end with a carriage return alone, as old Macintosh programs write them.
    if (bytes.find('\n') == std::string::npos) {
        std::ranges::replace(bytes, '\r', '\n');
    }
    return bytes;
}

}  // namespace tiretherm::input
