#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exam_oracle_truth.hpp"
#include "table_truth.hpp"

namespace hidden_effects {

/// What a paper of the exam hides.
enum class Kind : std::uint8_t {
    nothing,
    single,        ///< a cause of the catalogue
    pair,          ///< two whose signatures correlate below 0.9
    unknown,       ///< heat that follows the throttle, in one of the lumps
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
};

/// Heat that no effect of the catalogue explains.
struct HiddenSource {
    std::string place;                 ///< "surface" or "bulk"
    std::vector<std::string> signals;  ///< that it follows together, as the log names them; none: a time window
    double watts = 0.0;                ///< at the signal's largest absolute value
    std::size_t run = 0;               ///< of a time window
    double from = 0.0;                 ///< s
    double to = 0.0;
};

/// Three logged runs with something hidden in them, or nothing, and the answer.
struct Paper {
    Kind kind = Kind::nothing;
    std::uint64_t seed = 0;
    double sigma = 0.0;                       ///< standard deviations at which an oracle sees each hidden thing
    BenchRuns runs;                           ///< what is true of the bench, but for what is hidden
    std::vector<Cause> hidden;                ///< of the catalogue
    std::vector<double> oracle;               ///< [n_hidden] standard deviations that were reached
    HiddenSource source{};                    ///< of an unknown
    std::vector<Likeness> alike{};            ///< the most like first; empty where nothing is hidden
    std::vector<std::vector<Column>> logs{};  ///< [n_runs]
    std::vector<std::string> rejected{};      ///< draws that were given up, and why
};

/// Draws a paper from its seed. Scales are normal about 1 with 0.07, each lump's temperature at the start normal about
/// the first air temperature with 2 K; a run has forty minutes. The same seed hides the same at every size, unless that
/// size is not physical.
/// @param interval s, of the samples  @errors std::runtime_error when nothing in 200 draws can be hidden at that size
[[nodiscard]] Paper draw_paper(Kind kind, double sigma, std::uint64_t seed, double interval = 2.0);

/// "sensor_lag of bulk_temperature + inner_gas", "heat after throttle in the surface", "nothing"
[[nodiscard]] std::string answer_of(const Paper& paper);

}  // namespace hidden_effects
