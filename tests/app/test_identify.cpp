// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm identify` on made-up logs: intervals contain the true values, the fitted case runs and gives the fit, bad
// input is refused.

#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string bench = cases + "practice/two_node_bench.toml";

/// A folder, and fits whose files go there.
struct Fits {
    input::Written written;

    [[nodiscard]] std::string file(const std::string& name) const { return (written.folder() / name).string(); }
    [[nodiscard]] Call identify(const std::string& case_file, const std::string& arguments = "") const {
        return call("identify " + case_file + " --out " + file("out") + " " + arguments);
    }
};

const Json& number(const Json& fit, const std::string& name) {
    static const Json none;
    const Json& numbers = fit["parameters"];
    const auto found = std::ranges::find_if(numbers, [&](const Json& one) { return one["name"] == name; });
    EXPECT_NE(found, numbers.end()) << name;
    return found == numbers.end() ? none : *found;
}

bool holds(const Json& interval, double truth) {
    return interval["low"].get<double>() <= truth && truth <= interval["high"].get<double>();
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++n;
    }
    return n;
}

/// The bench's case, its files named so that it can lie anywhere.
std::string bench_text() {
    std::string text = post::read_text(bench);
    text.replace(text.find("../tires"), 8, cases + "tires");
    for (std::size_t at = text.find("file = \""); at != std::string::npos; at = text.find("file = \"", at + 1)) {
        text.insert(at + 8, cases + "practice/");
    }
    return text;
}

/// The bench's runs on a case that frees nothing.
std::string nothing_free() {
    std::string text = bench_text();
    const std::size_t first = text.find("[[parameter]]");
    text.erase(first, text.find("[[run]]") - first);
    return text;
}

// A log of the bench whose last column is whatever a test asks for.
std::string log_with(const std::string& last_heading) {
    return "time [s],speed [km/h],vertical_load [N],slip_angle [deg],lateral_force [N],air_temperature [degC],"
           "road_temperature [degC]," +
           last_heading + "\n0,0,0,0,0,20,20,20\n10,50,4000,0,0,20,20,20\n";
}

TEST(Identify, EndsWithAPageAndItsFiles) {
    const Fits fits;
    const Call fit = fits.identify(bench);
    EXPECT_EQ(fit.exit_code, 0);
    EXPECT_EQ(fit.err, "");
    EXPECT_EQ(fit.out.find('\033'), std::string::npos);
    // 2 numbers of effects and 2 starts for each of 3 runs; 601 samples of 2 channels in each
    EXPECT_TRUE(fit.out.starts_with("Bench of two nodes, runs of forty minutes\n")) << fit.out;
    EXPECT_LT(fit.out.find(" (95 %: "), fit.out.find("\n8 parameters fitted to 3 runs, 3 606 values\n")) << fit.out;
    for (const char* section : {"\nParameters\n", "\nFit\n", "\nFiles\n"}) {
        EXPECT_NE(fit.out.find(section), std::string::npos) << section << fit.out;
    }
    for (const char* name : {"identified.toml", "identify.csv", "parameters.csv"}) {
        EXPECT_GT(std::filesystem::file_size(fits.written.folder() / "out" / name), 100u);
        EXPECT_NE(fit.out.find(name), std::string::npos);
    }
    EXPECT_EQ(count(post::read_text(fits.file("out/identify.csv")), "\n"), 1u + 3606u);
}

// The runs are made up with lambda_h = 1.05 and lambda_SEL = 0.93, noise of 0.5 and 0.3 K (cases/practice/README.md).
// The noise lasts some 10 s: 7 200 s of it are worth 700 independent samples, which tell a standard deviation to
// 1/sqrt(2 700) = 2.7 %. 10 % are beyond three times that.
TEST(Identify, FindsTheNumbersOfTheBenchAgain) {
    const Fits fits;
    const Call fit = fits.identify(bench, "--json");
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    const Json json = Json::parse(fit.out);
    EXPECT_TRUE(json["converged"]);
    EXPECT_EQ(json["runs"].size(), 3u);
    ASSERT_EQ(json["parameters"].size(), 8u);
    ASSERT_EQ(json["channels"].size(), 2u);
    EXPECT_EQ(json["outputs"].size(), 5u);
    const Json& film = number(json, "air_convection.lambda_h");
    EXPECT_TRUE(holds(film, 1.05)) << film;
    EXPECT_EQ(film["identifiability"], "determined");
    // The prior of 0.1 by itself gives an interval of 0.39; one that is hardly narrower would hold the truth by no merit.
    EXPECT_LT(film["high"].get<double>() - film["low"].get<double>(), 0.039);
    EXPECT_TRUE(holds(number(json, "strain_energy_loss.tan_delta_a"), 0.93 * 2.14e15));
    EXPECT_NEAR(json["channels"][0]["sigma"], 0.5, 0.05);
    EXPECT_NEAR(json["channels"][1]["sigma"], 0.3, 0.03);
}

