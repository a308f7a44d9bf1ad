// SPDX-License-Identifier: BSD-3-Clause
// Stores the known keys, requires those without which there is no force, and warns of keys that the version does not
// use.

#include "input/tire_property_file/tir_coefficients.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/tire_property_file/tir_keys.hpp"

namespace tiretherm::input {

namespace {

using tir::Coefficient;
using tir::coefficients;
using tir::other_scaling_factors;
using tir::Use;

bool used(Use use, const tir::Law& law) {
    return use == Use::both || (use == Use::only_61) == (law.version == physics::MagicFormulaVersion::mf61);
}

/// P or R, a letter of `families`, X or Y, a digit: PKY3 is of the families CDEKHV of pure slip.
bool is_of(std::string_view key, char first, std::string_view families) {
    return key.size() > 3 && key[0] == first && families.find(key[1]) != std::string_view::npos &&
           (key[2] == 'X' || key[2] == 'Y') && std::isdigit(static_cast<unsigned char>(key[3])) != 0;
}

/// A key that might have been meant for pure slip: of its families, or in its sections and of no other part.
bool concerns_pure_slip(const TirLines::Entry& entry) {
    if (entry.section == "SCALING_COEFFICIENTS") {
        return std::find(other_scaling_factors.begin(), other_scaling_factors.end(), entry.key) ==
               other_scaling_factors.end();
    }
    const bool in_section = entry.section == "LONGITUDINAL_COEFFICIENTS" || entry.section == "LATERAL_COEFFICIENTS";
    const bool other = is_of(entry.key, 'R', "BCEHV") || is_of(entry.key, 'P', "PT");
    return is_of(entry.key, 'P', "CDEKHV") || (in_section && !other);
}

void check_key(const TirLines& lines, const TirLines::Entry& entry, const tir::Law& law, InputErrors& errors) {
    const auto* const known = std::ranges::find(coefficients, entry.key, &Coefficient::key);
    if (known == std::end(coefficients)) {
        if (concerns_pure_slip(entry)) {
            const std::string near = nearest(entry.key, names_of(std::span(coefficients), &Coefficient::key));
            errors.warn(entry.key_place, "{} is unknown and not used{}", entry.key,
                        near.empty() ? "" : fmt::format("; did you mean {}?", near));
        }
    } else if (const TirLines::Entry* first = lines.find(entry.key); first != &entry) {
        errors.add(entry.key_place,
                   fmt::format("{} stands in two sections, first at {}", entry.key, errors.spell(first->place)),
                   "remove one of the lines");
    } else if (!used(known->use, law)) {
        errors.warn(entry.key_place, "{} is not used by MF {}, the version of the file", entry.key,
                    known->use == Use::only_52 ? "6.1" : "5.2");
    }
}

void check_bounds(const TirLines::Entry& entry, double value, const tir::Bounds& bounds, InputErrors& errors) {
    const double size = bounds.by_magnitude ? std::abs(value) : value;
    if (size < bounds.low || size > bounds.high) {
        errors.add(entry.place,
                   fmt::format("{} is {}; {:g} to {:g}{} are possible", entry.key, entry.value, bounds.low, bounds.high,
                               bounds.by_magnitude ? " of either sign" : ""),
                   fmt::format("correct it: {} is {}", entry.key, bounds.what));
    }
}

/// With a peak D below 0 the slope B = K / (C D) changes its sign as well, so that the force D sin(C atan(B x ...)) is that of
/// -D: such a file means the friction's size.
void turn_negative_peak(const TirLines& lines, std::string_view key, double& friction, double& with_load,
                        InputErrors& errors) {
    if (friction < 0.0) {
        friction = -friction;
        with_load = -with_load;
        errors.warn(lines.find(key)->place,
                    "{} is below 0: the force does not depend on the sign of D, and is that of {:g}", key, friction);
    }
}

}  // namespace

void require_tir_key(const TirLines& lines, const SourceLocation& whole, std::string_view key, std::string_view section,
                     InputErrors& errors) {
    if (lines.find(key) == nullptr) {
        errors.add(whole, fmt::format("{} is missing", key), fmt::format("write {} = a number in [{}]", key, section));
    }
}

void read_tir_coefficients(const TirLines& lines, const SourceLocation& whole, physics::MagicFormula& law,
                           InputErrors& errors) {
    for (const Coefficient& one : coefficients) {
        if (const std::optional<double> value = lines.number(one.key, errors)) {
            check_bounds(*lines.find(one.key), *value, one.bounds, errors);
            one.at(law) = used(one.use, law) ? *value : one.at(law);
        }
    }
    turn_negative_peak(lines, "PDX1", law.pDx1, law.pDx2, errors);
    turn_negative_peak(lines, "PDY1", law.pDy1, law.pDy2, errors);
    bool longitudinal = false;
    for (const TirLines::Entry& entry : lines.entries()) {
        if (entry.section == "UNITS" || entry.value.empty()) {
            continue;
        }
        check_key(lines, entry, law, errors);
        longitudinal = longitudinal || (is_of(entry.key, 'P', "CDEKHV") && entry.key[2] == 'X');
    }
    if (longitudinal) {
        for (const std::string_view key : {"PCX1", "PDX1", "PKX1"}) {
            require_tir_key(lines, whole, key, "LONGITUDINAL_COEFFICIENTS", errors);
        }
    } else {
        errors.warn(whole, "there are no longitudinal coefficients: the longitudinal force is 0");
    }
    for (const std::string_view key : {"PCY1", "PDY1", "PKY1", "PKY2"}) {
        require_tir_key(lines, whole, key, "LATERAL_COEFFICIENTS", errors);
    }
}

}  // namespace tiretherm::input
