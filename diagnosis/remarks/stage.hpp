// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis is doing, for whoever waits for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace tiretherm::diagnosis {

/// Parts of a diagnosis, in their order.
enum class Part : std::uint8_t { none, score_tests, grid_error, causes, missing_heat, gain, next_experiment };

/// A piece of work of a part.
enum class Work : std::uint8_t {
    none,
    fitting_case,
    signatures,  ///< of `count` candidates together
    signature,
    unknown_heat,
    noise,
    candidate,
    looking_back,
    prediction,
    left_out_data,
    other_mesh,
    unknown_source,
    next_experiment
};

/// Simulations that are still to come.
struct WorkAhead {
    long least = 0;  ///< where nothing more is found
    long most = 0;   ///< where all that is allowed is; 0: nobody knows
};

/// What is being done: candidate 7 of 23, sidewall_convection.
struct Activity {
    Work doing = Work::none;
    std::string of{};        ///< "sidewall_convection"; empty where there is nothing to name
    std::size_t number = 0;  ///< of `count` equal pieces of work, from 1; 0: it is one piece, as long as it takes
    std::size_t count = 0;
    std::string run{};  ///< that is diagnosed alone; empty: all
    WorkAhead ahead{};  ///< when this piece begins

    [[nodiscard]] bool is_counted() const { return number > 0; }
};

/// Progress: the stage, and how many runs were simulated so far.
using Progress = std::function<void(const Activity& stage, long simulations)>;

}  // namespace tiretherm::diagnosis
