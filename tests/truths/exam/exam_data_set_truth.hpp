// SPDX-License-Identifier: BSD-3-Clause
// A data set of the exam: three logged runs of a bench with one or two hidden effects, an unknown heat source, or
// nothing.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exam/exam_oracle_truth.hpp"
#include "numerics/table_truth.hpp"

namespace hidden_effects {

/// What a data set of the exam hides.
enum class Kind : std::uint8_t {
    nothing,
    single,        ///< a cause of the catalogue
    pair,          ///< two whose signatures correlate below 0.9
    unknown,       ///< heat that follows a signal of the log, or the time, at one of the places that a bench offers
    unknown_odd,   ///< heat in a time window of one run, or after a combination of inputs that no effect has
    decoy,         ///< nothing, and one to three more columns that the model does not use
    dull_nothing,  ///< nothing, on a bench that holds one speed and one load
    dull_single    ///< a cause of the catalogue, on such a bench
};
[[nodiscard]] std::string word_of(Kind kind);
/// @errors std::invalid_argument lists the kinds
[[nodiscard]] Kind kind_from(const std::string& word);
[[nodiscard]] bool hides_nothing(Kind kind);
[[nodiscard]] bool is_unknown(Kind kind);

/// How like the hidden thing a single cause of the catalogue is, as the oracle sees both.
struct Likeness {
    const Variant* variant = nullptr;
    double correlation = 0.0;  ///< with its sign; of a cause that can be only one way, with that way

    [[nodiscard]] double strength() const { return variant->both_ways() ? std::abs(correlation) : correlation; }
};

/// Another hypothesis, and the standard deviations of what is hidden that it misses at its best.
struct ConfoundedHypothesis {
    std::string name;
    double apart = 0.0;
};

/// Heat that no effect of the catalogue explains.
struct HiddenSource {
    std::string id{};                  ///< of the truth
    std::string place;                 ///< "surface", "bulk"
    std::vector<std::string> or_at{};  ///< other names under which the program may know it, or a part of it
    std::vector<std::string> signals;  ///< that it follows together, as the log names them; none: a time window
    double watts = 0.0;                ///< at the signal's largest absolute value
    std::size_t run = 0;               ///< of a time window
    double from = 0.0;                 ///< s
    double to = 0.0;
};

/// Three logged runs with something hidden in them, or nothing, and the answer.
struct ExamDataSet {
    Kind kind = Kind::nothing;
    std::uint64_t seed = 0;
    double sigma = 0.0;          ///< standard deviations at which an oracle sees each hidden thing
    BenchRuns runs;              ///< what is true of the bench, but for what is hidden
    std::vector<Cause> hidden;   ///< of the catalogue
    std::vector<double> oracle;  ///< [n_hidden] standard deviations that were reached
    HiddenSource source{};       ///< of an unknown
    /// The most like first, of every cause; empty where nothing is hidden, and on a costly bench where likeness() tells.
    std::vector<Likeness> alike{};
    std::vector<std::vector<Column>> logs{};  ///< [n_runs]
    std::optional<ConfoundedHypothesis>
        confounded{};  ///< the nearest, of a pair on a bench whose truth is quick enough to look for it
    std::vector<std::string> rejected{};             ///< draws that were given up, and why
    std::shared_ptr<const Oracle> oracle_of_runs{};  ///< where something is hidden
    Eigen::VectorXd left{};                          ///< all that is hidden, as the oracle sees it
};

/// Draws a data set from its seed. What the user does not know is normal, as the rig says: scales about 1 with 0.07,
/// each temperature at the start about the first air temperature. The same seed hides the same at every size, unless
/// that size is not physical.
/// @param interval s, of the samples; 0: the bench's own
/// @errors std::runtime_error when nothing in 200 draws can be hidden at that size; std::invalid_argument when the bench
/// has no such data sets
[[nodiscard]] ExamDataSet draw_data_set(Kind kind, double sigma, std::uint64_t seed, double interval = 0.0,
                                        const Rig& rig = two_node_rig());

/// Drives the bench of two nodes of a data set once more, with what is hidden in it, and adds the log: a day, a start and
/// noise of its own, drawn from the data set's seed and the number of its runs. What the oracle saw stays as it was.
void add_run(ExamDataSet& data_set, const Drive& drive);

/// "sensor_lag of bulk_temperature + inner_gas", "heat after throttle in the surface", "nothing"
[[nodiscard]] std::string answer_of(const ExamDataSet& data_set);

}  // namespace hidden_effects
