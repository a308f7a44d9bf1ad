// SPDX-License-Identifier: BSD-3-Clause
// Runs of a study: products of varied values, draws against their distributions, fingerprints, and errors at their
// place.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "input/studies/study.hpp"
#include "solver/time_integration/march.hpp"
#include "support/written.hpp"

// A study's runs are the case with the values of each run, and nothing else.
namespace tiretherm::input {

namespace {

const std::string two_node = (source_folder() / "cases/two_node/4000N_100kmh.toml").string();
const std::string section = (source_folder() / "cases/section/4000N_100kmh.toml").string();

std::string rendered(const StudyReading& reading) {
    return render(CaseFindings{.errors = reading.errors, .warnings = reading.warnings});
}

/// A study of a case of the library. @param rest its [[vary]] and [[draw]]
Study read(const Written& written, const std::string& rest, const std::string& of = two_node) {
    StudyReading reading = read_study(written.add("study.toml", "case = \"" + of + "\"\n" + rest));
    EXPECT_TRUE(reading.study.has_value()) << rendered(reading);
    return reading.study ? std::move(*reading.study) : Study{};
}

physics::Inputs drive(const Study& study, std::size_t run) {
    return study.problem(run).input_signals.at(0.0, solver::JumpSide::after);
}

double hottest(const Study& study, std::size_t run) {
    const solver::MarchReport report = solver::run(study.problem(run), [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return report.hottest.temperature - 273.15;
}

const std::string uncertain_air = R"([sample]
count = 400
[[draw]]
key = "drive.air_temperature"
distribution = "normal"
mean = "20 degC"
standard_deviation = "2 K"
)";

}  // namespace

// 60, 90 and 120 km/h are 16.667, 25 and 33.333 m/s; the first key is slowest.
TEST(Study, IsTheProductOfItsSidesInTheOrderTheyAreWritten) {
    const Written written;
    const Study study = read(written, R"([[vary]]
key = "drive.speed"
from = "60 km/h"
to = "120 km/h"
count = 3
[[vary]]
key = "drive.vertical_load"
values = ["3 kN", "5000 N"]
)");
    ASSERT_EQ(study.runs.size(), 6U);
    EXPECT_NEAR(drive(study, 0).speed, 60.0 / 3.6, 1e-12);
    EXPECT_DOUBLE_EQ(drive(study, 0).vertical_load, 3000.0);
    EXPECT_DOUBLE_EQ(drive(study, 1).vertical_load, 5000.0);
    EXPECT_NEAR(drive(study, 3).speed, 90.0 / 3.6, 1e-12);
    EXPECT_NEAR(drive(study, 5).speed, 120.0 / 3.6, 1e-12);
    // Shown in the unit of the first value, however the others are written.
    EXPECT_EQ(study.inputs[1].unit, "kN");
    EXPECT_DOUBLE_EQ(study.value(1, 1).number, 5.0);
    EXPECT_EQ(study.value(1, 1).text, "5000 N");
    EXPECT_EQ(study.value(2, 0).text, "90 km/h");
}

TEST(Study, LeavesTheCaseAsItIsWhereItVariesNothingElse) {
    const Written written;
    const Study study = read(written, "[[vary]]\nkey = \"drive.speed\"\nvalues = [\"100 km/h\"]\n");
    const Reading alone = read_case(two_node);
    ASSERT_EQ(study.runs.size(), 1U);
    ASSERT_TRUE(alone.problem.has_value());
    const solver::Problem problem = study.problem(0);
    EXPECT_EQ(problem.name, alone.problem->name);
    EXPECT_EQ(problem.initial, alone.problem->initial);
    EXPECT_EQ(problem.mesh.volume, alone.problem->mesh.volume);
    EXPECT_EQ(study.channels.size(), alone.problem->channels.size());
}

// A list's table is reported by its name, with blanks in it; a table that the case lacks is made.
TEST(Study, ReachesNamedTablesAndEffectsThatTheCaseDoesNotSpeakOf) {
    const Written written;
    const Study study = read(written,
                             R"([[vary]]
key = "mesh.layer.tread.thickness"
values = ["8 mm", "6 mm"]
[[vary]]
key = "material.tread rubber.density"
values = ["1200 kg/m3"]
[[vary]]
key = "effects.strain_energy_loss.tan_delta_a"
values = [2e15]
[[vary]]
key = "mesh.crown_cells"
values = [20]
)",
                             section);
    const solver::Problem thick = study.problem(0);
    const solver::Problem thin = study.problem(1);
    EXPECT_DOUBLE_EQ(thick.materials[0].density, 1200.0);
    EXPECT_LT(thin.mesh.total_volume(), thick.mesh.total_volume());
    EXPECT_LT(thick.mesh.n_cells, read_case(section).problem->mesh.n_cells);
    const auto loss = std::find_if(thick.effects.begin(), thick.effects.end(),
                                   [](const auto& e) { return e.effect->id == "strain_energy_loss"; });
    ASSERT_NE(loss, thick.effects.end());
    const auto key = std::find_if(loss->effect->parameters.begin(), loss->effect->parameters.end(),
                                  [](const physics::ParameterSpec& p) { return p.key == "tan_delta_a"; });
    EXPECT_DOUBLE_EQ((*loss)[static_cast<std::size_t>(key - loss->effect->parameters.begin())], 2e15);
}

TEST(Study, VariesWordsToo) {
    const Written written;
    const Study study = read(written, R"([[vary]]
key = "time.method"
values = ["tr_bdf2", "backward_euler"]
)");
    EXPECT_FALSE(study.inputs[0].is_number);
    EXPECT_EQ(study.problem(1).settings.method, solver::Method::backward_euler);
}

// 400 values of a normal distribution about 20 degC with 2 K: the mean lies within 4 x 2/sqrt(400) = 0.4 K of 20, the
// deviation within 4 x 2/sqrt(800) = 0.28 K of 2.
TEST(Study, DrawsWhatItsDistributionSays) {
    const Written written;
    const Study study = read(written, uncertain_air);
    ASSERT_EQ(study.runs.size(), 400U);
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t run = 0; run < study.runs.size(); ++run) {
        const double T = study.value(run, 0).number;
        sum += T;
        squares += (T - 20.0) * (T - 20.0);
    }
    EXPECT_NEAR(sum / 400.0, 20.0, 0.4);
    EXPECT_NEAR(std::sqrt(squares / 400.0), 2.0, 0.28);
    // What is shown is what is run, to the last digit.
    EXPECT_DOUBLE_EQ(drive(study, 7).air_temperature, study.value(7, 0).number + 273.15);
}

