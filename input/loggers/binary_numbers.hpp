// SPDX-License-Identifier: BSD-3-Clause
// Little-endian numbers and texts within the bytes of a file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

enum class SampleType : std::uint8_t { uint8, int16, int32, float16, float32, float64 };
/// @returns bytes
[[nodiscard]] std::size_t size_of(SampleType type);

/// Numbers at addresses of a file. The caller has compared them with the size.
class BinaryNumbers {
public:
    explicit BinaryNumbers(std::string_view bytes) : bytes_(bytes) {}

    [[nodiscard]] std::size_t size() const { return bytes_.size(); }
    [[nodiscard]] std::uint16_t unsigned16(std::size_t at) const;
    [[nodiscard]] std::uint32_t unsigned32(std::size_t at) const;
    [[nodiscard]] int signed16(std::size_t at) const { return static_cast<std::int16_t>(unsigned16(at)); }
    /// A text of at most so many bytes, which a zero may end; printable, without blanks round it.
    [[nodiscard]] std::string text(std::size_t at, std::size_t length) const;
    [[nodiscard]] double number(std::size_t at, SampleType type) const;
    /// @returns [count]
    [[nodiscard]] std::vector<double> samples(std::size_t at, std::size_t count, SampleType type) const;

private:
    std::string_view bytes_;
};

/// A number of half precision (IEEE 754 binary16): 1 bit of sign, 5 of exponent, 10 of fraction.
[[nodiscard]] double from_half(std::uint16_t bits);

}  // namespace tiretherm::input
