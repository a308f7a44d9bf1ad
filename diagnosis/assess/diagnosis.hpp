// SPDX-License-Identifier: BSD-3-Clause
// Diagnosis of a model against measured data: the verdict, the causes with their sizes and confidence intervals, the
// unknown heat source, the gain on held-out data and the next experiment.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "diagnosis/data_faults/data_faults.hpp"
#include "diagnosis/detect/score_test_data.hpp"
#include "diagnosis/noise/noise_estimate.hpp"
#include "diagnosis/observations/observations.hpp"
#include "diagnosis/remarks/remark.hpp"
#include "input/measurements/experiment.hpp"
#include "input/parameters/mesh_change.hpp"
#include "physics/plausible_ranges.hpp"
#include "solver/status.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::diagnosis {

enum class Verdict : std::uint8_t {
    named,        ///< one hypothesis is left, a cause or a pair of causes
    confounded,   ///< several hypotheses that these data cannot tell apart
    unknown,      ///< something is missing that the catalogue does not have
    consistent,   ///< nothing significant is left
    cannot_tell,  ///< the grid, the steps or the data are too poor
    partial  ///< the largest improvement that there is: it leaves an error of the model, or is not proven by prediction
};
[[nodiscard]] std::string_view word_of(Verdict verdict);

/// A number of a cause, as it is fitted when the cause acts alone (or with its partner) beside the free parameters.
struct CauseNumber {
    std::string key;
    std::string unit;
    double value = 0.0;
    double low = 0.0;  ///< 95 %
    double high = 0.0;
    std::size_t fitted = 0;          ///< index of the fitted number that it follows, of the model with the cause
    double factor = 1.0;             ///< its value over that number's: companions of a number move in proportion
    std::optional<double> absent{};  ///< the value at which the cause is absent, of the number that is its size
};

enum class CauseKind : std::uint8_t { effect, mesh };

/// A possible reason for what the model gets wrong: an effect of the catalogue, or a mesh that is too coarse.
struct Cause {
    CauseKind kind = CauseKind::effect;
    std::string id;                      ///< of the effect; "mesh"
    std::string channel{};               ///< of a sensor's effect
    std::string run{};                   ///< that has it alone, with a number of its own; empty: all
    std::string place{};                 ///< layer or zone, where it acts on one of several; which meshes do better
    std::vector<CauseNumber> numbers{};  ///< that were fitted, and those it was tried at
    /// What the case says of the number, where the effect is on and its number is wrong.
    std::optional<double> instead_of{};
    double sigma = 0.0;        ///< standard deviations from no effect, or from what the case says
    double gain = 0.0;         ///< log likelihood ratio over the model without it
    double probability = 0.0;  ///< among the single hypotheses, before the data all alike
    bool in_set = false;
    int rank = 0;           ///< 1: the most likely
    bool at_bound = false;  ///< its number ended at its bound
    const physics::PlausibleRange* implausible =
        nullptr;  ///< the range that its number lies outside of; null: it does not

    /// Widens the interval of each number to what an error of the model leaves of it.
    /// @param half [n fitted numbers of the model] half widths
    void widen(const std::vector<double>& half);
    /// Whether the interval of its size holds the value at which it is absent.
    [[nodiscard]] bool may_be_absent() const;
};

/// Heat that no effect of the catalogue explains: where it enters and which signal it follows.
struct UnknownSource {
    std::string place;      ///< region, layer or zone; a channel where only the sensor can be wrong
    std::string follows{};  ///< a signal or a product of signals; "time window" of an event
    std::string unit{};     ///< of `per`
    double watts = 0.0;     ///< at the signal's largest absolute value in the runs, mean sign included
    double low = 0.0;
    double high = 0.0;
    double per = 0.0;  ///< W per unit of the signal
    double sigma = 0.0;
    double from = 0.0;  ///< s, of an event
    double to = 0.0;
    std::string run{};                 ///< of an event
    bool sensor = false;               ///< the readings change faster than heat could make them
    std::vector<std::string> alike{};  ///< other places and signals that do as well, "place, signal"
};

/// What a channel's readings differ from the extended model by beyond the sensor's noise.
struct ModelError {
    std::size_t channel = 0;  ///< index into Problem::channels
    double size = 0.0;        ///< SI, rms beyond the noise
    double time_scale = 0.0;  ///< s, its correlation time
    double noise = 0.0;       ///< SI, standard deviation of the sensor: stated, or else estimated

    /// By which channels of unlike quantities are compared.
    [[nodiscard]] double in_noise() const { return size / noise; }
};

/// A free number of the case in the extended model, with the interval that the errors of the model leave.
struct FreeNumber {
    std::string name;
    std::string unit;
    double value = 0.0;
    double low = 0.0;  ///< 95 %
    double high = 0.0;
};

/// What adding a hypothesis removes of the error on data that were left out.
struct HeldOutGain {
    std::vector<std::size_t> causes;  ///< indices into Diagnosis::causes
    double removed = 0.0;             ///< share of the mean square, mean over channels
    double low = 0.0;                 ///< 95 %
    double high = 0.0;
};

