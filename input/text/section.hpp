#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/text/document.hpp"
#include "input/text/mistake.hpp"
#include "input/text/quantity.hpp"

namespace tiretherm::input {

enum class Need : std::uint8_t { optional, required };

/// A text and where it stands.
struct Word {
    std::string text;
    Place place;
};

/// A table that is being read. Each key that a reader asks for becomes a known key; a wrong value becomes a mistake and
/// is returned as if it were absent; at the end of its life the section reports the keys that nobody asked for. So the
/// calls of a reader are the schema of its table.
class Section {
public:
    /// @param name as messages show it: "[mesh]"; the case itself: "the case"
    Section(const Node& table, std::string name, Mistakes& mistakes);
    /// A table that is not there, which has been complained about where it must be: nothing in it is missed.
    Section(const Place& place, std::string name, Mistakes& mistakes);
    ~Section();
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;

    [[nodiscard]] bool exists() const { return table_ != &nothing_; }
    [[nodiscard]] bool has(std::string_view key) const { return table_->find(key) != nullptr; }

    std::optional<double> quantity(std::string_view key, const Wanted& wanted, Need need = Need::optional);
    std::optional<std::string> text(std::string_view key, Need need = Need::optional);
    /// A text that later names a column or a data set: not empty, without brackets, quotes, slashes, commas and blanks
    /// at its ends.
    std::optional<std::string> name(std::string_view key, Need need = Need::optional);
    /// One of several words. @returns its index
    std::optional<std::size_t> choice(std::string_view key, std::span<const std::string_view> options,
                                      Need need = Need::optional);
    std::optional<bool> flag(std::string_view key);
    std::optional<int> count(std::string_view key, int low, int high, Need need = Need::optional);
    /// A list of texts, or one text.
    std::vector<Word> texts(std::string_view key, Need need = Need::optional);

    /// The table of this key; one that does not exist when there is none.
    [[nodiscard]] Section section(std::string_view key, Need need = Need::optional);
    /// Reads each table of a list.
    /// @param example one entry as the user may write it; empty: its heading [[...]]
    void each(std::string_view key, const std::function<void(Section&)>& read, Need need = Need::optional,
              std::string_view example = {});
    /// The value as it stands, null when absent.
    const Node* value(std::string_view key, Need need = Need::optional, std::string_view example = {});

    [[nodiscard]] const Node& table() const { return *table_; }
    [[nodiscard]] const Place& place() const { return table_->place; }
    /// Place of a value, or of the table when there is none.
    [[nodiscard]] Place place(std::string_view key) const;
    [[nodiscard]] const std::string& title() const { return name_; }
    [[nodiscard]] Mistakes& mistakes() const { return *mistakes_; }

    void mistake(std::string_view key, std::string what, std::string remedy = {}) const;
    /// Adds keys to the known ones.
    void know(std::initializer_list<std::string_view> keys);
    /// Unknown keys are not reported: the schema could not be followed to its end.
    void forgive() { forgiving_ = true; }
    [[nodiscard]] const std::vector<std::string>& known() const { return known_; }

private:
    /// The value when it is of a wanted kind; otherwise a mistake and null.
    /// @param example what to write, which begins with the key or is the heading of its table
    const Node* take(std::string_view key, Need need, std::initializer_list<Node::Kind> kinds, std::string_view wanted,
                     std::string_view example);
    void miss(std::string_view key, std::string_view example) const;
    [[nodiscard]] std::string child_name(std::string_view key, bool list) const;

    Node nothing_;
    const Node* table_;
    std::string name_;
    Mistakes* mistakes_;
    std::vector<std::string> known_;
    bool forgiving_ = false;
};

}  // namespace tiretherm::input
