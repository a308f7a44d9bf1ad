// SPDX-License-Identifier: BSD-3-Clause
// Walks through the document of a case.

#include "input/studies/case_values.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "input/toml/document.hpp"

namespace tiretherm::input {

namespace {

std::string text_of(const TomlValue& value) {
    switch (value.kind) {
        case TomlValue::Kind::text:
        case TomlValue::Kind::date:
            return value.text;
        case TomlValue::Kind::integer:
        case TomlValue::Kind::real:
            return fmt::format("{}", value.number);
        case TomlValue::Kind::boolean:
            return value.truth ? "true" : "false";
        default:
            return "";
    }
}

bool has_tables(const TomlValue& list) {
    return std::ranges::any_of(list.items, [](const TomlValue& item) {
        return item.kind == TomlValue::Kind::table || item.kind == TomlValue::Kind::array;
    });
}

void walk(const std::string& path, const TomlValue& value, std::vector<std::pair<std::string, std::string>>& into) {
    const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
    if (value.kind == TomlValue::Kind::table) {
        for (const Entry& entry : value.entries) {
            walk(below(entry.key), entry.value, into);
        }
    } else if (value.kind == TomlValue::Kind::array && has_tables(value)) {
        for (std::size_t i = 0; i < value.items.size(); ++i) {
            const TomlValue* name = value.items[i].find("name");
            walk(below(name != nullptr && !name->text.empty() ? name->text : std::to_string(i + 1)), value.items[i],
                 into);
        }
    } else if (value.kind == TomlValue::Kind::array) {
        std::string all;
        for (const TomlValue& item : value.items) {
            all += (all.empty() ? "" : ", ") + text_of(item);
        }
        into.emplace_back(path, all);
    } else {
        into.emplace_back(path, text_of(value));
    }
}

}  // namespace

std::vector<std::pair<std::string, std::string>> case_values(const std::filesystem::path& file) {
    InputErrors errors;
    std::vector<std::pair<std::string, std::string>> values;
    if (const std::optional<TomlValue> document = read_document(file, errors)) {
        walk("", *document, values);
    }
    return values;
}

}  // namespace tiretherm::input
