#pragma once

#include <functional>
#include <vector>

#include "input/measurements/experiment.hpp"
#include "hidden_effects/exam/exam_marks.hpp"

namespace hidden_effects {

/// A paper to be drawn.
struct Sheet {
    Kind kind = Kind::nothing;
    double sigma = 10.0;
    std::uint64_t seed = 0;
    const Rig* rig = &two_node_rig();
};

/// `count` sheets of consecutive seeds.
void add_sheets(std::vector<Sheet>& sheets, Kind kind, double sigma, std::uint64_t first_seed, int count,
                const Rig& rig = two_node_rig());

/// What the program reads of a paper: the bench's case with the paper's logs. @param finer as of input::read_experiment
[[nodiscard]] tiretherm::input::Experiment read_paper(const Paper& paper, int finer = 1);

/// The diagnosis of a paper as `tiretherm diagnose` makes it: a grid is held against one of half the spacing.
[[nodiscard]] tiretherm::diagnosis::Diagnosis diagnose_paper(const Paper& paper,
                                                             tiretherm::diagnosis::DiagnosisChoice choice = {});

/// Draws every paper, diagnoses it and marks it. A paper that throws is marked as failed, with the reason as its verdict.
/// @param threads papers at a time; each diagnosis has threads of its own over its runs
/// @param interval s, of the samples; 0: each bench's own  @param told called after each paper, one at a time
[[nodiscard]] std::vector<Mark> sit(const std::vector<Sheet>& sheets, int threads = 1, double interval = 0.0,
                                    const std::function<void(const Mark&)>& told = {});

}  // namespace hidden_effects
