// SPDX-License-Identifier: BSD-3-Clause
// Reads [UNITS], the version (FITTYP or PROPERTY_FILE_FORMAT), dimensions, load range and pressures.

#include "input/tire_property_file/tir_file.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "input/text/quantity.hpp"
#include "input/tire_property_file/tir_coefficients.hpp"
#include "input/tire_property_file/tir_lines.hpp"

namespace tiretherm::input {

namespace {

using Version = physics::MagicFormulaVersion;

/// Reads one file; every function reports what is wrong with its part.
class TirReader {
public:
    TirReader(const TextFile& file, InputErrors& errors)
        : lines_(file, errors), whole_{.file = file.number}, errors_(&errors) {}

    [[nodiscard]] TirFile read() {
        read_units();
        read_version();
        read_side();
        read_tir_coefficients(lines_, whole_, tire_.law, *errors_);
        read_dimensions();
        read_pressures();
        return tire_;
    }

private:
    using Entry = TirLines::Entry;

    /// Factor to SI of a unit of [UNITS]; 1 where the file names none. @param usual word for the remedy
    double factor(std::string_view key, std::string_view si, std::string_view usual) {
        const Entry* entry = lines_.find(key, "UNITS");
        if (entry == nullptr) {
            return 1.0;
        }
        // Files write 'Newton' and 'NEWTON'; the units' data base knows newton, and N.
        std::string word = entry->value;
        std::transform(word.begin(), word.end(), word.begin(),
                       [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
        const QuantitySpec spec{.unit = si};
        const std::string subject = fmt::format("{} is '{}'", key, entry->value);
        UnitRead read = read_unit(word, spec, subject);
        // Some units live by their capitals: MPa in small letters is none.
        if (read.error && word != entry->value) {
            read = read_unit(entry->value, spec, subject);
        }
        if (read.error) {
            errors_->add(entry->place, read.error->what, fmt::format("write a unit, such as '{}'", usual));
        }
        return read.conversion.factor;
    }

    void read_units() {
        length_ = factor("LENGTH", "m", "meter");
        force_ = factor("FORCE", "N", "newton");
        time_ = factor("TIME", "s", "second");
        (void)factor("MASS", "kg", "kg");  // no mass is read, but a wrong word is an error all the same
        if (factor("ANGLE", "rad", "radian") != 1.0) {
            errors_->warn(lines_.find("ANGLE", "UNITS")->place,
                          "the coefficients of the Magic Formula are taken per radian nevertheless");
        }
    }

    void read_version() {
        static constexpr std::string_view supported = "supported are 5, 6 and 21 (MF 5.2), 61 and 62 (MF 6.1)";
        const Entry* entry = lines_.find("FITTYP");
        if (entry == nullptr) {
            const Entry* format = lines_.find("PROPERTY_FILE_FORMAT");
            if (format == nullptr || format->value != "PAC2002") {
                errors_->add(whole_, "FITTYP is missing", fmt::format("write FITTYP in [MODEL]; {}", supported));
            }
            return;
        }
        const std::optional<Number> number = leading_number(entry->value);
        const double value = number && number->rest.empty() ? number->value : std::nan("");
        if (value == 61.0 || value == 62.0) {
            tire_.law.version = Version::mf61;
        } else if (value != 5.0 && value != 6.0 && value != 21.0) {
            errors_->add(entry->place, fmt::format("FITTYP {} is not supported", entry->value), std::string(supported));
        }
    }

    void read_side() {
        const Entry* entry = lines_.find("TYRESIDE");
        if (entry == nullptr) {
            return;
        }
        const std::string first = entry->value.substr(0, 1);
        tire_.is_left = first == "L" || first == "l";
        if (!tire_.is_left && first != "R" && first != "r") {
            errors_->warn(entry->place,
                          fmt::format("TYRESIDE is {}, neither LEFT nor RIGHT: the tire is taken for one on the right",
                                      entry->value));
        }
    }

    /// A size between two that tires have, in SI units. @param unit_key of [UNITS] that it is in
    void size(std::string_view key, double to_si, std::string_view unit_key, const QuantitySpec& possible,
              double& target) {
        const std::optional<double> value = lines_.number(key, *errors_);
        if (!value) {
            return;
        }
        target = *value * to_si;
        if (target < possible.low || target > possible.high) {
            errors_->add(lines_.find(key)->place,
                         fmt::format("{} is {:.3g} {}; {:g} to {:g} {} are possible", key, target, possible.unit,
                                     possible.low, possible.high, possible.unit),
                         fmt::format("correct it, or {} in [UNITS]", unit_key));
        }
    }

    void read_dimensions() {
        require_tir_key(lines_, whole_, "UNLOADED_RADIUS", "DIMENSION", *errors_);
        require_tir_key(lines_, whole_, "WIDTH", "DIMENSION", *errors_);
        require_tir_key(lines_, whole_, "FNOMIN", "VERTICAL", *errors_);
        size("UNLOADED_RADIUS", length_, "LENGTH", {.unit = "m", .low = 0.005, .high = 2.5}, tire_.unloaded_radius);
        size("WIDTH", length_, "LENGTH", {.unit = "m", .low = 0.001, .high = 2.0}, tire_.width);
        size("FNOMIN", force_, "FORCE", {.unit = "N", .low = 10.0, .high = 1e6}, tire_.law.nominal_load);
        size("LONGVL", length_ / time_, "LENGTH", {.unit = "m/s", .low = 0.1, .high = 200.0},
             tire_.law.reference_speed);
        const std::optional<double> low = lines_.number("FZMIN", *errors_);
        const std::optional<double> high = lines_.number("FZMAX", *errors_);
        if (low && high && *low >= *high) {
            errors_->add(lines_.find("FZMAX")->place,
                         fmt::format("FZMAX is {}, not above FZMIN = {}", lines_.find("FZMAX")->value,
                                     lines_.find("FZMIN")->value));
        }
        if (low && high) {
            tire_.vertical_range = {*low * force_, *high * force_};
        }
    }

    /// NOMPRES, about which the terms of the pressure count, and INFLPRES, the pressure where a case gives none.
    void read_pressures() {
        const double pascal = force_ / (length_ * length_);
        static constexpr QuantitySpec possible{.unit = "Pa", .low = 1e4, .high = 3e6};
        physics::MagicFormula& law = tire_.law;
        size("NOMPRES", pascal, "FORCE and LENGTH", possible, law.nominal_pressure);
        size("INFLPRES", pascal, "FORCE and LENGTH", possible, law.own_pressure);
        const auto is_term = [&](const Entry& entry) {
            return (entry.key.starts_with("PPX") || entry.key.starts_with("PPY")) &&
                   lines_.number(entry.key, *errors_).value_or(0.0) != 0.0;
        };
        const auto term = std::ranges::find_if(lines_.entries(), is_term);
        if (law.version == Version::mf61 && law.nominal_pressure == 0.0 && term != lines_.entries().end()) {
            errors_->warn(term->place, "{} is not used, as no term of the pressure: NOMPRES is missing", term->key);
        }
    }

    TirLines lines_;
    SourceLocation whole_;
    InputErrors* errors_;
    TirFile tire_;
    double length_ = 1.0;
    double force_ = 1.0;
    double time_ = 1.0;
};

}  // namespace

physics::MagicFormula TirFile::law_on_the_right() const {
    // F'(alpha, gamma) = -F(-alpha, -gamma): what is odd in neither changes its sign.
    physics::MagicFormula turned = law;
    const double sign = is_left ? -1.0 : 1.0;
    for (double* number : {&turned.pHy1, &turned.pHy2, &turned.pVy1, &turned.pVy2, &turned.pEy3}) {
        *number *= sign;
    }
    return turned;
}

std::optional<TirFile> read_tir_file(const std::filesystem::path& path, const SourceLocation& mentioned,
                                     InputErrors& errors) {
    const std::size_t before = errors.count();
    const std::optional<TextFile> text = read_text(path, mentioned, errors);
    if (!text) {
        return std::nullopt;
    }
    const TirFile tire = TirReader(*text, errors).read();
    return errors.count() == before ? std::optional(tire) : std::nullopt;
}

}  // namespace tiretherm::input