// Neither more samples nor another key nor a grid changes what a sample draws; another seed does.
TEST(Study, SampleDependsOnSeedIndexAndKeyAlone) {
    const Written written;
    const Study many = read(written, uncertain_air);
    std::string text = uncertain_air;
    text.replace(text.find("400"), 3, "3");
    const std::string other =
        "[[draw]]\nkey = \"drive.road_temperature\"\ndistribution = \"uniform\"\nfrom = \"10 degC\"\n"
        "to = \"30 degC\"\n";
    const std::string grid = "[[vary]]\nkey = \"drive.speed\"\nvalues = [\"80 km/h\", \"90 km/h\"]\n";
    const Study few = read(written, other + text + grid);
    ASSERT_EQ(few.runs.size(), 6U);
    for (std::size_t run = 0; run < 6; ++run) {
        EXPECT_EQ(few.value(run, 2).text, many.value(run % 3, 0).text);
    }
    text.insert(text.find("count"), "seed = 2\n");
    EXPECT_NE(read(written, text).value(0, 0).text, many.value(0, 0).text);
}

TEST(Study, FingerprintSeesValuesAndFilesButNotTheirLayout) {
    const Written written;
    written.add("base.toml", std::string(slab) + "[drive]\nair_temperature = \"20 degC\"\n");
    const std::string vary = "[[vary]]\nkey = \"drive.air_temperature\"\nvalues = [\"20 degC\", \"30 degC\"]\n";
    const auto prints = [&] {
        const Study study = read(written, vary, "base.toml");
        return std::pair(study.runs.at(0).fingerprint, study.runs.at(1).fingerprint);
    };
    const auto first = prints();
    EXPECT_NE(first.first, first.second);
    written.add("base.toml", "# a remark\ntitle = \"another\"\n" + std::string(slab) +
                                 "[drive]\nair_temperature   =   \"25 degC\"  # varied anyway\n");
    EXPECT_EQ(prints(), first);
    std::string denser(slab);
    denser.replace(denser.find("1100"), 4, "1101");
    written.add("base.toml", denser + "[drive]\nair_temperature = \"20 degC\"\n");
    EXPECT_NE(prints().first, first.first);
}

TEST(Study, FingerprintSeesTheContentOfALogThatTheCaseNames) {
    const Written written;
    written.add("base.toml",
                std::string(slab) + "[drive]\nair_temperature = \"20 degC\"\n[[drive.file]]\npath = \"log.csv\"\n");
    const std::string vary = "[[vary]]\nkey = \"initial.temperature\"\nvalues = [\"20 degC\"]\n";
    const auto print = [&](const char* log) {
        written.add("log.csv", log);
        return read(written, vary, "base.toml").runs.at(0).fingerprint;
    };
    const std::string before = print("time [s],road_temperature [degC]\n0,20\n60,21\n");
    EXPECT_EQ(print("time [s],road_temperature [degC]\n0,20\n60,21\n"), before);
    EXPECT_NE(print("time [s],road_temperature [degC]\n0,20\n60,22\n"), before);
}

