// SPDX-License-Identifier: BSD-3-Clause
// Simulates what additions change of the quoted numbers, alone or on top of others.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/detect/candidates.hpp"
#include "diagnosis/quoted/addition.hpp"
#include "diagnosis/quoted/quoted_numbers.hpp"
#include "diagnosis/validation/validation_runs.hpp"

namespace tiretherm::diagnosis::quoted {

/// An addition at a value of its number.
struct Applied {
    const Addition* addition = nullptr;
    double value = 0.0;
};

/// The last value of a temperature in one run, as another model than the base has it.
struct ChannelEnd {
    std::string run;
    std::string channel;
    double value = 0.0;  ///< degC
};

/// Simulates the runs of a table with something added. Every run of the table as it is is simulated once.
class Trials {
public:
    /// @param validation outlives this   @param model index into Validation::models, that is diagnosed
    /// @param threads 0: as many as the machine has   @param progress called with the number of simulations, or empty
    Trials(const input::Validation& validation, std::size_t model, unsigned threads,
           std::function<void(long)> progress);

    /// The rows of the table, of the model that is diagnosed, with inputs at the ends of their ranges.
    [[nodiscard]] const std::vector<ValidationRow>& table() const { return table_; }
    /// Why runs as they are, or with an input at an end, have no result.
    [[nodiscard]] std::vector<std::string> failures() const;

    /// Everything that can act on the runs, not yet simulated but for the inputs.
    [[nodiscard]] std::vector<Addition> additions(const Numbers& numbers) const;
    /// Fills in what an addition changes by itself.
    void simulate(Addition& addition, const Numbers& numbers);
    /// What several additions change together, simulated; an input is simulated at the ends of its range, with the others in it.
    /// @returns [rows]; empty after a failure
    [[nodiscard]] std::vector<double> together(const std::vector<Applied>& applied, const Numbers& numbers);
    /// Temperatures at the end of the runs that some numbers are read from, with additions in them.
    /// @param of indices into Validation::numbers
    [[nodiscard]] std::vector<ChannelEnd> ends(const std::vector<Applied>& applied, const std::vector<std::size_t>& of);
    [[nodiscard]] long simulations() const { return simulations_; }

private:
    /// Runs as they are of a model, each once.
    [[nodiscard]] std::vector<std::size_t> nominal_runs(std::size_t model) const;
    /// The model whose runs are simulated: another one where a mesh has been added.
    [[nodiscard]] std::size_t model_of(const std::vector<Applied>& applied) const;
    /// Switches effects on and sets numbers. @returns whether anything in the run has changed
    bool apply(const Applied& applied, std::size_t run, solver::Problem& problem) const;
    /// Runs of a model as they are, and with these inputs at the ends of their ranges.
    [[nodiscard]] std::vector<std::size_t> runs_of(std::size_t model, const std::vector<Applied>& applied) const;
    /// A run with an input at an end of its range, and how far towards it the input is moved.
    struct InputEnd {
        std::size_t run = 0;
        double share = 0.0;
    };
    /// Of the end to which it is moved; nothing where the input does not act on the run.
    [[nodiscard]] std::optional<InputEnd> run_at_end(const Applied& input, std::size_t run) const;
    /// What inputs change more with other additions in the runs than alone. @param table of runs with these in them
    [[nodiscard]] double more_by_inputs(const std::vector<Applied>& applied, const std::vector<ValidationRow>& table,
                                        std::size_t number) const;
    /// The channels of all runs of a model with additions in them.
    [[nodiscard]] RunResults run(const std::vector<Applied>& applied);
    /// @param places [chosen] where in the table's runs their results belong
    void simulate_runs(const std::vector<input::ValidationRun>& chosen, const std::vector<std::size_t>& places,
                       RunResults& into);
    void run_as_they_are(const std::vector<std::size_t>& runs);
    void read_instrument(const Applied& applied, RunResults& results) const;
    [[nodiscard]] std::string source_word(std::size_t number) const;

    const input::Validation& validation_;
    std::size_t model_;
    unsigned threads_;
    std::function<void(long)> progress_;
    long simulations_ = 0;
    RunResults base_;
    std::vector<ValidationRow> table_;
    std::vector<std::vector<Candidate>> candidates_;  ///< [runs] what may be added to each, of those as they are
};

}  // namespace tiretherm::diagnosis::quoted
