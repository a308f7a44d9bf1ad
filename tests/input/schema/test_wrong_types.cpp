// SPDX-License-Identifier: BSD-3-Clause
// Every key that a reader knows, in every table where it stands, with a value of every type in its place.
#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "input/measurements/measured_bench.hpp"
#include "input/schema/all_tables.hpp"
#include "input/schema/files_of_every_kind.hpp"
#include "input/studies/study.hpp"
#include "input/toml/toml_text.hpp"
#include "input/validation/validation.hpp"
#include "physics/effect.hpp"

namespace tiretherm::input {

namespace wrong_types {
namespace {

namespace fs = std::filesystem;

/// Types of TOML as bits, so that a reader may take several. A list of tables is a list, too.
enum Type : unsigned { number = 1, text = 2, boolean = 4, list = 8, table = 16, tables = 32, date = 64, every = 127 };

struct Value {
    std::string_view literal;  ///< empty: the key is left out
    unsigned type;
};
constexpr Value values[] = {{"3", number},        {"1.5", number},      {"-1e300", number},
                            {"nan", number},      {"\"word\"", text},   {"\"\"", text},
                            {"true", boolean},    {"[]", list},         {"[1, \"word\", [], {}]", list},
                            {"{}", table},        {"{ x = 1 }", table}, {"[{ x = 1 }]", tables},
                            {"2024-05-01", date}, {"", every}};

/// Keys whose values readers take as they stand and judge themselves, by hand.
struct Judged {
    std::string_view table;
    std::string_view key;
    unsigned types;
};
constexpr Judged judged[] = {
    {"", "include", text | list},
    {"", "pyrometer", list},
    {"corner", "drive", table},
    {"corner", "effects", table},
    {"corner", "initial", table},
    {"corner", "measured", list},
    {"parameter", "expected", number},
    {"parameter", "high", number},
    {"parameter", "low", number},
    {"parameter", "standard_deviation", number},
    {"run", "corner", table},
    {"run", "drive", table},
    {"run", "frames", table | text},
    {"run", "initial", table},
    {"run", "measured", list},
    {"run", "time", table},
    {"parameter", "layer", text},
    {"parameter", "zone", text},
    {"draw", "high", number},
    {"draw", "low", number},
    {"draw", "mean", number},
    {"draw", "standard_deviation", number},
    {"sensor", "standard_deviation",
     every},  // of a sensor with another error: what it measures, and its unit, is not known
};

/// The types that a key takes as its description says.
unsigned types_of(const Key& key) {
    switch (key.form) {
        case KeyForm::value:
        case KeyForm::quantity_of_owner:
            return 0;
        case KeyForm::text:
        case KeyForm::name:
        case KeyForm::choice:
            return text;
        case KeyForm::texts:
            return text | list;
        case KeyForm::flag:
            return boolean;
        case KeyForm::count:
            return number;
        case KeyForm::quantity:
        case KeyForm::quantity_or_text:
            return key.spec.is_pure() ? number | text : text;
        case KeyForm::law:
            return table | text;
        case KeyForm::table:
            return table;
        case KeyForm::tables:
            return tables | list;
    }
    return 0;
}

/// A table in a document: keys, and places in lists, from the top down.
struct Place {
    std::string name;  ///< as messages call it, without brackets: "mesh.layer"; the document itself is ""
    std::vector<std::pair<std::string, std::size_t>> steps{};
};

TomlValue& found_at(TomlValue& root, const Place& place) {
    TomlValue* node = &root;
    for (const auto& [key, item] : place.steps) {
        node = node->find(key);
        node = node->kind == TomlValue::Kind::array ? &node->items[item] : node;
    }
    return *node;
}

void find_tables(const TomlValue& node, const Place& place, std::vector<Place>& found) {
    found.push_back(place);
    for (const Entry& entry : node.entries) {
        Place below{.name = place.name.empty() ? entry.key : place.name + "." + entry.key, .steps = place.steps};
        below.steps.emplace_back(entry.key, 0);
        if (entry.value.kind == TomlValue::Kind::table) {
            find_tables(entry.value, below, found);
        }
        for (std::size_t i = 0; i < entry.value.items.size(); ++i) {
            if (entry.value.items[i].kind == TomlValue::Kind::table) {
                below.steps.back().second = i;
                find_tables(entry.value.items[i], below, found);
            }
        }
    }
}

/// "mesh section" of [mesh] whose kind is section: its keys are those of the kind.
std::string with_kind(std::string name, std::string_view kind) {
    std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
    return (name.starts_with("the ") ? std::string() : name) + " " + std::string(kind);
}

std::vector<InputError> errors_of(const fs::path& file, const TomlValue& document) {
    if (document.find("number") != nullptr) {
        return read_validation(file).errors;
    }
    if (document.find("case") != nullptr) {
        return read_study(file).errors;
    }
    return read_experiment(file, {}, ReadMode::measured).errors;
}

/// The description of a table of a document; null where its keys are the user's names.
const TableKeys* description_of(const TomlValue& document, const Place& place) {
    const bool at_top = place.name.empty();
    return keys_of_table(!at_top                              ? place.name
                         : document.find("number") != nullptr ? "the table"
                         : document.find("case") != nullptr   ? "the study"
                                                              : "the case");
}

/// The keys of a table of a document, with the types that they take: those that are described, the parameters of an effect,
/// and the names of columns that stand there.
std::map<std::string, unsigned> keys_of(TomlValue document, const Place& place) {
    const TomlValue& node = found_at(document, place);
    const TomlValue* kind = node.find("kind");
    std::map<std::string, unsigned> keys;
    if (const TableKeys* its = description_of(document, place)) {
        for (const Key& key : its->keys) {
            if (key.is_of(kind != nullptr ? kind->text : "") && key.name != "NAME") {
                keys[std::string(key.name)] |= types_of(key);
            }
        }
    } else if (place.name.ends_with(".columns") || place.name.ends_with(".units")) {
        for (const Entry& entry : node.entries) {
            keys[entry.key] = text;
        }
    }
    const physics::Effect* effect =
        place.name.starts_with("effects.") ? physics::find_effect(place.name.substr(8)) : nullptr;
    if (effect != nullptr) {
        for (const physics::ParameterSpec& parameter : effect->parameters) {
            keys[std::string(parameter.key)] = parameter.unit == "1" ? number | text : unsigned{text};
            for (const char* ending : {"_by_patch", "_by_layer", "_by_zone", "_by_channel"}) {
                keys[std::string(parameter.key) + ending] = table;
            }
        }
        for (const auto& choice : effect->choices) {
            keys[std::string(choice.key)] = text | number;  // a word may stand for a value
        }
        for (const auto& values : effect->tables) {
            keys[std::string(values.key)] = table;
        }
    }
    return keys;
}

/// A document with one value replaced, as a file has it, and the line of that value.
struct Changed {
    std::string content;
    int line = 0;
};
Changed changed(TomlValue document, const Place& place, const std::string& key, const Value& value) {
    constexpr std::string_view mark = "\"@@\"";
    TomlValue& at = found_at(document, place);
    at.remove(key);
    if (!value.literal.empty()) {
        at.set(key, toml_text::text_value("@@"));
    }
    Changed result{.content = toml_text::document(document)};
    const std::size_t begin = std::min(result.content.find(mark), result.content.size());
    result.line = 1 + static_cast<int>(std::ranges::count(result.content.substr(0, begin), '\n'));
    if (begin < result.content.size()) {
        result.content.replace(begin, mark.size(), value.literal);
    }
    return result;
}

/// Whether what is wrong says what to do.
bool says_remedy(std::string_view what) {
    return std::ranges::any_of(
        std::initializer_list<std::string_view>{"must be", "is wanted", "not a finite number", "cannot be read"},
        [&](std::string_view words) { return what.find(words) != std::string_view::npos; });
}

/// Tries all values of all keys of a made-up file that no earlier one had.
struct Sweep {
    const Written& written;
    std::set<std::string> done{};
    int keys = 0;
    int calls = 0;

