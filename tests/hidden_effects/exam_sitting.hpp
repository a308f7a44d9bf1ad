#pragma once

#include <functional>
#include <vector>

#include "cases/experiment.hpp"
#include "hidden_effects/exam_marks.hpp"

namespace hidden_effects {

/// A paper to be drawn.
struct Sheet {
    Kind kind = Kind::nothing;
    double sigma = 10.0;
    std::uint64_t seed = 0;
};

/// `count` sheets of consecutive seeds.
void add_sheets(std::vector<Sheet>& sheets, Kind kind, double sigma, std::uint64_t first_seed, int count);

/// What the program reads of a paper: cases/practice/two_node_bench.toml with its logs.
[[nodiscard]] tiretherm::cases::Experiment read_paper(const Paper& paper);

/// Draws every paper, diagnoses it and marks it. A paper that throws is marked as failed, with the reason as its verdict.
/// @param threads papers at a time; each diagnosis has threads of its own over its runs
/// @param interval s, of the samples  @param told called after each paper, one at a time
[[nodiscard]] std::vector<Mark> sit(const std::vector<Sheet>& sheets, int threads = 1, double interval = 2.0,
                                    const std::function<void(const Mark&)>& told = {});

}  // namespace hidden_effects