// The film's scale is 1.05 in truth, which the data know to 0.003. Who says that it is 1 to 0.01 is 5 standard deviations
// off, and reads it once on the page and once in the JSON. With the 0.1 of the shipped case nothing is unexpected.
TEST(Identify, AConflictWithWhatWasKnownIsAFinding) {
    const Fits fits;
    const Json as_shipped = Json::parse(fits.identify(bench, "--json").out);
    EXPECT_TRUE(as_shipped["findings"].empty()) << as_shipped["findings"];
    EXPECT_EQ(as_shipped["intervals_widened"], 1.0);
    EXPECT_EQ(as_shipped["channels"][0]["in_doubt"], false);
    std::string text = bench_text();
    const std::string prior = "standard_deviation = 0.1\n";
    text.replace(text.find(prior), prior.size(), "standard_deviation = 0.01\n");
    const std::string file = fits.written.add("sure.toml", text).string();
    const Json json = Json::parse(fits.identify(file, "--json").out);
    ASSERT_EQ(json["findings"].size(), 1u) << json["findings"];
    const auto finding = json["findings"][0].get<std::string>();
    EXPECT_TRUE(finding.starts_with("air_convection.lambda_h: the data pull it to 1.05, ")) << finding;
    EXPECT_NE(finding.find("standard deviations above the 1 +- 0.01 that were known before"), std::string::npos)
        << finding;
    const std::string page = fits.identify(file).out;
    EXPECT_EQ(count(page, "\nFindings\n"), 1u) << page;
    EXPECT_EQ(count(page, "the data pull it to 1.05"), 1u) << page;
}

// identified.toml includes the case and lays the fitted values over it, with all their digits: as it stands it runs, and
// compare finds the same rms as the fit ended with. Steps are chosen anew, within 0.01 K each.
TEST(Identify, TheFittedCaseRunsAsItIs) {
    const Fits fits;
    const Json json = Json::parse(fits.identify(bench, "--json").out);
    const std::string identified = fits.file("out/identified.toml");
    const Call check = call("check " + identified);
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_TRUE(check.out.starts_with("identified: no errors\n")) << check.out;
    const Call compare = call("compare " + identified + " --json --out " + fits.file("again"));
    ASSERT_EQ(compare.exit_code, 0) << compare.err;
    const Json compared = Json::parse(compare.out);
    for (std::size_t c = 0; c < 2; ++c) {
        EXPECT_NEAR(compared["channels"][c]["rmse"].get<double>(), json["channels"][c]["rmse_after"].get<double>(),
                    0.01);
        EXPECT_LT(compared["channels"][c]["rmse"], json["channels"][c]["rmse_before"]);
    }
}

// Three temperatures, four numbers (cases/two_node/README.md). The link's value is this program's own: a change must be
// meant. Priors of 0.2 and 350 W/m2K come out as they went in, to five and one percent.
TEST(Identify, SaysWhatThreeTemperaturesDoNotTell) {
    const Fits fits;
    const Call fit = fits.identify(cases + "two_node/identify_saturation.toml", "--json");
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    const Json json = Json::parse(fit.out);
    ASSERT_EQ(json["parameters"].size(), 4u);
    const Json& link = number(json, "link.conductivity at 70 degC");
    EXPECT_EQ(link["identifiability"], "determined");
    EXPECT_NEAR(link["value"], 1.667, 0.01);
    for (const char* name : {"air_convection.lambda_h", "strain_energy_loss.tan_delta_a", "road_contact.Hc"}) {
        EXPECT_EQ(number(json, name)["identifiability"], "prior only") << name;
    }
    EXPECT_NEAR(number(json, "air_convection.lambda_h")["standard_deviation"], 0.2, 0.01);
    EXPECT_NEAR(number(json, "road_contact.Hc")["standard_deviation"], 350.0, 3.5);
    ASSERT_EQ(json["numbers"].size(), 3u);
}

// A plan assumes 0.5 and 0.3 K, 70 % of the variance forgotten over 10 s; found are 0.484 and 0.307 K over 7 and 11 s. What
// lasts 7 s instead of 10 s makes a long mean sqrt(0.7) = 0.84 as uncertain, and 3 % come from 0.484 K: 20 % hold both.
TEST(Identify, APlanForeseesTheIntervals) {
    const Fits fits;
    const Json fitted = Json::parse(fits.identify(bench, "--json").out);
    std::filesystem::remove_all(fits.file("out"));
    const Call call = fits.identify(bench, "--plan --json");
    ASSERT_EQ(call.exit_code, 0) << call.err;
    const Json plan = Json::parse(call.out);
    EXPECT_TRUE(plan["planned"]);
    ASSERT_EQ(plan["parameters"].size(), 8u);
    for (const Json& number_of_plan : plan["parameters"]) {
        const double foreseen = number_of_plan["standard_deviation"];
        const double found = number(fitted, number_of_plan["name"])["standard_deviation"];
        EXPECT_NEAR(foreseen, found, 0.2 * found) << number_of_plan["name"];
    }
    EXPECT_TRUE(std::filesystem::exists(fits.written.folder() / "out" / "plan.json"));
    EXPECT_FALSE(std::filesystem::exists(fits.written.folder() / "out" / "identified.toml"));
    const Call page = fits.identify(bench, "--plan");
    EXPECT_NE(page.out.find("nothing was measured"), std::string::npos) << page.out;
}

