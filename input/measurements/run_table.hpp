#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "input/text/section.hpp"

namespace tiretherm::input {

/// What a case says about the columns of a file: the keys `columns`, `units` and `ignore`.
class ColumnKeys {
public:
    void read(Section& section);

    /// The name a heading stands for: its own, unless `columns` gives it another.
    [[nodiscard]] Word name_of(const std::string& heading, const Place& place);
    [[nodiscard]] const Word* unit_of(const std::string& heading);  ///< null when `units` has none
    [[nodiscard]] bool ignores(const std::string& heading);
    /// Which keys could not be right is not known when a file could not be opened.
    void forgive() { forgiving_ = true; }
    /// Every key must be a column of some file.
    void complain(Mistakes& mistakes) const;

private:
    struct Key {
        Word column;  ///< the key itself
        Word value;
        bool found = false;
    };
    static void read_words(Section table, std::vector<Key>& into);

    std::vector<Key> names_;
    std::vector<Key> units_;
    std::vector<Key> ignored_;
    std::set<std::string> headings_;  ///< of all files
    bool forgiving_ = false;
};

/// A file of frames that a run names.
struct FramesOfRun {
    Word camera;  ///< empty: the only one
    std::filesystem::path path;
    Place place;  ///< of its name
};

/// A measured run as the case announces it.
struct RunTable {
    const Node* table = nullptr;  ///< of [[run]]; null for the case itself and for a file given beside it
    Place place;                  ///< of the file's name, or of the table; file -1: neither
    std::string name;
    std::optional<std::filesystem::path> file{};
    std::shared_ptr<ColumnKeys> keys = std::make_shared<ColumnKeys>();
    std::optional<double> from{};  ///< s
    std::optional<double> to{};    ///< s
    std::vector<FramesOfRun> frames{};
};

/// The runs of a case: its [[run]] tables; or one for each file that takes their place, with the keys of [data]; or,
/// with neither, the case itself.
[[nodiscard]] std::vector<RunTable> read_run_tables(Section& root, const std::string& case_name,
                                                    const std::vector<std::filesystem::path>& data);

}  // namespace tiretherm::input