    void through(const MadeUpFile& file) {
        InputErrors errors;
        const fs::path whole =
            written.add("whole.toml", toml_text::document(*read_document(written.folder() / file.name, errors)));
        const TomlValue document = *read_document(whole, errors);
        std::vector<Place> places;
        find_tables(document, {.name = ""}, places);
        for (const Place& place : places) {
            TomlValue copy = document;
            const TomlValue* kind = found_at(copy, place).find("kind");
            const std::string word = kind != nullptr ? kind->text : "";
            for (const auto& [key, types] : keys_of(document, place)) {
                if (done.insert(with_kind(place.name, word) + " " + key).second) {
                    ++keys;
                    try_all(document, place, key, types);
                }
            }
        }
    }

    void try_all(const TomlValue& document, const Place& place, const std::string& key, unsigned types) {
        const auto by_hand =
            std::ranges::find_if(judged, [&](const Judged& one) { return one.table == place.name && one.key == key; });
        types |= by_hand != std::end(judged) ? by_hand->types : 0U;
        for (const Value& value : values) {
            const Changed file = changed(document, place, key, value);
            SCOPED_TRACE("[" + place.name + "] " + key + " = " + std::string(value.literal));
            const std::vector<InputError> errors = errors_of(written.add("case.toml", file.content), document);
            ++calls;
            const auto there = std::ranges::find_if(errors, [&](const InputError& error) {
                return error.line == file.line && error.file.ends_with("case.toml");
            });
            if (value.literal.empty()) {
                continue;  // no crash is all that is wanted: a key that may be left out has no line
            }
            if (there == errors.end()) {
                EXPECT_NE(types & value.type, 0U) << "taken without a word";
            } else {
                EXPECT_TRUE(!there->remedy.empty() || says_remedy(there->what)) << there->what;
            }
        }
    }
};

/// Tries whether readers know the described keys, in every table where one stands until one of them does.
struct Search {
    const Written& written;
    std::map<std::string, bool> is_read{};  ///< by table and key

