#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/validation/validation_reader.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

Wanted wanted_of(const Reckoning& reckoning, solver::Quantity quantity) {
    switch (reckoning.meaning) {
        case Meaning::value:
            return quantity == solver::Quantity::temperature ? wanted::temperature
                                                             : Wanted{.unit = solver::unit_of(quantity)};
        case Meaning::difference:
            return {.unit = solver::unit_of(quantity), .scale = Scale::difference};
        case Meaning::ratio:
            return {.unit = "1"};
        case Meaning::time:
            return {.unit = "s"};
    }
    return {};
}

void read_range(Section& section, const Wanted& wanted, ValidationNumber& number) {
    const std::vector<Word> ends = section.texts("range");
    if (ends.size() != 2) {
        section.mistake("range", "a range has two ends",
                        fmt::format("write range = [{0}, {0}]", spell_example(wanted)));
        return;
    }
    const std::array judged{quantity(ends[0].text, wanted, "range"), quantity(ends[1].text, wanted, "range")};
    for (std::size_t i = 0; i < 2; ++i) {
        if (judged[i].fault) {
            section.mistakes().add(ends[i].place, *judged[i].fault);
        }
    }
    number.low = judged[0].value;
    number.high = judged[1].value;
    if (!judged[0].fault && !judged[1].fault && number.low > number.high) {
        section.mistake("range", "the range begins with its upper end", "swap the two ends");
    }
}

/// Standard uncertainty: one quantity, or its independent parts by name.
void read_uncertainty(Section& section, Wanted wanted, ValidationNumber& number) {
    wanted.scale = Scale::difference;
    wanted.low = 0.0;
    wanted.above = true;
    wanted.usual_low = -std::numeric_limits<double>::infinity();
    wanted.usual_high = std::numeric_limits<double>::infinity();
    const Node* node = section.value("uncertainty");
    if (node != nullptr && node->kind == Node::Kind::table) {
        Section parts = section.section("uncertainty");
        for (const Entry& part : node->entries) {
            number.uncertainty.emplace_back(part.key, parts.quantity(part.key, wanted).value_or(0.0));
        }
        if (node->entries.empty()) {
            section.mistake("uncertainty", "the uncertainty has no part", "write { sensor = ... }");
        }
        return;
    }
    const bool needed = section.has("value") || section.has("range");
    if (const auto one = section.quantity("uncertainty", wanted, needed ? Need::required : Need::optional)) {
        number.uncertainty.emplace_back("whole", *one);
    }
}

void read_measured(Section& section, const Wanted& wanted, ValidationNumber& number) {
    constexpr std::array<const char*, 4> keys{"value", "range", "above", "below"};
    section.know({"value", "range", "above", "below"});
    const char* given = nullptr;
    for (const char* key : keys) {
        if (section.has(key) && given != nullptr) {
            section.mistake(key, fmt::format("both {} and {} are given", given, key), "keep one of them");
        }
        given = section.has(key) ? key : given;
    }
    number.is_measured = given != nullptr;
    if (const std::optional<double> value = section.quantity("value", wanted)) {
        number.low = number.high = *value;
    }
    if (section.has("range")) {
        read_range(section, wanted, number);
    }
    number.low = section.quantity("above", wanted).value_or(number.low);
    number.high = section.quantity("below", wanted).value_or(number.high);
    read_uncertainty(section, wanted, number);
}

}  // namespace

ValidationNumber read_number(Section& section, CaseShelf& shelf) {
    ValidationNumber number;
    number.id = section.text("id", Need::required).value_or("");
    number.what = section.text("what", Need::required).value_or("");
    Reckoning reckoning = read_reckoning(section, shelf);
    number.meaning = reckoning.meaning;
    if (reckoning.quantity) {
        number.quantity = *reckoning.quantity;
        read_measured(section, wanted_of(reckoning, number.quantity), number);
    } else {
        section.know({"value", "range", "above", "below", "uncertainty"});
    }
    number.source = section.text("source", number.is_measured ? Need::required : Need::optional).value_or("");
    number.models = std::move(reckoning.models);
    return number;
}

}  // namespace tiretherm::input
