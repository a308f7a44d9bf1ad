// SPDX-License-Identifier: BSD-3-Clause
// The text of a case as it is written: the description of a key gives its quotation marks and its comment.
#include "input/case_text/case_writer.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "input/schema/all_tables.hpp"
#include "input/text/characters.hpp"
#include "input/toml/toml_text.hpp"
#include "physics/effect.hpp"

namespace tiretherm::input {

namespace {

// Wide enough for most entries of the library's cases, which begin their comments there.
constexpr std::size_t comment_column = 36;
constexpr std::size_t line_width = 124;

/// The words of a text in lines of at most `room` characters, one at least.
std::vector<std::string> wrapped(const std::string& text, std::size_t room) {
    std::vector<std::string> lines(1);
    std::size_t used = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        const std::size_t size = split_characters(word).size();
        if (used > 0 && used + 1 + size > room) {
            lines.emplace_back();
            used = 0;
        }
        lines.back() += (used > 0 ? " " : "") + word;
        used += size + (used > 0 ? 1 : 0);
        at = end + 1;
    }
    return lines;
}

/// An entry or a heading with its comment, without the last line's end.
std::string commented(const std::string& line, std::string_view comment) {
    if (comment.empty() || line.find('\n') != std::string::npos) {
        return line;  // a list over several lines has no place for a comment
    }
    const std::size_t size = split_characters(line).size();
    const std::size_t column = std::max(comment_column, size + 2);
    const std::size_t room = std::max<std::size_t>(line_width - std::min(line_width, column + 2), 40);
    std::string text = line + std::string(column - size, ' ');
    bool first = true;
    for (const std::string& part : wrapped(printable(comment), room)) {
        text += first ? "# " + part : "\n" + std::string(column, ' ') + "# " + part;
        first = false;
    }
    return text;
}

/// A parameter, a choice or a table of an effect, as the catalogue has it; their values by place count as they do.
Key key_of_effect(std::string_view table, std::string_view key) {
    const std::string_view id = table.substr(table.find('.') + 1);
    const std::string_view name = key.substr(0, key.find("_by_"));
    if (const physics::Effect* effect = physics::find_effect(id)) {
        if (const auto its = std::ranges::find(effect->parameters, name, &physics::ParameterSpec::key);
            its != effect->parameters.end()) {
            return {.name = its->key, .form = KeyForm::quantity, .sentence = its->meaning, .spec = {.unit = its->unit}};
        }
        if (const auto its = std::ranges::find(effect->choices, key, &physics::Choice::key);
            its != effect->choices.end()) {
            return schema::choice(its->key, {its->options.begin(), its->options.end()}, its->meaning);
        }
        if (const auto its = std::ranges::find(effect->tables, key, &physics::Table::key);
            its != effect->tables.end()) {
            return schema::subtable(its->key, its->meaning);
        }
    }
    throw std::logic_error(fmt::format("no effect {} has a key {}", id, key));
}

/// What describes a key. In a table whose keys are names any name will do, where its own place in the case is described.
Key description(std::string_view table, std::string_view key) {
    const TableKeys* keys = keys_of_table(table);
    if (keys == nullptr) {
        const std::size_t dot = table.rfind('.');
        const bool is_inner = dot != std::string_view::npos;
        static_cast<void>(description(is_inner ? table.substr(0, dot) : "", table.substr(is_inner ? dot + 1 : 0)));
        return schema::value(key, "");
    }
    if (const Key* found = keys->find(key)) {
        return *found;
    }
    if (keys->path == "effects.NAME") {
        return key_of_effect(table, key);
    }
    if (!keys->has_names) {
        throw std::logic_error(fmt::format("no description has a key {} in [{}]", key, table));
    }
    return schema::value(key, "");
}

std::string toml_value(const Key& key, std::string_view value) {
    if (key.form == KeyForm::choice && std::ranges::find(key.words, value) == key.words.end()) {
        throw std::logic_error(fmt::format("{} is no word of {}", value, key.name));
    }
    const bool is_text = key.form == KeyForm::text || key.form == KeyForm::name || key.form == KeyForm::choice;
    const std::optional<Number> number = leading_number(value);
    const bool is_bare = !is_text && ((number && number->rest.empty()) || value.starts_with('[') ||
                                      value.starts_with('{') || key.form == KeyForm::flag);
    return is_bare ? std::string(value) : toml_text::in_quotes(value);
}

/// The first sentence of a description as a comment has it, in small letters and without a stop, and the few words of a choice.
std::string comment_of(const Key& key, bool with_default) {
    constexpr std::string_view mark = "Default: ";
    // More words than these are a list to look up: `tiretherm keys` has it.
    constexpr std::size_t few = 4;
    const std::string_view sentence = key.sentence;
    const std::size_t standard = sentence.find(mark);
    std::string text(sentence.substr(0, standard));
    text.resize(std::min(text.find(". "), text.size() - (text.ends_with('.') ? 1 : 0)));
    std::erase(text, '`');
    if (text.size() > 1 && (std::islower(static_cast<unsigned char>(text[1])) != 0 || text[1] == ' ')) {
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    }
    const bool is_told = key.words.empty() || text.find(key.words.back()) != std::string::npos;
    if (!is_told && key.words.size() <= few) {
        text += fmt::format(" ({})", fmt::join(key.words, ", "));
    }
    if (with_default && standard != std::string_view::npos) {
        std::string_view its = sentence.substr(standard + mark.size());
        its.remove_suffix(its.ends_with('.') ? 1 : 0);
        text += fmt::format("{}default: {}", text.empty() ? "" : "; ", its);
    }
    return text;
}

std::string heading(std::string_view path, bool is_list) {
    return fmt::format("{}{}{}", is_list ? "[[" : "[", path, is_list ? "]]" : "]");
}

/// Every key of a table and of the tables in it has a description.
void expect_described(const TomlValue& table, const std::string& path) {
    for (const Entry& entry : table.entries) {
        static_cast<void>(description(path, entry.key));
        const std::string inner = fmt::format("{}{}{}", path, path.empty() ? "" : ".", entry.key);
        for (const TomlValue& item :
             entry.value.kind == TomlValue::Kind::table ? std::vector{entry.value} : entry.value.items) {
            if (!item.in_braces) {
                expect_described(item, inner);
            }
        }
    }
}

}  // namespace

