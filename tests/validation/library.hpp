// SPDX-License-Identifier: BSD-3-Clause
// Runs a case of the library as a user does and gives its channels at any time.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "input/validation/trace.hpp"
#include "solver/time_integration/march.hpp"

/// Cases of the library as a user runs them, and what they read.
namespace tiretherm::validation {

inline std::filesystem::path library() { return std::filesystem::path(TIRETHERM_SOURCE_DIR) / "cases"; }

/// A case that has been run.
class Experiment {
public:
    /// @param name below the library, without its ending: "handling/panic_stop_section"
    explicit Experiment(std::string_view name) {
        input::Reading reading = input::read_case(library() / (std::string(name) + ".toml"));
        EXPECT_TRUE(reading.problem.has_value()) << input::render(reading);
        if (!reading.problem) {
            return;
        }
        problem_ = std::move(*reading.problem);
        report_ = solver::run(problem_, [&](const solver::Snapshot& snapshot) {
            trace_.take(snapshot);
            return true;
        });
        EXPECT_TRUE(report_.status.ok()) << name << ": " << report_.status.message;
    }
    [[nodiscard]] const solver::MarchReport& report() const { return report_; }
    [[nodiscard]] const solver::Problem& problem() const { return problem_; }

    /// A channel at a time. @param t s
    [[nodiscard]] double at(std::string_view channel, double t) const {
        return read(channel, {.take = input::Window::Take::at, .from = t, .to = t});
    }
    /// Its largest value from a time on. @param t s
    [[nodiscard]] double highest_after(std::string_view channel, double t) const {
        return read(channel, {.take = input::Window::Take::max, .from = t, .to = problem_.settings.end});
    }
    /// Its mean over the last seconds of the run.
    [[nodiscard]] double mean_of_last(std::string_view channel, double seconds) const {
        const double end = problem_.settings.end;
        return read(channel, {.take = input::Window::Take::mean, .from = end - seconds, .to = end});
    }

private:
    [[nodiscard]] double read(std::string_view channel, const input::Window& window) const {
        const auto& channels = problem_.channels;
        const auto found =
            std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.name == channel; });
        if (found == channels.end() || trace_.rows() == 0) {
            ADD_FAILURE() << "no channel " << channel;
            return 0.0;
        }
        return trace_.read(static_cast<std::size_t>(found - channels.begin()), window);
    }

    solver::Problem problem_;
    solver::MarchReport report_;
    input::Trace trace_;
};

}  // namespace tiretherm::validation
