// SPDX-License-Identifier: BSD-3-Clause
// An answer as C has it: all texts and tables made when the call ends.
#pragma once

#include <string>
#include <vector>

#include "calls/outcome.hpp"
#include "interface/tiretherm_cases.h"

struct tiretherm_answer {
    /// One tire's run.
    struct Tire {
        tiretherm::calls::RecordedRows rows;
        std::vector<double> last{};  ///< [nodes] K
    };
    struct Fitted {
        std::string name;
        std::string unit;
        std::string word;
        double value;
        double low;
        double high;
    };

    std::string headline{};
    std::string page{};
    std::string json{};
    std::string notes{};
    std::vector<std::string> files{};
    std::vector<Tire> tires{};
    std::vector<Fitted> fitted{};
};

namespace tiretherm::interface {

/// Fills in what a call came to, but for its tires.
void take(const calls::Outcome& outcome, tiretherm_answer& answer);

/// Sentences, a line each.
[[nodiscard]] std::string in_lines(const std::vector<std::string>& sentences);

}  // namespace tiretherm::interface
