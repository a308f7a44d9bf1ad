// SPDX-License-Identifier: BSD-3-Clause
// Words for what the readers ask: forms, units, ranges and possible words of each key.
#include "post/reference/case_reference.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "post/report/number_text.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

namespace {

using input::CaseKey;
using input::CaseTable;
using input::KeyForm;
using input::KeyUse;

constexpr std::string_view head =
    "# Case reference\n\n"
    "Every key of a case, a study and a table of measured numbers. This page is written by `tiretherm keys --markdown` "
    "from what\n"
    "the readers of the program ask for; do not edit it. Complete examples are in the [case "
    "library](../cases/README.md), the\n"
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

std::string quantity_text(const KeyUse& use) {
    input::QuantitySpec spec = use.spec;
    spec.unit = use.unit;
    const bool pure = use.unit == "1" || use.unit.empty();
    const input::Dimension what = pure ? input::Dimension{"a number", ""} : input::dimension(use.unit, spec.scale);
    const std::string unit = pure ? "" : slashed_unit(use.unit);
    const std::string range = range_text(spec, unit) + usual_text(spec);
    const std::string kind = what.name.empty() ? "a quantity in " + unit : what.name;
    return range.empty() ? kind : fmt::format("{}, {}", kind, range);
}

std::string form_text(const KeyUse& use) {
    switch (use.form) {
        case KeyForm::mentioned:
        case KeyForm::any:
            return "a value";
        case KeyForm::text:
            return "a text";
        case KeyForm::name:
            return "a name";
        case KeyForm::texts:
            return "a text, or a list of texts";
        case KeyForm::choice:
            return fmt::format("`{}`", fmt::join(use.options, "`, `"));
        case KeyForm::flag:
            return "`true`, `false`";
        case KeyForm::count:
            return fmt::format("a whole number, {} to {}", use.low, use.high);
        case KeyForm::quantity:
            return quantity_text(use);
        case KeyForm::table:
            return "a table";
        case KeyForm::tables:
            return "a list of tables";
    }
    return "";
}

/// All forms in which a key may be written.
std::string value_text(const CaseKey& key) {
    std::vector<std::string> forms;
    int quantities = 0;
    for (const KeyUse& use : key.uses) {
        quantities += use.form == KeyForm::quantity ? 1 : 0;
    }
    for (const KeyUse& use : key.uses) {
        const bool weaker =
            use.form == KeyForm::any || (use.form == KeyForm::text && key.uses.front().form == KeyForm::name);
        if (weaker && key.uses.size() > 1) {
            continue;
        }
        // The unit follows from another key: that of the channel, of the effect's parameter, of the law.
        const std::string text = use.form == KeyForm::quantity && quantities > 1
                                     ? std::string("a quantity, of what it belongs to")
                                     : form_text(use);
        if (std::ranges::find(forms, text) == forms.end()) {
            forms.push_back(text);
        }
    }
    return forms.empty() ? "as described" : fmt::format("{}", fmt::join(forms, "; or "));
}

std::string required_text(const CaseKey& key) {
    return key.required ? "required" : key.sometimes_required ? "sometimes" : "";
}

std::string variants_text(const CaseKey& key) {
    return key.variants.empty() ? "" : fmt::format(" For `{}`.", fmt::join(key.variants, "`, `"));
}

}  // namespace

std::string heading_of(const CaseTable& table) {
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
    return fmt::format(fmt::runtime(table.is_list ? "[[{}]]" : "[{}]"), table.path);
}

std::string case_reference_markdown(const std::vector<CaseTable>& tables) {
    std::string text(head);
    for (const CaseTable& table : tables) {
        const std::string heading = heading_of(table);
        const bool is_code = heading.starts_with('[');
        text += fmt::format("\n## {0}{1}{0}\n\n{2}\n\n", is_code ? "`" : "", heading, table.sentence);
        text += "| key | value | | meaning |\n|---|---|---|---|\n";
        for (const CaseKey& key : table.keys) {
            text += fmt::format("| `{}` | {} | {} | {}{} |\n", key.key, value_text(key), required_text(key),
                                key.sentence, variants_text(key));
        }
    }
    return text;
}

std::string case_table_text(const CaseTable& table) {
    std::string text = heading_of(table) + "\n" + wrap(table.sentence, 4);
    for (const CaseKey& key : table.keys) {
        const std::string needed = required_text(key);
        text += fmt::format("\n  {}{}\n", key.key, needed.empty() ? "" : fmt::format(" ({})", needed));
        text += wrap(value_text(key), 4) + wrap(key.sentence + variants_text(key), 4);
    }
    return text;
}

std::string case_tables_text(const std::vector<CaseTable>& tables) {
    Table rows({true, true});
    for (const CaseTable& table : tables) {
        const std::size_t stop = table.sentence.find_first_of(".:");
        rows.add({heading_of(table), table.sentence.substr(0, stop)});
    }
    return rows.text(2);
}

}  // namespace tiretherm::post