TEST(Study, ReportsAnErrorOfTheCaseOnceAndAtItsPlace) {
    const Written written;
    written.add("base.toml", std::string(slab) + "[drive]\nair_temperature = \"20 N\"\n");
    const StudyReading reading = read_study(written.add(
        "study.toml",
        "case = \"base.toml\"\n[[vary]]\nkey = \"initial.temperature\"\nvalues = [\"20 degC\", \"30 degC\"]\n"));
    EXPECT_FALSE(reading.study.has_value());
    ASSERT_EQ(reading.errors.size(), 1U) << rendered(reading);
    EXPECT_TRUE(reading.errors[0].file.ends_with("base.toml"));
}

// The correlation of 400 pairs of independent numbers lies within 4/sqrt(400) = 0.2 of 0.
TEST(Draw, KeysAreDrawnIndependently) {
    double product = 0.0;
    for (std::uint64_t sample = 0; sample < 400; ++sample) {
        product += 12.0 * (draw(1, sample, "drive.speed") - 0.5) * (draw(1, sample, "drive.camber") - 0.5);
    }
    EXPECT_LT(std::abs(product / 400.0), 0.2);
}

TEST(Distribution, QuantilesAreThoseOfTheTables) {
    // Standard normal: 97.5 % at 1.959964. A lognormal quantity of mean 1 and deviation 1 has the median 1/sqrt(2).
    EXPECT_NEAR((Distribution{.spread = Spread::normal, .a = 10.0, .b = 2.0}.quantile(0.975)), 10.0 + 2.0 * 1.959964,
                1e-5);
    EXPECT_NEAR((Distribution{.spread = Spread::lognormal, .a = 1.0, .b = 1.0}.quantile(0.5)), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR((Distribution{.spread = Spread::uniform, .a = 2.0, .b = 6.0}.quantile(0.25)), 3.0, 1e-12);
}

// Half a normal distribution, cut at its mean: the median of the rest is its upper quartile, 0.674490 deviations up.
TEST(Distribution, IsCutWithoutPilingUpAtItsBounds) {
    const Distribution half{.spread = Spread::normal, .a = 0.0, .b = 1.0, .low = 0.0};
    EXPECT_NEAR(half.kept(), 0.5, 1e-12);
    EXPECT_NEAR(half.quantile(0.5), 0.674490, 1e-6);
    EXPECT_GT(half.quantile(1e-6), 0.0);
}

// What the shipped studies promise. Every one is read with all of its runs; the numbers are those of the cases alone, from
// an independent integration, printed to 0.1 K (half a digit and the stepper's 0.01 K).
TEST(ShippedStudies, EveryOneIsSound) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "cases/studies")) {
        if (entry.path().extension() == ".toml") {
            const StudyReading reading = read_study(entry.path());
            EXPECT_TRUE(reading.study.has_value()) << rendered(reading);
            EXPECT_TRUE(reading.warnings.empty()) << rendered(reading);
            ++count;
        }
    }
    EXPECT_EQ(count, 8U);
}

TEST(ShippedStudies, SpeedAndLoadOfTwoNodesMeetTheCasesOfTheLibrary) {
    const StudyReading reading = read_study(source_folder() / "cases/studies/speed_and_load_two_node.toml");
    ASSERT_TRUE(reading.study.has_value()) << rendered(reading);
    const Study& study = *reading.study;
    const auto at = [&](const char* speed, const char* load) {
        for (std::size_t run = 0; run < study.runs.size(); ++run) {
            if (study.value(run, 0).text == speed && study.value(run, 1).text == load) {
                return hottest(study, run);
            }
        }
        ADD_FAILURE() << "no run at " << speed << " and " << load;
        return 0.0;
    };
    EXPECT_EQ(study.runs.size(), 63U);
    EXPECT_NEAR(at("100 km/h", "4000 N"), 64.0, 0.06);
    EXPECT_NEAR(at("100 km/h", "7000 N"), 80.6, 0.06);
}

// 3600 s in steps of 0.1 and of 0.2 ms are 3.6e7 and 1.8e7 pieces: one warning, of two of the three runs.
TEST(Study, AWarningOfSeveralRunsIsSaidOnceWhateverItsNumbers) {
    const Written written;
    const StudyReading reading = read_study(written.add("study.toml", "case = \"" + two_node + R"("
[[vary]]
key = "time.step"
values = ["0.1 ms", "0.2 ms", "1 s"]
)"));
    std::vector<std::string> of_pieces;
    std::ranges::copy_if(reading.warnings, std::back_inserter(of_pieces),
                         [](const std::string& one) { return one.find(" pieces") != std::string::npos; });
    ASSERT_EQ(of_pieces.size(), 1U) << rendered(reading);
    EXPECT_TRUE(of_pieces.front().ends_with(
        "step divides the run into 3.6e+07 pieces (in 2 of 3 runs, with numbers of their own)"))
        << of_pieces.front();
}

}  // namespace tiretherm::input
