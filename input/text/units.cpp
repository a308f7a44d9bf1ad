// SPDX-License-Identifier: BSD-3-Clause
// Calls UDUNITS-2 behind a lock, with a cache of parsed units. The only file that includes it.

#include "input/text/units.hpp"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include <udunits2.h>

#include "input/text/unit_text.hpp"

namespace tiretherm::input {

namespace {

struct Freed {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, Freed>;

struct Parsed {
    Unit unit;
    std::string signature;
};

/// Definition in base units without the factor and the offset: "0.2777 m.s-1" gives "m.s-1".
std::string signature_of(const ut_unit* unit) {
    std::array<char, 256> buffer{};
    const int length = ut_format(unit, buffer.data(), buffer.size() - 1, UT_ASCII | UT_DEFINITION);
    if (length < 0) {
        return {};
    }
    std::string text(buffer.data(), static_cast<std::size_t>(length));
    if (const std::size_t shift = text.find(" @ "); shift != std::string::npos) {
        text.resize(shift);
    }
    if (const std::size_t blank = text.find(' '); blank != std::string::npos) {
        text = text.substr(blank + 1);
    }
    // A logarithmic unit has no product: "lg(re 0.001 m2.kg.s-3)" is cut within its brackets.
    return text.find_first_of("()") == std::string::npos ? text : std::string();
}

/// UDUNITS keeps its state in globals, so one owner and one lock.
class UnitSystem {
public:
    static UnitSystem& get() {
        static UnitSystem system;
        return system;
    }

    /// A unit without handle is none.
    const Parsed& find(const std::string& text) {
        const auto [place, is_new] = parsed_.try_emplace(text);
        if (is_new) {
            place->second.unit.reset(ut_parse(system_, text.c_str(), UT_UTF8));
            if (place->second.unit) {
                place->second.signature = signature_of(place->second.unit.get());
            }
        }
        return place->second;
    }

    std::mutex lock;

private:
    UnitSystem() {
        ut_set_error_message_handler(ut_ignore);
        system_ = ut_read_xml(nullptr);
        if (system_ == nullptr) {
            throw std::runtime_error(
                "the units' data base of UDUNITS cannot be read: is the package libudunits2-data "
                "installed, and UDUNITS2_XML_PATH unset or right?");
        }
    }

    ut_system* system_ = nullptr;
    std::map<std::string, Parsed> parsed_;
};

double convert(const ut_unit* from, const ut_unit* to, double value) {
    const std::unique_ptr<cv_converter, decltype(&cv_free)> converter(
        ut_get_converter(const_cast<ut_unit*>(from), const_cast<ut_unit*>(to)), cv_free);
    return cv_convert_double(converter.get(), value);
}

/// Ratio of two units of one dimension, offsets left aside: a product with another unit has none.
double ratio(const ut_unit* from, const ut_unit* to, const ut_unit* other) {
    const Unit from_product(ut_multiply(from, other));
    const Unit to_product(ut_multiply(to, other));
    return convert(from_product.get(), to_product.get(), 1.0);
}

}  // namespace

std::string signature(std::string_view unit) {
    UnitSystem& system = UnitSystem::get();
    const std::lock_guard guard(system.lock);
    return system.find(spelt_out(unit)).signature;
}

std::variant<Conversion, UnitError> conversion(std::string_view written, std::string_view wanted, Scale scale) {
    if (written.starts_with(turned_sign)) {
        std::variant<Conversion, UnitError> turned = conversion(written.substr(turned_sign.size()), wanted, scale);
        if (auto* found = std::get_if<Conversion>(&turned)) {
            found->factor = -found->factor;
        }
        return turned;
    }
    const std::string text = spelt_out(written);
    if (has_number(text)) {
        return UnitError::number_inside;
    }
    UnitSystem& system = UnitSystem::get();
    const std::lock_guard guard(system.lock);
    const Parsed& from = system.find(text);
    const Parsed& to = system.find(std::string(wanted));
    // The wanted unit stands in the program, so that a wrong one is an error of the program and not of the user.
    if (to.signature.empty()) {
        throw std::logic_error("\"" + std::string(wanted) + "\" is not a unit of UDUNITS");
    }
    if (from.signature.empty()) {
        return UnitError::unknown;
    }
    if (from.signature != to.signature) {
        return UnitError::other_dimension;
    }
    const ut_unit* metre = system.find("m").unit.get();
    const Conversion result{.factor = ratio(from.unit.get(), to.unit.get(), metre),
                            .offset = convert(from.unit.get(), to.unit.get(), 0.0)};
    return scale == Scale::absolute ? result : Conversion{.factor = result.factor, .offset = 0.0};
}

}  // namespace tiretherm::input