TEST(Identify, ACaseThatFreesNothingIsRefused) {
    const Fits fits;
    const std::string file = fits.written.add("nothing_free.toml", nothing_free()).string();
    const Call fit = fits.identify(file);
    EXPECT_EQ(fit.exit_code, 1);
    EXPECT_EQ(fit.out, "");
    EXPECT_EQ(fit.err, "tiretherm: " + file +
                           ": no parameter of the case is free; name those to be fitted: [[parameter]], see "
                           "cases/README.md\n");
    EXPECT_EQ(call("compare " + file + " --out " + fits.file("out")).exit_code, 0);  // it is a sound case otherwise
}

TEST(Identify, ACaseThatMeasuresNothingIsRefused) {
    const Call fit = call("identify " + two_node);
    EXPECT_EQ(fit.exit_code, 1);
    EXPECT_EQ(fit.err, two_node +
                           ": the case has no measured run\n    remedy: add [[run]] with file = \"....csv\", or give "
                           "files beside the case: --data run.csv\n1 error; nothing was fitted\n");
}

TEST(Identify, WrongDataAreToldAndEndWith1) {
    const Fits fits;
    const Call missing = fits.identify(bench, "--data " + fits.file("missing.csv"));
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.err.find("missing.csv: the file cannot be read: No such file or directory"), std::string::npos)
        << missing.err;

    const std::string watts = fits.written.add("watts.csv", log_with("bulk_temperature [W]")).string();
    const std::string message = "the column bulk_temperature is in [W], a power; a temperature is wanted";
    const Call unit = fits.identify(bench, "--data " + watts);
    EXPECT_EQ(unit.exit_code, 1);
    EXPECT_EQ(unit.out, "");
    EXPECT_NE(unit.err.find("watts.csv:1:123: " + message), std::string::npos) << unit.err;
    EXPECT_NE(unit.err.find("1 error; nothing was fitted"), std::string::npos) << unit.err;
    const Call json = fits.identify(bench, "--json --data " + watts);
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_EQ(Json::parse(json.out)["errors"][0]["message"], message);

    const std::string unread = fits.written.add("unread.csv", log_with("throttle [-]")).string();
    const Call nothing = fits.identify(bench, "--data " + unread);
    EXPECT_EQ(nothing.exit_code, 1);
    EXPECT_NE(nothing.err.find("the run unread measures nothing"), std::string::npos) << nothing.err;
    EXPECT_FALSE(std::filesystem::exists(fits.written.folder() / "out"));
}

TEST(Identify, AFileIsNoPlaceForFiles) {
    const Fits fits;
    const std::string file = fits.written.add("taken", "a file\n").string();
    const Call fit = call("identify " + cases + "two_node/identify_saturation.toml --out " + file);
    EXPECT_EQ(fit.exit_code, 1);
    EXPECT_EQ(fit.err, "tiretherm: cannot create the directory " + file +
                           ": Not a directory; nothing was fitted; choose another directory with --out\n");
    EXPECT_EQ(post::read_text(file), "a file\n");
}

TEST(Identify, HelpHasAnExample) {
    const Call help = call("identify --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("tiretherm identify cases/practice/two_node_bench.toml"), std::string::npos);
}

// The page of cases/laser: the thesis's four temperatures fix K1 and say next to nothing of the rest.
TEST(IdentifyLong, FourTemperaturesFixOneConductivity) {
    const Fits fits;
    const Call fit = fits.identify(cases + "laser/quoted_numbers.toml", "--json");
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    const Json json = Json::parse(fit.out);
    EXPECT_NEAR(number(json, "K1.conductivity at 90 degC")["value"], 1.204, 0.005);
    EXPECT_NEAR(number(json, "K2.conductivity at 90 degC")["value"], 0.0749, 0.001);
    for (const char* name : {"laser.absorptivity", "still_air.h"}) {
        EXPECT_EQ(number(json, name)["identifiability"], "prior only") << name;
    }
}

// The true numbers of cases/laser/README.md. Of 13 intervals that are right in 95 of 100 cases, 11 or more hold in 97
// of 100 experiments; these data are fixed.
TEST(IdentifyLong, TheLasersIntervalsHoldTheTruth) {
    const Fits fits;
    const Call fit = fits.identify(cases + "laser/identify.toml", "--json");
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    const Json json = Json::parse(fit.out);
    constexpr std::array truth{0.50, 0.95, 1.30, 0.066, 0.075, 0.082, 0.95, 5.60e-3, 11.0, 8.5, 0.4, -0.3, 0.2};
    ASSERT_EQ(json["parameters"].size(), truth.size());
    int held = 0;
    for (std::size_t j = 0; j < truth.size(); ++j) {
        held += holds(json["parameters"][j], truth[j]) ? 1 : 0;
    }
    EXPECT_GE(held, 11);
    EXPECT_EQ(number(json, "laser.absorptivity")["identifiability"], "with prior");
}

}  // namespace
}  // namespace tiretherm::app_test
