// SPDX-License-Identifier: BSD-3-Clause
// `fmu` writes a file that is an archive, the same each time; what it cannot do it says, and leaves nothing behind. What is in the
// file is looked at in tests/interface/fmu.

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"
#include "tests/app/program.hpp"
#include "tests/post/scratch.hpp"

#ifndef TIRETHERM_NO_FMU  // not in every build there is one: see cmake/fmu.cmake
namespace tiretherm::app_test {
namespace {

namespace fs = std::filesystem;
const std::string two_nodes = TIRETHERM_SOURCE_DIR "/cases/two_node/4000N_100kmh.toml";

TEST(FmuCommand, WritesTheSameFileEachTime) {
    const sample::Scratch scratch;
    const std::string a = (scratch / "deeper/a.fmu").string();
    const std::string b = (scratch / "b.fmu").string();
    const Call first = call("fmu " + two_nodes + " -o " + a);
    ASSERT_EQ(first.exit_code, 0) << first.err;
    EXPECT_NE(first.out.find("FMI 2.0 for co-simulation"), std::string::npos) << first.out;
    EXPECT_NE(first.out.find("vertical_load"), std::string::npos) << first.out;
    ASSERT_EQ(call("fmu " + two_nodes + " --fmi 2 --out " + b).exit_code, 0);
    EXPECT_EQ(post::read_text(a), post::read_text(b));
    EXPECT_EQ(post::read_text(a).substr(0, 2), "PK");
}

TEST(FmuCommand, TellsProgramsWhatItWrote) {
    const sample::Scratch scratch;
    const std::string target = (scratch / "a.fmu").string();
    const Call made = call("fmu " + two_nodes + " --fmi 3 --json --out " + target);
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const auto json = nlohmann::json::parse(made.out);
    EXPECT_EQ(json["fmu"], target);
    EXPECT_EQ(json["fmi"], "3.0");
    EXPECT_EQ(json["bytes"], fs::file_size(target));
    EXPECT_EQ(json["outputs"], nlohmann::json({"surface_temperature", "bulk_temperature"}));
}

TEST(FmuCommand, SaysWhatIsWrongAndWritesNothing) {
    const sample::Scratch scratch;
    const std::string target = (scratch / "a.fmu").string();
    const auto refused = [&](const std::string& arguments, const std::string& says) {
        const Call made = call("fmu " + arguments);
        EXPECT_EQ(made.exit_code, 1) << arguments;
        EXPECT_NE((made.err + made.out).find(says), std::string::npos) << made.err << made.out;
        EXPECT_FALSE(fs::exists(target)) << arguments;
    };
    const std::string out = " --out " + target;
    refused(two_nodes + out + " --fmi 4", "--fmi");
    refused(two_nodes + out + " --run none", "the case has no run \"none\"");
    refused((scratch / "none.toml").string() + out, "none.toml");
    refused(std::string(TIRETHERM_SOURCE_DIR) + "/cases/car/session.toml" + out,
            "an FMU is one tire, and the case has 4");
    post::replace_file(scratch / "no_speed.toml", "include = \"" + two_nodes + "\"\nunset = [\"drive.speed\"]\n");
    refused((scratch / "no_speed.toml").string() + out, "speed");
    post::replace_file(scratch / "file", "");
    refused(two_nodes + " --out " + (scratch / "file/a.fmu").string(), "file");
    refused(two_nodes + " --out " + two_nodes, "reads");
    post::replace_file(scratch / "case.toml", "include = \"" + two_nodes + "\"\n");
    refused((scratch / "case.toml").string() + " --out " + (scratch / "case.toml").string(), "case.toml");
    EXPECT_EQ(post::read_text(scratch / "case.toml"), "include = \"" + two_nodes + "\"\n");
}

TEST(FmuCommand, TakesOneTireOfACar) {
    const sample::Scratch scratch;
    const std::string car = std::string(TIRETHERM_SOURCE_DIR) + "/cases/car/session.toml";
    const Call all = call("fmu " + car + " --out " + (scratch / "a.fmu").string());
    const std::size_t named = all.err.find("--run ");
    ASSERT_NE(named, std::string::npos) << all.err;
    const std::string run = all.err.substr(named + 6, all.err.find_first_of(",; \n", named + 6) - named - 6);
    const Call one = call("fmu " + car + " --run " + run + " --json --out " + (scratch / "a.fmu").string());
    ASSERT_EQ(one.exit_code, 0) << one.err;
    EXPECT_FALSE(nlohmann::json::parse(one.out)["parameters"].empty());
}

}  // namespace
}  // namespace tiretherm::app_test
#endif