/// What a channel gains by the extension.
struct ChannelGain {
    std::size_t channel = 0;   ///< index into Problem::channels
    double rmse_before = 0.0;  ///< SI, with the fitted base model
    double rmse_after = 0.0;
    double heldout_before = 0.0;  ///< on runs or blocks that took no part; NaN when there were none
    double heldout_after = 0.0;
};

/// The model that an extension is measured against: the case as it stands, fitted, or on another mesh.
enum class BaseModel : std::uint8_t { none, correlated_noise, white_noise, as_it_stands, other_mesh };

/// The gain of the extension on data that took no part in naming or fitting.
struct Gain {
    bool measured = false;           ///< there was something to hold out
    bool within_run = false;         ///< blocks of one run, not whole runs
    double removable_removed = 0.0;  ///< 1 - (MSE after - sigma^2) / (MSE before - sigma^2)
    double low = 0.0;                ///< 95 %
    double high = 0.0;
    double log_e = 0.0;        ///< natural logarithm of the odds of the predictions; below zero when they got worse
    bool confirmed = false;    ///< odds of 100 and more, the error falls in every fold and its interval is above zero
    double removed = 0.0;      ///< share of the mean square, noise included, mean over the channels
    double removed_low = 0.0;  ///< 95 %
    double removed_high = 0.0;
    BaseModel over = BaseModel::none;
    std::string over_mesh{};
};

/// An experiment that would tell what these data do not.
struct NextExperiment {
    std::string name;   ///< "coast-down from 150 km/h, 5 min"
    double now = 0.0;   ///< standard deviations by which the hypotheses differ today
    double then = 0.0;  ///< with the experiment in addition
};

/// What a channel's error does on data that were left out. SI
struct ChannelChange {
    std::size_t channel = 0;  ///< index into Problem::channels
    double before = 0.0;      ///< rms
    double after = 0.0;
    double low = 0.0;  ///< 95 %, of before - after
    double high = 0.0;

    [[nodiscard]] double gain() const { return before - after; }
};

/// Why an addition to the model is not taken for a cause.
enum class AdditionDoubt : std::uint8_t {
    none,             ///< it predicts better beyond chance
    too_small,        ///< it removes next to nothing
    may_be_chance,    ///< the interval of what it removes reaches zero
    worsens_channel,  ///< another channel is predicted worse
    worsens_part,     ///< a recording, or a quarter of the only one, is predicted worse
    end_of_range,     ///< it wants a size at the end of what is plausible
    not_tested        ///< about its fit, others promise more
};

/// An addition to the model that was fitted, and what came of it on data that were left out.
struct TriedAddition {
    std::vector<Cause> causes;  ///< that were added, with their numbers
    std::size_t beside = 0;     ///< causes that were in the model before
    AdditionDoubt doubt = AdditionDoubt::none;
    double removed =
        0.0;  ///< share of the mean square, mean over channels; where it was not tested, to first order about the fit
    double low = 0.0;  ///< 95 %; NaN where it was not tested
    double high = 0.0;
    std::optional<ChannelChange>
        change{};  ///< of the channel that gains the largest share; nothing where it was not tested

    [[nodiscard]] bool is_tested() const { return change.has_value(); }
};

/// The same model on a richer mesh, without any cause, beside the case's own mesh on data that were left out.
struct RicherMesh {
    std::string name;        ///< "layers"
    bool is_better = false;  ///< beyond chance
    bool is_taken = false;   ///< the extended model has it
    double removed = 0.0;    ///< share of the mean square, mean over channels
    double low = 0.0;        ///< 95 %
    double high = 0.0;
    std::optional<ChannelChange> change{};  ///< of the channel that gains the largest share
    std::vector<FreeNumber> numbers{};      ///< as they are fitted on it
};

/// How large an effect could be without being seen, if nothing else is missing.
struct UpperLimit {
    std::string id;
    std::string channel{};
    std::string place{};  ///< layer
    std::string key;
    std::string unit;
    double low = 0.0;  ///< 95 %
    double high = 0.0;
    double absent = 0.0;  ///< at which it changes nothing
};

/// Missing heat at a place over a window of time, inferred from the data: what it would have to be, together with that in all other
/// windows, for the base model to fit, if it all enters at this place.
struct MissingHeat {
    std::size_t run = 0;
    std::string place;
    double from = 0.0;  ///< s
    double to = 0.0;
    double watts = 0.0;
    double deviation = 0.0;  ///< W, standard deviation, > 0

    [[nodiscard]] double low() const { return watts - 1.96 * deviation; }  ///< 95 %
    [[nodiscard]] double high() const { return watts + 1.96 * deviation; }
    [[nodiscard]] double sigma() const { return watts / deviation; }  ///< standard deviations from none, with its sign
};

