#pragma once

#include <vector>

#include "diagnosis/detect/evidence.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::diagnosis {

/// One or more causes taken as true: the model with them, fitted in full, and what it leaves.
struct Explanation {
    std::vector<std::size_t> candidates;  ///< indices into Evidence::candidates, one of each cause
    input::Experiment model;              ///< with the causes switched on, their numbers free after its own
    Refit fit;
    double gain = 0.0;             ///< log likelihood ratio over the base model
    double loudest = 0.0;          ///< largest score that is left among the candidates
    double loudest_unknown = 0.0;  ///< and among the unknown sources
    bool quiet = false;            ///< neither is beyond chance
    bool sound = false;            ///< the fit ended, with every number on the side that physics allows

    Eigen::Index n_held = 0;  ///< numbers that causes hold on trial, free after all others

    /// Index of a cause's number among the fitted ones. @param i index into `candidates`
    [[nodiscard]] Eigen::Index number_of(std::size_t i) const;
};

/// Switches causes on and fits. @param amplitudes where their numbers start
[[nodiscard]] Explanation explain(Evidence& evidence, const std::vector<std::size_t>& candidates,
                                  const std::vector<double>& amplitudes);

/// Every cause alone that the straight picture does not rule out, fitted: the most likely first.
[[nodiscard]] std::vector<Explanation> explain_by_one(Evidence& evidence);
/// Pairs of causes, likewise. @param least_gain pairs that promise less are left out
[[nodiscard]] std::vector<Explanation> explain_by_two(Evidence& evidence, double least_gain);

/// Heat that no effect of the catalogue is, as a source of the user's own at a place, following a signal or over a window
/// of one run; fitted in full. Its number, W, comes after the experiment's. Sensors have no such model: not sound.
[[nodiscard]] Explanation explain_unknown(Evidence& evidence, std::size_t term, double watts);
/// What is switched on for it in a run.
[[nodiscard]] solver::UserEffect user_effect(const Evidence& evidence, std::size_t term, std::size_t run);

/// The noise beside the best explanation instead of beside the base model, where a large cause has bent the picture.
/// @returns whether anything changed
bool settle_noise(Evidence& evidence, const Explanation& best);

}  // namespace tiretherm::diagnosis
