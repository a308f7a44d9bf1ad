// SPDX-License-Identifier: BSD-3-Clause
// Every experiment of the library closes its energy balance, and the section cases end at their recorded temperatures.

#include <vector>

#include "validation/library.hpp"
#include "validation/section_ends.hpp"

// Each experiment of the library as a user runs it: the heat stored is that of the effects, to round-off; on
// the section it ends where it did, so that a change of its numbers must be meant (those of the two-node cases stand in
// their headers and in test_two_node_cases.cpp).
namespace tiretherm::validation {

namespace {

namespace fs = std::filesystem;

/// Every case of the experiments, on whatever mesh.
std::vector<std::string> experiments() {
    std::vector<std::string> found;
    for (const char* folder : {"flat_trac", "drum", "oval_track", "handling", "section"}) {
        for (const auto& entry : fs::directory_iterator(library() / folder)) {
            const std::string stem = entry.path().stem().string();
            // What a diagnosis is given is no experiment of its own.
            if (entry.path().extension() == ".toml" && !stem.ends_with("common") && !stem.starts_with("diagnose")) {
                found.push_back(std::string(folder) + "/" + stem);
            }
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '/' || c == '-'; }, '_');
    return name;
}

class ShippedExperiment : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(ShippedExperiment, ClosesItsEnergyAndEndsWhereItDid) {
    const Experiment run(GetParam());
    EXPECT_LE(run.report().energy_closure, 1e-10);
    EXPECT_GT(run.report().steps, 0);
    if (GetParam().ends_with("_two_node")) {
        return;
    }
    const auto end = std::find_if(section_ends.begin(), section_ends.end(),
                                  [](const SectionEnd& one) { return one.name == GetParam(); });
    ASSERT_NE(end, section_ends.end()) << "add its numbers to section_ends.hpp";
    constexpr double rounding = 0.06;  // of 0.1 K, and the stepper's tolerance
    EXPECT_NEAR(run.at("bulk_temperature", 1e9) - 273.15, end->final_bulk, rounding);
    EXPECT_NEAR(run.at("inner_liner_temperature", 1e9) - 273.15, end->final_liner, rounding);
}
INSTANTIATE_TEST_SUITE_P(All, ShippedExperiment, testing::ValuesIn(experiments()), test_name);

}  // namespace tiretherm::validation
