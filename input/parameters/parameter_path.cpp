// SPDX-License-Identifier: BSD-3-Clause
// Paths of keys through the document of a case.
#include "input/parameters/parameter_path.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/signals.hpp"

namespace tiretherm::input {

namespace {

/// A path of one key: users write "speed" for "drive.speed".
void refuse_short(const LocatedString& path, const TomlValue& document, InputErrors& errors) {
    const TomlValue* table = document.find(path.text);
    const std::string near = table == nullptr ? nearest(path.text, names_of(physics::signals())) : std::string();
    errors.add(path.place, fmt::format("\"{}\" is not the path of a value: table and key are wanted", path.text),
               near.empty() ? "write such as \"drive.speed\" or \"material.rubber.density\""
                            : fmt::format("did you mean \"drive.{}\"?", near));
}

}  // namespace

std::optional<ParameterPath> ParameterPath::parse(const LocatedString& text, const TomlValue& document,
                                                  InputErrors& errors) {
    if (text.text.empty() || text.text.starts_with('.') || text.text.ends_with('.') ||
        text.text.find("..") != std::string::npos) {
        return errors.add(text.place, fmt::format("\"{}\" is not a path: a key is missing at a dot", text.text),
                          "write such as \"drive.speed\"");
    }
    ParameterPath path{.keys = split_path(text, document)};
    if (path.keys.size() == 1) {
        refuse_short(text, document, errors);
        return std::nullopt;
    }
    return path;
}

ParameterPath ParameterPath::of(std::initializer_list<std::string_view> keys) {
    ParameterPath path;
    for (const std::string_view key : keys) {
        path.keys.push_back({std::string(key), {}});
    }
    return path;
}

std::string ParameterPath::text() const { return joined(keys, keys.size()); }

bool ParameterPath::is_law() const {
    const std::string& last = keys.back().text;
    return (keys.size() == 3 && keys.front().text == "material" &&
            (last == "conductivity" || last == "heat_capacity")) ||
           (keys.size() == 2 && keys.front().text == "mesh" && last == "link_conductivity");
}

void ParameterPath::put(TomlValue& over, TomlValue value) const {
    const std::string& list = keys.front().text;
    if (list == "material" || list == "source" || list == "exchange" || list == "camera" || list == "run") {
        TomlValue& tables = over.at(list);
        tables.kind = TomlValue::Kind::array;
        if (tables.find_named(keys[1].text) == nullptr) {
            TomlValue& item = tables.items.emplace_back();
            item.kind = TomlValue::Kind::table;
            item.set("name", toml_text::text_value(keys[1].text));
        }
    }
    InputErrors errors;
    if (!set(over, value, errors)) {
        throw std::logic_error(fmt::format("{} cannot be laid over a case", text()));
    }
}

}  // namespace tiretherm::input
