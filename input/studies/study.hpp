// SPDX-License-Identifier: BSD-3-Clause
// A study file: a case, the inputs that vary ([[vary]], [[draw]], [sample]) and the list of its runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/parameters/study_value.hpp"
#include "input/studies/study_draw.hpp"
#include "input/text/input_error.hpp"
#include "input/toml/document.hpp"
#include "solver/hot_spot/hot_spot.hpp"
#include "solver/problem.hpp"

/// Studies: one case run many times, with some of its values varied on a grid or drawn at random.
namespace tiretherm::input {

/// A value of the case that a study changes.
struct StudyInput {
    LocatedString key;               ///< its path in the case
    std::string unit;                ///< as written, of the first value; empty for a pure number and for words
    bool is_number = true;           ///< false: words, or true and false
    bool is_drawn = false;           ///< at random; otherwise a side of the grid
    std::vector<StudyValue> values;  ///< [side of the grid], or [samples]
};

/// The case with the values of a run.
struct StudyCase {
    solver::Problem problem;
    std::vector<solver::Critical> critical{};  ///< the list [[critical]]
};

/// One run of a study.
struct StudyRun {
    std::vector<std::size_t> at;  ///< [inputs] index into StudyInput::values
    std::string fingerprint;      ///< of all that it is made from, see Fingerprints
};

/// A study whose runs are all known to be readable. The runs are the product of the grid, its first key slowest, and of
/// the samples, which are the same at each point of the grid.
class Study {
public:
    std::string title;
    std::filesystem::path file;
    std::filesystem::path case_file;
    std::string case_name;
    std::optional<double> critical;  ///< K, a temperature that the hottest place should not pass
    std::vector<StudyInput> inputs;  ///< first those of the grid
    std::size_t samples = 1;         ///< 1 where nothing is drawn
    std::uint64_t seed = 1;
    std::vector<StudyRun> runs;
    std::vector<solver::Channel> channels;  ///< the same in all runs
    std::vector<std::string> parts{};       ///< names of the case's critical temperatures, the same in all runs

    [[nodiscard]] bool is_sampled() const;
    [[nodiscard]] const StudyValue& value(std::size_t run, std::size_t input) const {
        return inputs[input].values[runs[run].at[input]];
    }
    /// The case with the values of a run. Safe to be called by several threads.
    [[nodiscard]] StudyCase case_of(std::size_t run) const;
    [[nodiscard]] solver::Problem problem(std::size_t run) const { return case_of(run).problem; }

private:
    friend class StudyReader;
    [[nodiscard]] TomlValue document_of(std::size_t run, InputErrors& errors) const;

    TomlValue document_;  ///< of the case
    InputErrors errors_;  ///< knows the files
};

/// A study that has been read, with every case that it makes. There is a study exactly when there is no error.
struct StudyReading {
    std::optional<Study> study;
    std::vector<InputError> errors;  ///< of the study, of its case and of the runs, each once
    std::vector<std::string> warnings;
    std::vector<std::string> files{};  ///< all that were read
};

/// Reads a study file, its case, and this case with the values of each run, until solver::stop_requested(). Never throws on
/// account of what a user wrote.
/// @errors std::runtime_error when the units' data base is not installed
[[nodiscard]] StudyReading read_study(const std::filesystem::path& file);

/// The inputs of a study: [[vary]], [[draw]] and [sample]. @param samples, seed out
[[nodiscard]] std::vector<StudyInput> read_study_inputs(TomlTable& root, std::size_t& samples, std::uint64_t& seed);

}  // namespace tiretherm::input