    void through(const MadeUpFile& file) {
        InputErrors errors;
        const TomlValue document = *read_document(written.folder() / file.name, errors);
        std::vector<Place> places;
        find_tables(document, {.name = ""}, places);
        for (const Place& place : places) {
            const TableKeys* its = description_of(document, place);
            for (const auto& [key, types] : keys_of(document, place)) {
                if (its == nullptr || its->find(key) == nullptr) {
                    continue;
                }
                bool& known = is_read[std::string(its->path) + " " + key];
                if (!known) {
                    const Changed one = changed(document, place, key, {.literal = "\"word\"", .type = text});
                    const std::string unknown = "\"" + key + "\" is not a key of";
                    known = std::ranges::none_of(errors_of(written.add("case.toml", one.content), document),
                                                 [&](const InputError& error) {
                                                     return error.line == one.line && error.what.starts_with(unknown);
                                                 });
                }
            }
        }
    }
};

}  // namespace
}  // namespace wrong_types

// A line of the reference without a reader would be a key that a user writes in vain.
TEST(AllTables, EveryKeyThatIsDescribedIsReadInSomeTable) {
    const Written written;
    written.add("run.csv", log_of_five);
    written.add("log.csv", log_of_five);
    for (const MadeUpFile& file : files_of_every_kind()) {
        written.add(std::string(file.name), file.text);
    }
    wrong_types::Search search{.written = written};
    for (const MadeUpFile& file : files_of_every_kind()) {
        search.through(file);
    }
    for (const auto& [key, is_read] : search.is_read) {
        EXPECT_TRUE(is_read) << key;
    }
}

TEST(WrongTypes, EveryKeyWithEveryTypeIsTakenOrHasAMessageAtItsLine) {
    const Written written;
    written.add("run.csv", log_of_five);
    written.add("log.csv", log_of_five);
    for (const MadeUpFile& file : files_of_every_kind()) {
        written.add(std::string(file.name), file.text);
    }
    wrong_types::Sweep sweep{.written = written};
    for (const MadeUpFile& file : files_of_every_kind()) {
        sweep.through(file);
    }
    std::cout << sweep.keys << " keys, " << sweep.calls << " calls\n";
    EXPECT_GT(sweep.keys, 600);
}

}  // namespace tiretherm::input