std::string entry_line(std::string_view table, std::string_view key, std::string_view value, std::string_view comment) {
    return commented(fmt::format("{} = {}", toml_text::key(key), toml_value(description(table, key), value)), comment);
}

void CaseWriter::table(std::string_view path, std::string_view comment) {
    const std::size_t dot = path.rfind('.');
    const bool is_inner = dot != std::string_view::npos;
    const TableKeys* keys = keys_of_table(path);
    if (keys == nullptr) {
        static_cast<void>(description(is_inner ? path.substr(0, dot) : "", path.substr(is_inner ? dot + 1 : 0)));
    }
    if (!std::exchange(captioned_, false) && !commented_) {
        blank();
    }
    path_ = path;
    text_ +=
        commented((commented_ ? "# " : "") + heading(path, keys != nullptr && keys->form == TableForm::list), comment) +
        "\n";
}

void CaseWriter::entry(std::string_view key, std::string_view value, std::string_view comment) {
    if (commented_) {
        suggestion(key, value, comment);
        return;
    }
    const std::string line = entry_line(path_, key, value);
    const bool has_room = line.size() < line_width;  // beside a list of long texts a meaning would be out of sight
    text_ += commented(line, comment.empty() && has_room ? meaning(key) : comment) + "\n";
}

void CaseWriter::entry(std::string_view key, double value) {
    const QuantitySpec spec = description(path_, key).spec;
    entry(key, spec.is_pure() ? fmt::format("{}", value) : fmt::format("{} {}", value, spec.unit));
}

void CaseWriter::suggestion(std::string_view key, std::string_view value, std::string_view comment) {
    // What stands behind a # is no TOML yet: a name that is no UTF-8 must not spoil the file.
    const std::string line = printable("# " + entry_line(path_, key, value));
    text_ += commented(line, comment.empty() ? meaning(key, true) : comment) + "\n";
}

std::string CaseWriter::meaning(std::string_view key, bool with_default) {
    const bool is_new = told_.insert(fmt::format("{}.{}", path_, key)).second;
    return is_new ? comment_of(description(path_, key), with_default) : "";
}

void CaseWriter::caption(std::string_view text) {
    blank();
    remark(text);
    captioned_ = true;
}

void CaseWriter::remark(std::string_view text) {
    for (const std::string& line : wrapped(printable(text), line_width - 2)) {
        text_ += "# " + line + "\n";
    }
}

void CaseWriter::blank() {
    if (!text_.empty() && !text_.ends_with("\n\n")) {
        text_ += "\n";
    }
}

void CaseWriter::lines(const std::vector<std::string>& lines, std::string_view path) {
    path_ = path;
    for (const std::string& line : lines) {
        text_ += line + "\n";
    }
}

void CaseWriter::document(const TomlValue& root) {
    expect_described(root, "");
    text_ += toml_text::document(root);
}

}  // namespace tiretherm::input
