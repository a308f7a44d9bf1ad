// SPDX-License-Identifier: BSD-3-Clause
// Words for the descriptions of keys: forms, units, ranges and possible words.
#include "post/reference/case_reference.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/report/number_text.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

namespace {

using input::Key;
using input::KeyForm;
using input::Need;
using input::TableKeys;

constexpr std::string_view head =
    "# Case reference\n\n"
    "Every key of a case, a study and a table of measured numbers. This page is written by `tiretherm keys --markdown` "
    "from the\n"
    "descriptions of the keys; do not edit it. Complete examples are in the [case library](../cases/README.md), the\n"
    "parameters of the effects in [effects.md](effects.md).\n\n"
    "Quantities are texts with a unit (`\"8 mm\"`, `\"100 km/h\"`), in any unit of the right kind; pure numbers may be "
    "written 0.6,\n"
    "`\"0.6\"` or `\"60 %\"`. Ranges are given in SI units. *Required* keys must be given; \"sometimes\" means for "
    "some kinds, or\n"
    "beside some other key. A value outside of its usual range is only warned of. Unknown keys are errors.\n";

std::string number(double value) { return fmt::format("{:g}", value); }

std::string range_text(const input::QuantitySpec& spec, const std::string& unit) {
    const bool low = std::isfinite(spec.low);
    const bool high = std::isfinite(spec.high);
    std::string text;
    if (low && high) {
        text = fmt::format("{}{} to {}", spec.above ? "above " : "", number(spec.low), number(spec.high));
    } else if (low) {
        text = fmt::format("{} {}", spec.above ? "above" : "from", number(spec.low));
    } else if (high) {
        text = fmt::format("up to {}", number(spec.high));
    }
    return text.empty() || unit.empty() ? text : text + " " + unit;
}

std::string usual_text(const input::QuantitySpec& spec) {
    return std::isfinite(spec.usual_low) && std::isfinite(spec.usual_high)
               ? fmt::format("; usual: {} to {}", number(spec.usual_low), number(spec.usual_high))
               : "";
}

std::string quantity_text(const input::QuantitySpec& spec) {
    const bool pure = spec.unit == "1" || spec.unit.empty();
    const input::Dimension what = pure ? input::Dimension{"a number", ""} : input::dimension(spec.unit, spec.scale);
    const std::string unit = pure ? "" : slashed_unit(spec.unit);
    const std::string range = range_text(spec, unit) + usual_text(spec);
    const std::string kind = what.name.empty() ? "a quantity in " + unit : what.name;
    return range.empty() ? kind : fmt::format("{}, {}", kind, range);
}

/// How a value may be written.
std::string value_text(const Key& key) {
    switch (key.form) {
        case KeyForm::value:
            return "as described";
        case KeyForm::text:
            return "a text";
        case KeyForm::name:
            return "a name";
        case KeyForm::texts:
            return "a text, or a list of texts";
        case KeyForm::choice:
            return fmt::format("`{}`", fmt::join(key.words, "`, `"));
        case KeyForm::flag:
            return "`true`, `false`";
        case KeyForm::count:
            return fmt::format("a whole number, {} to {}", key.low, key.high);
        case KeyForm::quantity:
            return quantity_text(key.spec);
        case KeyForm::quantity_of_owner:
            return "a quantity, of what it belongs to";
        case KeyForm::quantity_or_text:
            return quantity_text(key.spec) + "; or a text";
        case KeyForm::law:
            return "a table; or " + quantity_text(key.spec);
        case KeyForm::table:
            return "a table";
        case KeyForm::tables:
            return "a list of tables";
    }
    return "";
}

std::string required_text(const Key& key) {
    return key.need == Need::required ? "required" : key.need == Need::sometimes ? "sometimes" : "";
}

std::string kinds_text(const Key& key) {
    if (key.of_kinds.empty()) {
        return "";
    }
    std::string kinds(key.of_kinds);
    for (std::size_t blank = 0; (blank = kinds.find(' ', blank)) != std::string::npos; blank += 4) {
        kinds.replace(blank, 1, "`, `");
    }
    return fmt::format(" For `{}`.", kinds);
}

}  // namespace

std::string heading_of(const TableKeys& table) {
    if (table.path.empty()) {
        return "top of a case";
    }
    if (table.path == "study:") {
        return "top of a study";
    }
    if (table.path == "table:") {
        return "top of a table of measured numbers";
    }
    if (table.path == "law") {
        return "a law of temperature";
    }
    return fmt::format(fmt::runtime(table.form == input::TableForm::list ? "[[{}]]" : "[{}]"), table.path);
}

std::string case_reference_markdown(const std::vector<TableKeys>& tables) {
    std::string text(head);
    for (const TableKeys& table : tables) {
        const std::string heading = heading_of(table);
        const bool is_code = heading.starts_with('[');
        text += fmt::format("\n## {0}{1}{0}\n\n{2}\n\n", is_code ? "`" : "", heading, table.sentence);
        text += "| key | value | | meaning |\n|---|---|---|---|\n";
        for (const Key& key : table.keys) {
            text += fmt::format("| `{}` | {} | {} | {}{} |\n", key.name, value_text(key), required_text(key),
                                key.sentence, kinds_text(key));
        }
    }
    return text;
}

std::string case_table_text(const TableKeys& table) {
    std::string text = heading_of(table) + "\n" + wrap(std::string(table.sentence), 4);
    for (const Key& key : table.keys) {
        const std::string needed = required_text(key);
        text += fmt::format("\n  {}{}\n", key.name, needed.empty() ? "" : fmt::format(" ({})", needed));
        text += wrap(value_text(key), 4) + wrap(std::string(key.sentence) + kinds_text(key), 4);
    }
    return text;
}

std::string case_tables_text(const std::vector<TableKeys>& tables) {
    TextTable rows({true, true});
    for (const TableKeys& table : tables) {
        const std::size_t stop = table.sentence.find_first_of(".:");
        rows.add({heading_of(table), std::string(table.sentence.substr(0, stop))});
    }
    return rows.text(2);
}

}  // namespace tiretherm::post
