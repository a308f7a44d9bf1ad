// SPDX-License-Identifier: BSD-3-Clause
// Tables [[run]] and [data]: file, time window, camera frames, and the keys `columns`, `units`, `unit_names`, `ignore`,
// `hold` and `keep_suspicious` for columns.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/loggers/log_description.hpp"
#include "input/toml/toml_table.hpp"

namespace tiretherm::input {

/// What a case says about the columns of a file: the keys `columns`, `units`, `unit_names`, `ignore`, `hold` and `keep_suspicious`. Those of
/// [data] count for every file; what a run says itself wins: column by column, and for `ignore` and `hold` as a whole.
class ColumnKeys {
public:
    void read(TomlTable& table);
    /// @param shared the keys of [data], which count where these say nothing
    void fall_back_on(std::shared_ptr<ColumnKeys> shared) { shared_ = std::move(shared); }

    /// The name a heading stands for: its own, unless `columns` gives it another.
    [[nodiscard]] LocatedString name_of(const std::string& heading, const SourceLocation& place);
    [[nodiscard]] const LocatedString* unit_of(const std::string& heading) {  ///< null when `units` has none
        return value_of(&ColumnKeys::units_, heading);
    }
    /// What a heading's unit is called in truth, null when `unit_names` does not say.
    [[nodiscard]] const LocatedString* unit_named(const std::string& unit) {
        return value_of(&ColumnKeys::unit_names_, unit);
    }
    [[nodiscard]] bool ignores(const std::string& heading);
    /// Whether a signal, by the name that the model knows, keeps each value until the next sample.
    [[nodiscard]] bool holds(const std::string& name);
    /// Whether samples count that look stuck, clipped or interpolated: `keep_suspicious`.
    [[nodiscard]] bool keeps_suspicious() const;
    /// When a file could not be opened, it is not known which keys are wrong.
    void allow_unknown_keys();
    /// Every key must be a column of some file; of those that [data] has for [[run]] it is a warning.
    void report_unknown_columns(InputErrors& errors) const;

private:
    struct Key {
        LocatedString column;  ///< the key itself
        LocatedString value;
        bool found = false;
    };
    static void read_words(TomlTable table, std::vector<Key>& into);
    static Key* find(std::vector<Key>& keys, const std::string& word);
    /// What a key says, here or in [data]; null where none does.
    [[nodiscard]] const LocatedString* value_of(std::vector<Key> ColumnKeys::*keys, const std::string& word);
    /// Keys that are a column of no file. Valid as long as this.
    [[nodiscard]] std::vector<const Key*> unknown_columns() const;
    void warn_of_unknown_columns(InputErrors& errors) const;
    /// The name that a key gives to a heading, null where none does.
    [[nodiscard]] const LocatedString* mapped_name(const std::string& heading);

    std::vector<Key> names_;
    std::vector<Key> units_;
    std::vector<Key> unit_names_;
    std::vector<Key> ignored_;
    std::vector<Key> held_;
    bool has_ignored_ = false;  ///< the key is there, and be it empty
    bool has_held_ = false;
    std::optional<bool> keep_suspicious_;
    std::set<std::string> headings_;  ///< of all files
    bool unknown_keys_allowed_ = false;
    std::shared_ptr<ColumnKeys> shared_;
};

/// A file of frames that a run names.
struct FramesOfRun {
    LocatedString camera;  ///< empty: the only one
    std::filesystem::path path;
    SourceLocation place;  ///< of its name
};

/// A measured run as the case announces it.
struct RunTable {
    const TomlValue* table = nullptr;  ///< of [[run]]; null for the case itself and for a file given beside it
    SourceLocation place;              ///< of the file's name, or of the table; file -1: neither
    std::string name;
    std::string recording{};                  ///< of a corner: the name of the run without it
    std::string corner{};                     ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    const TomlValue* corner_table = nullptr;  ///< of [[corner]]
    std::optional<std::filesystem::path> file{};
    std::shared_ptr<ColumnKeys> keys = std::make_shared<ColumnKeys>();
    std::optional<double> from{};           ///< s
    std::optional<double> to{};             ///< s
    std::optional<LocatedString> laps{};    ///< in the place of from and to
    int repeat_first_lap = 0;               ///< so many times the first of the laps goes before
    std::optional<StartLine> start_line{};  ///< where laps begin
    SourceLocation start_line_place{};
    std::vector<FramesOfRun> frames{};
};

/// The runs of a case: its [[run]] tables, over the keys of [data] for columns; or one for each file that takes their
/// place, with all keys of [data]; or, with neither, the case itself. With [[corner]] each of them once for each corner.
[[nodiscard]] std::vector<RunTable> read_run_tables(TomlTable& root, const std::string& case_name,
                                                    const std::vector<std::filesystem::path>& data);

/// What the run of a file beside the case is called: after the file, and after its folder where another has the same name.
/// @param data all such files  @param laps as [data] has them; empty: the whole file
[[nodiscard]] std::string name_beside(const std::vector<std::filesystem::path>& data, const std::filesystem::path& file,
                                      std::string_view laps);
/// What the run of a [[run]] table is called; empty where neither a name nor a file says it.
[[nodiscard]] std::string name_of_run_table(const TomlValue& table);

}  // namespace tiretherm::input