/// A cause that would look like a free number in these data.
struct Lookalike {
    std::string cause;     ///< "load_input_gain"
    std::string key;       ///< of its number
    double value = 0.0;    ///< at which the free number would be what was known of it
    std::string number{};  ///< "strain_energy_loss.tan_delta_a"
    double fitted = 0.0;
    double known = 0.0;        ///< before
    double correlation = 0.0;  ///< of its signature with what the free numbers make of it
    bool is_input = false;     ///< a wrong input
    bool is_far = false;       ///< the number is by more than its standard deviation off what was known
};

/// Everything that a diagnosis found out.
struct Diagnosis {
    solver::Status status;  ///< of a run that failed; then nothing else holds
    Verdict verdict = Verdict::cannot_tell;
    std::vector<Cause> causes;  ///< every candidate, the most likely first
    std::vector<std::vector<std::size_t>>
        hypotheses;  ///< the set: indices into causes, one or two each, the best first
    std::optional<UnknownSource> unknown;
    std::optional<Remark> reason;           ///< why these data do not allow a diagnosis, where one is known
    std::vector<NextExperiment> next;       ///< the most telling first
    std::vector<std::string> told_apart;    ///< by them: names of the explanations
    std::vector<UpperLimit> limits;         ///< of all candidates that are not in the extended model
    std::vector<TriedAddition> tried;       ///< those first that remove most on data that were left out
    std::vector<RicherMesh> richer_meshes;  ///< that were tried
    std::size_t n_candidates = 0;           ///< causes that were looked for
    std::vector<MissingHeat> missing_heat;  ///< where and when, of the base model
    std::vector<ChannelGain> channels;
    Gain gain;
    double numerical_error_sigma = 0.0;
    std::vector<Noise> noise;                 ///< [Observations::channels]
    std::vector<ModelError> model_error;      ///< of channels that have one
    std::vector<FreeNumber> free_numbers;     ///< of the extended model, or of the base where there is none
    std::vector<HeldOutGain> held_out_gains;  ///< what was tested on data that were left out, the largest first
    std::vector<Lookalike> cannot_see{};      ///< that the free numbers may stand for, wrong inputs first
    Part stopped = Part::none;                ///< what was being done when time ran out; none: it came to its end
    Activity stopped_at{};                    ///< the piece of work at which it was stopped, where these are counted
    double rest_of_stage = 0.0;               ///< s, about what the stage would have taken still; NaN: not known
    Remarks remarks;
    Eigen::VectorXd values;    ///< [n_parameters] of the base fit
    Eigen::VectorXd base;      ///< [n_rows] SI, simulated with the fitted base model
    Eigen::VectorXd extended;  ///< [n_rows] SI, with the best hypothesis; equal to base where there is none
    /// The base experiment with the best hypothesis switched on, its numbers free after the experiment's own; nothing
    /// where nothing is to be switched on.
    std::optional<input::Experiment> extended_model;
    input::MeshChange extended_mesh{};  ///< of the case, where the extended model has a richer one
    Eigen::VectorXd extended_values;    ///< [n_parameters of extended_model] as fitted
    std::vector<solver::UserEffect> extended_user_effects{};  ///< user effects that the case itself lacks
    std::vector<DataFault> data_faults{};  ///< that were corrected before: all else is of the data without them
    long simulations = 0;
    double seconds = 0.0;

    /// The verdict with the faults of the data, which are causes: with them a model that agrees is `named`, and of a model that
    /// nothing helps they are what was found.
    [[nodiscard]] Verdict overall() const;
};

/// The same experiment on a richer mesh: what a coarse one gets wrong is a cause, too.
struct RicherModel {
    std::string name;  ///< "layers"
    const input::Experiment* experiment = nullptr;
    input::MeshChange change{};  ///< that makes it of the experiment's mesh
};

/// Takes the answer back where every cause of the set may be absent, by its interval, and left-out data do not confirm it.
/// @returns whether that was done: what follows the extended model is then to be described anew
bool withdraw_what_may_be_absent(Diagnosis& diagnosis);

struct DiagnosisOptions {
    bool measure_gain = true;
    /// The same experiment on a grid of half the spacing (read_experiment with finer = 2), where the model has a grid: what
    /// changes is taken for the grid's error and corrected.
    const input::Experiment* finer = nullptr;
    bool only_verdict = false;          ///< no missing heat, no name of its window, no next experiment
    std::vector<RicherModel> richer{};  ///< the same experiment on richer meshes, that coarseness may be a cause
    /// On grids that are finer than `finer`, taken only where the grid is too coarse to diagnose the data.
    std::vector<RicherModel> much_finer{};
    Progress progress{};
};

/// Fits the base model, estimates the discretisation error and the noise, and looks for what explains the rest.
[[nodiscard]] Diagnosis diagnose(const input::Experiment& experiment, const Observations& observations,
                                 const DiagnosisOptions& choice = {});

/// Adds the faults that were corrected in the data that were diagnosed. The extended case has the corrections, whether or not a
/// cause stands beside them. @param experiment that was diagnosed
void take_data_faults(DataFaults faults, const input::Experiment& experiment, Diagnosis& into);

}  // namespace tiretherm::diagnosis
