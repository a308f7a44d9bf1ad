// SPDX-License-Identifier: BSD-3-Clause
// Numbers and units as engineers write them.
#pragma once

#include <string>
#include <string_view>

namespace tiretherm::post {

/// "-0.00" as "0.00": a number that is zero in the digits that are shown has no sign.
[[nodiscard]] std::string without_sign_of_zero(std::string number);

/// A number with so many digits behind the point that an interval of this half width shows two of its own.
[[nodiscard]] std::string to_its_digits(double value, double half_width);

/// From here on numbers are written by powers of ten: a column would be as wide as they are large.
inline constexpr double compact_from = 1e9;

/// A number with so many digits behind the point, by powers of ten from `compact_from` on; "-" where it is not finite.
[[nodiscard]] std::string with_decimals(double value, int decimals);

/// A number with the digits that measured numbers of its unit have: none of s and N/rad, three of ratios, one of others.
[[nodiscard]] std::string in_digits_of(std::string_view unit, double value);

/// "47.0 to 48.0", "> 60.0", "< 5.0", "47.0": a measured range, open where an end is not finite.
[[nodiscard]] std::string range_text(std::string_view unit, double low, double high);

/// A unit as engineers write it: "W m-2 K-1" as W/(m2 K), "N-1" as 1/N. One without negative powers stays as it is.
[[nodiscard]] std::string slashed_unit(std::string_view unit);

/// A name of the program as words: "outside_shoulder" as "outside shoulder".
[[nodiscard]] std::string in_words(std::string name);

/// The unit of a difference of two values: K of temperatures in degC.
[[nodiscard]] std::string difference_unit(std::string_view unit);

}  // namespace tiretherm::post
