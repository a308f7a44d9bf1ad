#include "input/parameters/study_key.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "physics/signals.hpp"

namespace tiretherm::input {

namespace {

/// A path on its way: what is still ahead, and how far into the text it begins.
class Steps {
public:
    explicit Steps(const LocatedString& path) : path_(path) {}

    [[nodiscard]] std::string_view rest() const { return std::string_view(path_.text).substr(at_); }
    /// The next key, up to the next dot.
    [[nodiscard]] std::string_view key() const { return rest().substr(0, rest().find('.')); }
    [[nodiscard]] bool last(std::string_view part) const { return part.size() == rest().size(); }
    [[nodiscard]] std::string_view gone() const {
        return std::string_view(path_.text).substr(0, at_ > 0 ? at_ - 1 : 0);
    }
    void pass(std::string_view part) { at_ = std::min(at_ + part.size() + 1, path_.text.size()); }

    /// Where a part that begins here stands: the text begins behind its quote.
    [[nodiscard]] SourceLocation place(std::string_view part) const {
        SourceLocation place = path_.place;
        place.column += 1 + static_cast<int>(split_characters(path_.text.substr(0, at_)).size());
        place.length = std::max<int>(1, static_cast<int>(split_characters(part).size()));
        return place;
    }

private:
    const LocatedString& path_;
    std::size_t at_ = 0;
};

const std::string* name_of(const TomlValue& table) {
    const TomlValue* name = table.kind == TomlValue::Kind::table ? table.find("name") : nullptr;
    return name != nullptr && name->kind == TomlValue::Kind::text ? &name->text : nullptr;
}

/// The table of a list whose name stands next in the path, with or without dots in it; the longest such name.
template <typename AnyNode>
AnyNode* find_named(AnyNode& list, const Steps& steps) {
    AnyNode* found = nullptr;
    for (AnyNode& item : list.items) {
        const std::string* name = name_of(item);
        const bool here = name != nullptr && steps.rest().starts_with(*name) &&
                          (steps.last(*name) || steps.rest()[name->size()] == '.');
        if (here && (found == nullptr || name_of(*found)->size() < name->size())) {
            found = &item;
        }
    }
    return found;
}

std::vector<std::string> names_in(const TomlValue& list) {
    std::vector<std::string> names;
    for (const TomlValue& item : list.items) {
        if (const std::string* name = name_of(item)) {
            names.push_back(*name);
        }
    }
    return names;
}

/// A path of one key: users write "speed" for "drive.speed".
void refuse_short(const LocatedString& path, const TomlValue& document, InputErrors& errors) {
    std::vector<std::string> signals;
    for (const physics::Signal& signal : physics::signals()) {
        signals.emplace_back(signal.name);
    }
    const TomlValue* table = document.find(path.text);
    const std::string near = table == nullptr ? nearest(path.text, signals) : std::string();
    errors.add(path.place, fmt::format("\"{}\" is not the path of a value: table and key are wanted", path.text),
               near.empty() ? "write such as \"drive.speed\" or \"material.rubber.density\""
                            : fmt::format("did you mean \"drive.{}\"?", near));
}

Entry& entry_of(TomlValue& table, std::string_view key, const SourceLocation& place) {
    const auto known =
        std::find_if(table.entries.begin(), table.entries.end(), [&](const Entry& entry) { return entry.key == key; });
    if (known != table.entries.end()) {
        return *known;
    }
    TomlValue made;
    made.kind = TomlValue::Kind::table;
    made.place = place;
    table.entries.push_back({.key = std::string(key), .place = place, .value = std::move(made)});
    return table.entries.back();
}

}  // namespace

bool write_at(TomlValue& document, const LocatedString& path, const TomlValue& value, InputErrors& errors) {
    Steps steps(path);
    if (path.text.empty() || path.text.starts_with('.') || path.text.ends_with('.') ||
        path.text.find("..") != std::string::npos) {
        errors.add(path.place, fmt::format("\"{}\" is not a path: a key is missing at a dot", path.text),
                   "write such as \"drive.speed\"");
        return false;
    }
    if (steps.last(steps.key())) {
        refuse_short(path, document, errors);
        return false;
    }
    TomlValue* at = &document;
    while (true) {
        if (at->kind == TomlValue::Kind::array) {
            TomlValue* item = find_named(*at, steps);
            if (item == nullptr) {
                const std::vector<std::string> names = names_in(*at);
                errors.add(steps.place(steps.key()),
                           fmt::format("there is no \"{}\" in [[{}]]", steps.key(), steps.gone()),
                           names.empty() ? "its tables have no names, so none can be told from the others"
                                         : suggest(steps.key(), names, "names"));
                return false;
            }
            steps.pass(*name_of(*item));
            at = item;
            if (steps.rest().empty()) {
                errors.add(path.place, fmt::format("\"{}\" is a table; one of its values is wanted", path.text),
                           fmt::format("go on with a key of it: \"{}.key\"", path.text));
                return false;
            }
            continue;
        }
        if (at->kind != TomlValue::Kind::table) {
            errors.add(steps.place(steps.key()),
                       fmt::format("{} is {}, which has no \"{}\"", steps.gone(), shown(*at), steps.key()),
                       fmt::format("end the path there: \"{}\"", steps.gone()));
            return false;
        }
        const std::string_view key = steps.key();
        Entry& entry = entry_of(*at, key, steps.place(key));
        if (steps.last(key)) {
            entry.value = value;
            return true;
        }
        steps.pass(key);
        at = &entry.value;
    }
}

const TomlValue* find_at(const TomlValue& document, const LocatedString& path) {
    Steps steps(path);
    const TomlValue* at = &document;
    while (at != nullptr && !steps.rest().empty()) {
        if (at->kind == TomlValue::Kind::array) {
            at = find_named(*at, steps);
            steps.pass(at != nullptr ? std::string_view(*name_of(*at)) : steps.rest());
        } else {
            const std::string_view key = steps.key();
            at = at->kind == TomlValue::Kind::table ? at->find(key) : nullptr;
            steps.pass(key);
        }
    }
    return at;
}

}  // namespace tiretherm::input
