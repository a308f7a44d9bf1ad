// SPDX-License-Identifier: BSD-3-Clause
// Merges a case with the files that it includes: tables key by key, lists with names by their `name`.

#include "input/toml/document.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "input/files/run_name.hpp"
#include "input/toml/tree.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

const std::string* text_of(const TomlValue& node, std::string_view key) {
    const TomlValue* text = node.kind == TomlValue::Kind::table ? node.find(key) : nullptr;
    return text != nullptr && text->kind == TomlValue::Kind::text ? &text->text : nullptr;
}

/// The name of a table that is in a list, by its own word or, as a run may leave it, by its file and laps.
std::string name_of(const TomlValue& node) {
    const std::string* name = text_of(node, "name");
    const std::string* file = text_of(node, "file");
    const std::string* laps = text_of(node, "laps");
    return name != nullptr   ? *name
           : file != nullptr ? run_name(*file, laps != nullptr ? std::string_view(*laps) : "")
                             : std::string();
}

/// A list of tables of each of which this holds.
bool is_list_of(const TomlValue& array, bool (*holds)(const TomlValue& item)) {
    return array.kind == TomlValue::Kind::array && std::ranges::all_of(array.items, holds);
}
bool has_name(const TomlValue& item) { return text_of(item, "name") != nullptr; }
bool can_be_named(const TomlValue& item) { return !name_of(item).empty(); }

void merge(TomlValue& into, TomlValue&& over, int depth);

bool is_at(const TomlValue& node, const SourceLocation& place) {
    return node.place.file == place.file && node.place.line == place.line && node.place.column == place.column;
}

/// Tables of the same name become one, in the place of the first; the others follow.
void merge_by_name(TomlValue& into, TomlValue&& over) {
    for (TomlValue& item : over.items) {
        auto same = std::ranges::find_if(into.items, [&](const TomlValue& known) { return is_at(known, item.place); });
        if (same != into.items.end()) {  // of a file that is included twice: the very same table
            merge(*same, std::move(item), 1);
            continue;
        }
        same =
            std::ranges::find_if(into.items, [&](const TomlValue& known) { return name_of(known) == name_of(item); });
        // A name that the same file uses twice is reported by the reader.
        const bool mine = same != into.items.end() && same->place.file == item.place.file;
        if (same == into.items.end() || mine) {
            into.items.push_back(std::move(item));
        } else {
            merge(*same, std::move(item), 1);
        }
    }
    into.place = over.place;
}

/// Puts the values of `over` over those of `into`.
void merge(TomlValue& into, TomlValue&& over, int depth) {
    if (into.kind != TomlValue::Kind::table || over.kind != TomlValue::Kind::table || over.in_braces) {
        into = std::move(over);
        return;
    }
    const TomlValue* old_kind = into.find("kind");
    const TomlValue* new_kind = over.find("kind");
    if (old_kind != nullptr && new_kind != nullptr && old_kind->text != new_kind->text) {
        into = std::move(over);  // another kind has other keys
        return;
    }
    into.place = over.place;
    for (Entry& entry : over.entries) {
        const auto same = std::find_if(into.entries.begin(), into.entries.end(),
                                       [&](const Entry& known) { return known.key == entry.key; });
        if (same == into.entries.end()) {
            into.entries.push_back(std::move(entry));
        } else if (depth == 0 && is_list_of(same->value, can_be_named) && is_list_of(entry.value, has_name)) {
            merge_by_name(same->value, std::move(entry.value));
        } else {
            same->place = entry.place;
            merge(same->value, std::move(entry.value), depth + 1);
        }
    }
}

/// The texts of a list, or of one text; an error where it is neither. @param wanted of the list, and of each text
std::vector<TomlValue> listed_texts(const TomlValue& value, std::string_view key,
                                    const std::array<std::string_view, 2>& wanted, const std::string& remedy,
                                    InputErrors& errors, bool& sound) {
    if (value.kind == TomlValue::Kind::text) {
        return {value};
    }
    if (value.kind != TomlValue::Kind::array) {
        errors.add(value.place, fmt::format("{} is {}; a list of {} is wanted", key, shown(value), wanted[0]), remedy);
        sound = false;
        return {};
    }
    std::vector<TomlValue> texts;
    for (const TomlValue& item : value.items) {
        if (item.kind == TomlValue::Kind::text) {
            texts.push_back(item);
        } else {
            errors.add(item.place, fmt::format("{} has {}; {} is wanted", key, shown(item), wanted[1]), remedy);
            sound = false;
        }
    }
    return texts;
}

constexpr std::size_t most_files_open = 64;  // a case and what it includes, one within the other

/// Reads files and what they include. A file that is mentioned twice is read and merged once.
class Reader {
public:
    explicit Reader(InputErrors& errors) : errors_(&errors) {}

