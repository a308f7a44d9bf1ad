// SPDX-License-Identifier: BSD-3-Clause
// What a live session says and hears, without a network: messages in JSON that step the tires, and their temperatures.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "input/runs/reader.hpp"
#include "solver/real_time/tunable_session.hpp"

/// A case in real time behind a port: docs/live.md is its protocol.
namespace tiretherm::app::live {

using Json = nlohmann::ordered_json;
using InputValues = std::vector<std::pair<const physics::Signal*, double>>;

/// "{"errors": [...]}"
[[nodiscard]] Json refusal(const std::vector<std::string>& sentences);

/// The tires of a case, which begin and step together. All numbers are SI.
class LiveTires {
public:
    /// @param runs of a case: that of its tire, or one of each corner  @param at_all_corners the one tire stands at four corners
    LiveTires(const std::vector<input::RunOfCase>& runs, bool at_all_corners);

    /// Case, inputs and outputs with their units.
    [[nodiscard]] Json hello() const;
    /// Begins at the case's start, at the time and with the inputs of a message. @returns a frame, or a refusal after which
    /// nothing has changed
    [[nodiscard]] Json begin(const Json& message);
    /// Steps to the time of a message, where its inputs hold. @returns as begin; when a balance has no solution the tires must begin
    /// anew
    [[nodiscard]] Json step(const Json& message);
    /// Time and what the sensors read now.
    [[nodiscard]] Json frame() const;

private:
    struct Tire {
        std::string name;
        solver::TunableSession session;
    };
    struct Asked {
        double time = 0.0;
        std::vector<InputValues> values{};  ///< [tires]
        std::vector<std::string> errors{};
    };

    [[nodiscard]] Asked read(const Json& message) const;

    std::vector<Tire> tires_;
    double time_ = 0.0;  ///< s, of the simulator
    long steps_ = 0;
    bool is_broken_ = false;  ///< a step failed: some tires may be a step ahead
};

}  // namespace tiretherm::app::live
