// SPDX-License-Identifier: BSD-3-Clause
// Assembles numbers byte by byte, whatever the machine's order is.

#include "input/loggers/binary_numbers.hpp"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "input/text/characters.hpp"
#include "input/text/encoding.hpp"

namespace tiretherm::input {

namespace {

/// The bytes from an address on as an integer, the lowest first.
template <typename Integer>
Integer assemble(std::string_view bytes, std::size_t at) {
    Integer value = 0;
    for (std::size_t i = sizeof(Integer); i-- > 0;) {
        value = static_cast<Integer>(value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// Without it, an Integer of 16 bits is promoted.
std::uint16_t assemble16(std::string_view bytes, std::size_t at) {
    return static_cast<std::uint16_t>(static_cast<unsigned char>(bytes[at]) |
                                      static_cast<unsigned>(static_cast<unsigned char>(bytes[at + 1])) << 8U);
}

}  // namespace

double from_half(std::uint16_t bits) {
    const double sign = (bits & 0x8000U) != 0 ? -1.0 : 1.0;
    const int exponent = (bits >> 10U) & 0x1F;
    const int fraction = bits & 0x3FF;
    if (exponent == 31) {
        return fraction == 0 ? sign * std::numeric_limits<double>::infinity()
                             : std::numeric_limits<double>::quiet_NaN();
    }
    return exponent == 0 ? sign * std::ldexp(fraction, -24) : sign * std::ldexp(fraction + 1024, exponent - 25);
}

std::size_t size_of(SampleType type) {
    constexpr std::array<std::size_t, 6> sizes{1, 2, 4, 2, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::uint16_t BinaryNumbers::unsigned16(std::size_t at) const {
    assert(at + 2 <= bytes_.size());
    return assemble16(bytes_, at);
}

std::uint32_t BinaryNumbers::unsigned32(std::size_t at) const {
    assert(at + 4 <= bytes_.size());
    return assemble<std::uint32_t>(bytes_, at);
}

std::string BinaryNumbers::text(std::size_t at, std::size_t length) const {
    assert(at + length <= bytes_.size());
    std::string_view field = bytes_.substr(at, length);
    field = field.substr(0, field.find('\0'));
    return std::string(trim(printable(as_utf8(std::string(field)))));
}

double BinaryNumbers::number(std::size_t at, SampleType type) const {
    switch (type) {
        case SampleType::uint8:
            return static_cast<unsigned char>(bytes_[at]);
        case SampleType::int16:
            return static_cast<std::int16_t>(assemble16(bytes_, at));
        case SampleType::int32:
            return static_cast<std::int32_t>(assemble<std::uint32_t>(bytes_, at));
        case SampleType::float16:
            return from_half(assemble16(bytes_, at));
        case SampleType::float32:
            return static_cast<double>(std::bit_cast<float>(assemble<std::uint32_t>(bytes_, at)));
        case SampleType::float64:
            break;
    }
    return std::bit_cast<double>(assemble<std::uint64_t>(bytes_, at));
}

std::vector<double> BinaryNumbers::samples(std::size_t at, std::size_t count, SampleType type) const {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] = number(at + i * size_of(type), type);
    }
    return values;
}

}  // namespace tiretherm::input
