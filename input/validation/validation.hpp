// SPDX-License-Identifier: BSD-3-Clause
// Validation table: the models, [[model]], measured numbers, [[number]], how each is read from every model, and what of the
// experiment the source does not print, [[input]].
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "input/text/input_error.hpp"
#include "input/validation/trace.hpp"
#include "solver/problem.hpp"

/// The table of numbers that were measured, each with the way it is read from a simulation.
namespace tiretherm::input {

/// A model that the table judges.
struct ValidationModel {
    std::string key;     ///< "two_node": how its cases end, and its key in `files`
    std::string name;    ///< "two nodes": as people call it
    std::string of{};    ///< key of the model whose cases it takes; empty: it has its own
    std::string with{};  ///< file beside each of these cases, whose values win over theirs
};

/// A readout of one run.
struct Readout {
    std::size_t run = 0;      ///< index into Validation::runs
    std::size_t channel = 0;  ///< index into the channels of that run
    Window window;
};

/// A readout, less another one.
struct Difference {
    Readout of;
    std::optional<Readout> minus;
};

/// A difference, over another one.
struct Expression {
    Difference of;
    std::optional<Difference> over;

    /// @param traces [runs], of which those that this reads have rows
    [[nodiscard]] double value(const std::vector<Trace>& traces) const;
    /// Indices of the runs that it reads.
    [[nodiscard]] std::vector<std::size_t> runs() const;
};

/// What kind of number it is: its unit and its scale follow.
enum class Meaning : std::uint8_t { value, difference, ratio, time };

/// Where the value of an input of an experiment comes from.
enum class Standing : std::uint8_t {
    printed,   ///< in the source
    inferred,  ///< from other numbers of the source
    assumed    ///< the source says nothing
};
inline constexpr std::array<std::string_view, 3> standing_names{"printed", "inferred", "assumed"};

/// An input of an experiment, as its table has it: a value of a case, the length of a part of a test, or how a measured
/// number is to be read.
struct ValidationInput {
    std::string name;
    std::string meaning;
    Standing standing = Standing::printed;
    std::string value;              ///< "30 s", as the cases have it
    double number = 0.0;            ///< of it in `unit`; 0 where it is words
    std::vector<std::string> ends;  ///< of its range; other words where it is no number; empty of a printed one
    std::string unit;               ///< of the numbers
    std::vector<double> numbers;    ///< the ends in that unit; empty where they are words
};

/// An input that a number depends on.
struct NumberInput {
    std::size_t input = 0;          ///< index into Validation::inputs
    bool inferred_from_it = false;  ///< from this very number, which therefore cannot judge a model
    /// How the number is read where the input is at an end of its range [ends][models]; empty of a printed input, and
    /// where the input does not act on a model.
    std::vector<std::vector<std::optional<Expression>>> at_ends;
};

/// One number that was measured.
struct ValidationNumber {
    std::string id;      ///< of the experiment: "M4"
    std::string what;    ///< "bulk, end of the second load"
    std::string source;  ///< where the measured number is from
    Meaning meaning = Meaning::value;
    solver::Quantity quantity = solver::Quantity::temperature;  ///< of the channel
    bool is_measured = false;                                   ///< false: only shown
    bool about_the_model = false;  ///< the source says it of its own model: no property of the tire
    double low = -std::numeric_limits<double>::infinity();    ///< SI, measured; equal to high for a single number
    double high = std::numeric_limits<double>::infinity();    ///< an open end is infinite
    std::vector<std::pair<std::string, double>> uncertainty;  ///< SI, standard, independent parts by name
    std::vector<std::optional<Expression>> models;  ///< [models] how it is read; empty where one has no such thing
    std::vector<NumberInput> inputs;

    /// Root of the sum of squares of the parts; 0 where there is none.
    [[nodiscard]] double total_uncertainty() const;
};

/// A case that numbers are read from, as it is or with one input at an end of its range.
struct ValidationRun {
    std::filesystem::path file;  ///< of a model that takes another's cases it is only a name
    std::string changed;         ///< "ramp = 300 s"; empty: as it is
    solver::Problem problem;
};

struct Validation {
    std::string title;
    std::vector<ValidationModel> models;
    std::vector<ValidationNumber> numbers;
    std::vector<ValidationInput> inputs;
    std::vector<ValidationRun> runs;  ///< each case once, and once for each end of an input that changes it

    /// Leaves the numbers of some experiments and the runs that they need.
    /// @returns the ids that no number has
    std::vector<std::string> keep(const std::vector<std::string>& ids);
    /// Ids of the experiments, in the order of the table, each once.
    [[nodiscard]] std::vector<std::string> ids() const;
};

/// A table that has been read, with all of its cases. There is a table exactly when there is no error.
struct ValidationReading {
    std::optional<Validation> table;
    std::vector<InputError> errors;  ///< of the table, then of the cases
    std::vector<std::string> warnings;
};

/// Reads a table file and every case that it names. Never throws on account of what a user wrote.
/// @errors std::runtime_error when the units' data base is not installed
[[nodiscard]] ValidationReading read_validation(const std::filesystem::path& file);

/// Whether a file is a table of measured numbers, and not a case: it has [[number]]. False for what cannot be read.
[[nodiscard]] bool is_validation_table(const std::filesystem::path& file);

}  // namespace tiretherm::input