    /// @param mentioned where the path was written  @param text in the place of the file's own, or null
    std::optional<TomlValue> read(const fs::path& path, const SourceLocation& mentioned,
                                  const std::string* text = nullptr) {
        std::error_code error;
        // Two paths may lead to one file, so that a circle of includes is found by where they lead.
        const fs::path real = fs::weakly_canonical(path, error);
        if (std::find(open_.begin(), open_.end(), real) != open_.end()) {
            return errors_->add(mentioned, fmt::format("{} includes itself", path.generic_string()),
                                "remove one of the includes");
        }
        if (const auto known = merged_.find(real); known != merged_.end()) {
            return known->second;
        }
        if (open_.size() == most_files_open) {
            return errors_->add(mentioned,
                                fmt::format("more than {} files include one another in a row", most_files_open),
                                "include the last ones directly: include = [\"one.toml\", \"two.toml\"]");
        }
        const std::optional<TextFile> file =
            text != nullptr ? TextFile{.number = errors_->add_file(path.generic_string(), *text), .text = *text}
                            : read_text(path, mentioned, *errors_);
        if (!file) {
            return std::nullopt;  // it is reported wherever it is mentioned
        }
        open_.push_back(real);
        std::optional<TomlValue> all = with_included(path, parse_toml(*file, *errors_));
        open_.pop_back();
        // Also what failed is kept: its errors are reported where it is read first, and not once for each mention.
        return merged_.emplace(real, std::move(all)).first->second;
    }

private:
    /// The tables of a file over those of the files that it includes.
    std::optional<TomlValue> with_included(const fs::path& path, std::optional<TomlValue> own) {
        const TomlValue* include = own ? own->find("include") : nullptr;
        if (include == nullptr) {
            if (own) {
                refuse(*own, "unset", "takes keys away from included files", "remove the key itself");
                refuse(*own, "set", "gives values to keys of included files", "write the value at its key");
            }
            return own;
        }
        bool complete = true;
        const std::vector<TomlValue> list =
            listed_texts(*include, "include", {"files", "the path of a file"},
                         "write include = [\"../tires/some_tire.toml\"]", *errors_, complete);
        std::vector<TomlValue> unwanted;
        if (const TomlValue* without = own->find("unset")) {
            unwanted = listed_texts(*without, "unset", {"keys", "a text"}, "write unset = [\"drive.air_temperature\"]",
                                    *errors_, complete);
        }
        TomlValue values;
        if (TomlValue* given = own->find("set")) {
            complete = is_table_of_values(*given) && complete;
            values = std::move(*given);
        }
        std::erase_if(own->entries, [](const Entry& entry) {
            return entry.key == "include" || entry.key == "unset" || entry.key == "set";
        });
        TomlValue merged;
        merged.kind = TomlValue::Kind::table;
        for (const TomlValue& item : list) {
            std::optional<TomlValue> included = read((path.parent_path() / item.text).lexically_normal(), item.place);
            complete = complete && included;
            if (included) {
                merge(merged, std::move(*included), 0);
            }
        }
        if (complete) {
            for (const TomlValue& key : unwanted) {
                unset(merged, {key.text, key.place}, *errors_);
            }
        }
        // Last: what the file says itself wins over all that it includes.
        merge(merged, std::move(*own), 0);
        // Behind the file's own tables, so that a path may lead into them.
        if (complete) {
            for (const Entry& entry : values.entries) {
                set(merged, split_path({entry.key, entry.place}, merged), entry.value, *errors_);
            }
        }
        return complete ? std::optional(std::move(merged)) : std::nullopt;
    }

    /// Takes a key away that makes no sense in a file without includes. @param effect what it does
    void refuse(TomlValue& own, std::string_view key, std::string_view effect, const std::string& remedy) {
        if (const TomlValue* value = own.find(key)) {
            errors_->add(value->place, fmt::format("{} {}, and this file includes none", key, effect), remedy);
            own.remove(key);
        }
    }

    /// Reports `set` where it is something else.
    bool is_table_of_values(const TomlValue& given) {
        if (given.kind != TomlValue::Kind::table) {
            errors_->add(given.place,
                         fmt::format("set is {}; a table of paths with their values is wanted", shown(given)),
                         "write set = { \"drive.speed\" = \"80 km/h\" }");
            return false;
        }
        return true;
    }

    InputErrors* errors_;
    std::vector<fs::path> open_;                           ///< each is included by the one before
    std::map<fs::path, std::optional<TomlValue>> merged_;  ///< nothing: it has errors
};

}  // namespace

std::string shown(const TomlValue& node) {
    switch (node.kind) {
        case TomlValue::Kind::nothing:
            return "nothing";
        case TomlValue::Kind::text:
            return fmt::format("\"{}\"", node.text);
        case TomlValue::Kind::integer:
            return fmt::format("{:.0f}", node.number);
        case TomlValue::Kind::real:
            return fmt::format("{}", node.number);
        case TomlValue::Kind::boolean:
            return node.truth ? "true" : "false";
        case TomlValue::Kind::date:
            return "a date";
        case TomlValue::Kind::array:
            return "a list";
        case TomlValue::Kind::table:
            return "a table";
    }
    return {};
}

void override_tables(TomlValue& document, const TomlValue& over, std::span<const std::string_view> names) {
    TomlValue tables;
    tables.kind = TomlValue::Kind::table;
    tables.place = document.place;
    for (const Entry& entry : over.entries) {
        const TomlValue* known = document.find(entry.key);
        const bool is_alike = known == nullptr || known->kind == entry.value.kind;
        if (is_alike && std::find(names.begin(), names.end(), entry.key) != names.end()) {
            tables.entries.push_back(entry);
            tables.entries.back().value.in_braces = false;
        }
    }
    merge(document, std::move(tables), 0);
}

std::optional<TomlValue> read_document(const std::filesystem::path& path, InputErrors& errors,
                                       const std::string* text) {
    return Reader(errors).read(path, {}, text);
}

}  // namespace tiretherm::input
