#include <vector>

#include "validation/library.hpp"

// The heat stored is the heat booked to the effects, in each experiment, to round-off.
namespace tiretherm::validation {

namespace {

namespace fs = std::filesystem;

/// Every case of the experiments, on whatever mesh.
std::vector<std::string> experiments() {
    std::vector<std::string> found;
    for (const char* folder : {"flat_trac", "drum", "oval_track", "handling", "section"}) {
        for (const auto& entry : fs::directory_iterator(library() / folder)) {
            const std::string stem = entry.path().stem().string();
            if (entry.path().extension() == ".toml" && !stem.ends_with("common")) {
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

TEST_P(ShippedExperiment, ClosesItsEnergy) {
    const Experiment run(GetParam());
    EXPECT_LE(run.report().energy_closure, 1e-10);
    EXPECT_GT(run.report().steps, 0);
}
INSTANTIATE_TEST_SUITE_P(All, ShippedExperiment, testing::ValuesIn(experiments()), test_name);

}  // namespace tiretherm::validation
