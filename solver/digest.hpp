// SPDX-License-Identifier: BSD-3-Clause
// A hash of 128 bits over numbers and texts, by which results that were kept are found again.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tiretherm::solver {

/// A hash over whatever was added, in that order; numbers by their bits. Two lanes of multiply and xor, each with a final
/// mix: no defence against an enemy, but two different requests do not meet by chance.
class Digest {
public:
    using Value = std::array<std::uint64_t, 2>;

    template <typename Number>
    requires(std::is_arithmetic_v<Number> || std::is_enum_v<Number>) void add(Number number) {
        if constexpr (std::is_floating_point_v<Number>) {
            mix(std::bit_cast<std::uint64_t>(static_cast<double>(number)));
        } else {
            mix(static_cast<std::uint64_t>(number));
        }
    }
    void add(std::string_view text) {
        add(text.size());
        for (std::size_t at = 0; at < text.size(); at += 8) {
            std::uint64_t word = 0;
            for (std::size_t i = at; i < text.size() && i < at + 8; ++i) {
                word = word << 8U | static_cast<unsigned char>(text[i]);
            }
            mix(word);
        }
    }
    template <typename Number>
    requires(std::is_arithmetic_v<Number>) void add(std::span<const Number> numbers) {
        add(numbers.size());
        for (const Number number : numbers) {
            add(number);
        }
    }
    template <typename Number>
    void add(const std::vector<Number>& values) {
        add(values.size());
        for (const Number& value : values) {
            add(value);
        }
    }
    void add(const Value& other) {
        mix(other[0]);
        mix(other[1]);
    }

    [[nodiscard]] Value value() const { return {last(lanes_[0]), last(lanes_[1])}; }

private:
    void mix(std::uint64_t word) {
        lanes_[0] = std::rotl((lanes_[0] ^ word) * 0x9E3779B97F4A7C15U, 29) + 0x165667B19E3779F9U;
        lanes_[1] = std::rotl((lanes_[1] + word) * 0xC2B2AE3D27D4EB4FU, 33) ^ 0x27D4EB2F165667C5U;
    }
    static std::uint64_t last(std::uint64_t x) {
        x = (x ^ (x >> 33U)) * 0xFF51AFD7ED558CCDU;
        x = (x ^ (x >> 33U)) * 0xC4CEB9FE1A85EC53U;
        return x ^ (x >> 33U);
    }

    std::array<std::uint64_t, 2> lanes_{0x243F6A8885A308D3U, 0x13198A2E03707344U};
};

}  // namespace tiretherm::solver
