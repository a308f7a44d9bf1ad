// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run`: summary, JSON, files, options, errors, numerical failure and Ctrl-C; temperatures against an
// independent integration.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

TEST(Run, EndsWithASummaryAndSilenceOnStderr) {
    const sample::Scratch scratch;
    const Call run = call("run " + two_node + " --out " + scratch.path().string());
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");  // no progress, no colours where nobody looks
    EXPECT_EQ(run.out.find('\033'), std::string::npos);
}

TEST(Run, LeavesTheFilesThatItNames) {
    const sample::Scratch scratch;
    const Call run = call("run " + two_node + " --json --out " + scratch.path().string());
    const Json json = Json::parse(run.out);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(json["outputs"].size(), 6u);
    for (const std::string file : json["outputs"]) {
        EXPECT_GT(std::filesystem::file_size(file), 100u) << file;
    }
    EXPECT_TRUE(post::read_text(scratch / "channels.csv")
                    .starts_with("time [s],surface_temperature [degC],bulk_temperature [degC]\n"));
}

TEST(Run, JsonIsOneObjectWithTheAgreedKeys) {
    const sample::Scratch scratch;
    const Json json = Json::parse(call("run " + two_node + " --json --out " + scratch.path().string()).out);
    EXPECT_EQ(json["case"], "two_node/4000N_100kmh");
    EXPECT_EQ(json["cells"], 2);
    EXPECT_EQ(json["simulated_seconds"], 3600.0);
    EXPECT_LT(json["energy_closure"], 1e-10);
    EXPECT_EQ(json["channels"][1]["name"], "bulk_temperature");
    // What an independent integration of the thesis's equations gives, to 0.1 K.
    EXPECT_NEAR(json["channels"][0]["final"], 38.3, 0.06);
    EXPECT_NEAR(json["channels"][1]["final"], 64.0, 0.06);
    EXPECT_EQ(json["hottest"]["layer"], "bulk");
    for (const char* key : {"steps", "factorisations", "seconds", "budget", "outputs"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
}

// The page's field is marked with seven digits.
TEST(Run, SummaryAndPageTellOneHotSpot) {
    const sample::Scratch scratch;
    const Json json =
        Json::parse(call("run --json --no-vtk " TIRETHERM_SOURCE_DIR "/cases/section/7500N_150kmh.toml --out " +
                         scratch.path().string())
                        .out);
    const std::string page = post::read_text(scratch / "report.html");
    const std::size_t kind = page.find("{\"kind\":\"field\"");
    ASSERT_NE(kind, std::string::npos);
    const Json field = Json::parse(page.substr(kind, page.find("</script>", kind) - kind));
    const double marked = field["marks"][field["hottest"].get<std::size_t>()][2];
    EXPECT_NEAR(marked, json["hottest"]["temperature"].get<double>(), 1e-5);
}

TEST(Run, WritesBelowOutInTheCurrentDirectoryUnlessTold) {
    const sample::Scratch scratch;
    EXPECT_EQ(call("run --no-vtk --quiet " + two_node, scratch.path()).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(scratch / "out/two_node/4000N_100kmh/results.h5"));
}

TEST(Run, ThePageIsAFileUnlessItIsRefused) {
    const sample::Scratch scratch;
    call("run --quiet " + two_node + " --out " + scratch.path().string());
    const std::string page = post::read_text(scratch / "report.html");
    EXPECT_NE(page.find("<figure class=\"chart\""), std::string::npos);
    EXPECT_NE(page.find("\"name\":\"bulk_temperature\""), std::string::npos);
    call("run --quiet --no-report " + two_node + " --out " + scratch.path().string());
    EXPECT_FALSE(std::filesystem::exists(scratch / "report.html"));  // not even that of the run before
}

TEST(Run, QuietSaysNothing) {
    const sample::Scratch scratch;
    const Call run = call("run --quiet " + two_node + " --out " + scratch.path().string());
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.out + run.err, "");
}

// The pictures are those that version 0.2 drew: what stands beside a new result is of that result. Its option is no error.
TEST(Run, LeavesOutFieldsOnRequestAndPicturesAlways) {
    const sample::Scratch scratch;
    const std::string specimen = TIRETHERM_SOURCE_DIR "/cases/laser/one_watt.toml";
    post::replace_file(scratch / "picture.png", "as version 0.2 left it");
    call("run " + specimen + " --out " + scratch.path().string());
    EXPECT_TRUE(std::filesystem::exists(scratch / "page.txt"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "picture.png"));
    EXPECT_EQ(call("run --no-report --no-vtk --no-pictures --mat " + specimen + " --out " + scratch.path().string())
                  .exit_code,
              0);
    EXPECT_FALSE(std::filesystem::exists(scratch / "page.txt"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "report.html"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "field.pvd"));  // not even those of the run before
    EXPECT_FALSE(std::filesystem::exists(scratch / "field_0000.vtu"));
    EXPECT_TRUE(std::filesystem::exists(scratch / "channels.mat"));
}

TEST(Run, StoresFieldsAsOftenAsTold) {
    // 3600 s at one field each 900 s, with the first and the last: five. The tire is warm to 5 mK before the end: the field of
    // that moment, its hottest, is the sixth.
    const sample::Scratch scratch;
    EXPECT_EQ(call("run --fields 900 " + two_node + " --out " + scratch.path().string()).exit_code, 0);
    EXPECT_TRUE(std::filesystem::exists(scratch / "field_0005.vtu"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "field_0006.vtu"));
    EXPECT_EQ(call("run --fields -1 " + two_node).exit_code, 1);
}

TEST(Run, UnwritableDirectoryIsAnErrorBeforeTheRun) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "file", "");
    const std::string directory = (scratch / "file/results").string();
    const Call run = call("run " + two_node + " --out " + directory);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err,
              fmt::format("tiretherm: cannot create the directory {}: Not a directory; nothing was run; choose another "
                          "directory with --out\n",
                          directory));
}

TEST(Run, ErrorsAreAllReportedAtOnceAndCounted) {
    const std::string bad = TIRETHERM_SOURCE_DIR "/tests/bad_cases/many_errors.toml";
    const Call text = call("run " + bad);
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_EQ(text.out, "");
    const Json json = Json::parse(call("run --json " + bad).out);
    const std::size_t n = json["errors"].size();
    EXPECT_GT(n, 5u);
    EXPECT_TRUE(text.err.ends_with(fmt::format("{} errors; nothing was run\n", n))) << text.err;
    EXPECT_EQ(json["error"], fmt::format("{} errors; nothing was run", n));
    for (const Json& error : json["errors"]) {
        EXPECT_NE(text.err.find(error["message"].get<std::string>()), std::string::npos) << error;
        EXPECT_GT(error["line"], 0);
        EXPECT_GT(error["column"], 0);
        EXPECT_TRUE(error.contains("file") && error.contains("remedy"));
    }
}

TEST(Run, MissingFileIsAnError) {
    const Call text = call("run nowhere.toml");
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_EQ(text.err, "nowhere.toml: the file cannot be read: No such file or directory\n1 error; nothing was run\n");
    const Call json = call("run nowhere.toml --json");
    EXPECT_EQ(json.exit_code, 1);
    EXPECT_EQ(json.err, "");
    EXPECT_EQ(Json::parse(json.out)["errors"][0]["file"], "nowhere.toml");
}

TEST(Run, NumericalFailureNamesPlaceEffectAndTimeAndKeepsTheResults) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "burning.toml", exploding);
    const std::string arguments = "run burning.toml --out results";
    const Call run = call(arguments, scratch.path());
    EXPECT_EQ(run.exit_code, 2);
    for (const char* part :
         {"t = ", "layer tread", "largest heat source there:", "the results so far are in results"}) {
        EXPECT_NE(run.err.find(part), std::string::npos) << part << " is not in: " << run.err;
    }
    EXPECT_EQ(post::read_text(scratch / "results/channels.csv"), "time [s],inside [degC]\n0,23.0000\n");
    const Call json = call(arguments + " --json", scratch.path());
    EXPECT_EQ(json.exit_code, 2);
    EXPECT_NE(Json::parse(json.out)["error"].get<std::string>().find("largest heat source"), std::string::npos);
}

TEST(Run, CtrlCEndsItAfterTheStepWithWholeFiles) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "slow.toml", slow);
    const std::string case_file = (scratch / "slow.toml").string();
    const std::string directory = (scratch / "results").string();
    const std::string out = (scratch / "out").string();
    const std::string err = (scratch / "err").string();
    const pid_t child = fork();
    if (child == 0) {
        dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
        dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
        execl(TIRETHERM_PROGRAM, "tiretherm", "run", case_file.c_str(), "--out", directory.c_str(), nullptr);
        _exit(99);
    }
    // The third row shows that the march is under way.
    const auto rows = [&] {
        std::error_code error;
        const std::string text = std::filesystem::exists(directory + "/.tiretherm/new/channels.csv", error)
                                     ? post::read_text(directory + "/.tiretherm/new/channels.csv")
                                     : "";
        return std::count(text.begin(), text.end(), '\n');
    };
    for (int i = 0; i < 1000 && rows() < 4; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_NE(post::read_text(err).find("stopped at t = "), std::string::npos) << post::read_text(err);
    EXPECT_NE(post::read_text(out).find("ended early: stopped at t = "), std::string::npos) << post::read_text(out);
    // The field of the last moment is stored beside the first one.
    EXPECT_NE(post::read_text(directory + "/field.pvd").find("field_0001.vtu"), std::string::npos);
    EXPECT_TRUE(post::read_text(directory + "/channels.csv").ends_with("\n"));
}

}  // namespace
}  // namespace tiretherm::app_test
