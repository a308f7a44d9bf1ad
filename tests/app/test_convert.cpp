// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm convert`: the case made from a spreadsheet runs, all formats give the same case, and nothing is written on
// errors.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string example = TIRETHERM_SOURCE_DIR "/cases/convert/thesis_225_50_R17";

TEST(Convert, WritesACaseThatRunsAndListsWhatItAssumed) {
    const sample::Scratch scratch;
    const Call made = call("convert " + example + ".xlsx --out my_cases", scratch.path());
    EXPECT_EQ(made.exit_code, 0);
    EXPECT_EQ(made.err, "");
    EXPECT_TRUE(made.out.starts_with("my_cases/thesis_225_50_R17.toml: a case of the two-node model\n")) << made.out;
    EXPECT_NE(made.out.find("62 parameters of 10 sheets have their place in it\n"), std::string::npos) << made.out;
    EXPECT_NE(made.out.find("\nNot in the sheets and assumed\n  drive.vertical_load "), std::string::npos) << made.out;
    EXPECT_NE(made.out.find("\nIn the sheets, but without a place in a case\n  SEL: Tand Maximum "), std::string::npos)
        << made.out;
    const Call run =
        call("run my_cases/thesis_225_50_R17.toml --json --no-vtk --no-pictures --out out", scratch.path());
    EXPECT_EQ(run.exit_code, 0) << run.err;
    // The thesis's two nodes at 4000 N and 100 km/h, as an independent integration has them.
    EXPECT_NEAR(Json::parse(run.out)["channels"][1]["final"], 64.0, 0.06);
}

TEST(Convert, FolderAndWorkbooksGiveOneCase) {
    const sample::Scratch scratch;
    for (const std::string ending : {"/", ".xls", ".xlsx"}) {
        EXPECT_EQ(
            call("convert " + example + ending + " --out to" + (ending == "/" ? "" : ending), scratch.path()).exit_code,
            0)
            << ending;
    }
    const std::string text = post::read_text(scratch / "to/thesis_225_50_R17.toml");
    EXPECT_EQ(post::read_text(scratch / "to.xls/thesis_225_50_R17.toml"), text);
    EXPECT_EQ(post::read_text(scratch / "to.xlsx/thesis_225_50_R17.toml"), text);
}

TEST(Convert, CaseThatIsThereIsLeftAloneWithoutForce) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "thesis_225_50_R17.toml", "mine\n");
    const Call refused = call("convert " + example, scratch.path());
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_EQ(refused.out, "");
    EXPECT_EQ(refused.err,
              "tiretherm: thesis_225_50_R17.toml exists and is left as it is; replace it with --force, or write "
              "elsewhere with --out DIR\n");
    EXPECT_EQ(post::read_text(scratch / "thesis_225_50_R17.toml"), "mine\n");
    EXPECT_EQ(call("convert " + example + " --force", scratch.path()).exit_code, 0);
    EXPECT_NE(post::read_text(scratch / "thesis_225_50_R17.toml"), "mine\n");
}

TEST(Convert, JsonSaysWhatBecameOfEachParameter) {
    const sample::Scratch scratch;
    const Json json = Json::parse(call("convert --json " + example, scratch.path()).out);
    EXPECT_EQ(json["case"], "thesis_225_50_R17.toml");
    EXPECT_EQ(json["sheets"].size(), 10U);
    EXPECT_EQ(json["mapped"].size(), 62U);
    const Json frequency{{"sheet", "SEL"},
                         {"parameter", "Reference Frequency"},
                         {"key", "effects.strain_energy_loss.f0"},
                         {"value", 52.0},
                         {"unit", "Hz"}};
    EXPECT_NE(std::find(json["mapped"].begin(), json["mapped"].end(), frequency), json["mapped"].end());
    EXPECT_EQ(json["unmapped"][0]["parameter"], "Tand Maximum");
    EXPECT_EQ(json["missing"][0]["key"], "drive.vertical_load");
    EXPECT_EQ(json["missing"][0]["value"], "\"4000 N\"");
}

TEST(Convert, ErrorsAreReportedAtOnceAndNothingIsWritten) {
    const sample::Scratch scratch;
    std::filesystem::copy(example, scratch / "tire");
    std::string radius = post::read_text(scratch / "tire/Radius.csv");
    radius.replace(radius.find("0.3483,[m]"), 10, "0.3483,[N]");
    post::replace_file(scratch / "tire/Radius.csv", radius);
    std::filesystem::remove(scratch / "tire/SWITCH.csv");
    const Call wrong = call("convert tire", scratch.path());
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(wrong.out, "");
    EXPECT_EQ(wrong.err,
              "tire/Radius.csv:3:69: Rolling Radius Coeff A is in \"N\", a force; a length is wanted\n"
              "    Loaded Radius,Coeff A,-4.20E-06,[m/N],Rolling Radius,Coeff A,0.3483,[N]\n"
              "                                                                        ^~~\n"
              "    remedy: write m\n"
              "tire: there is no sheet SWITCH.csv\n"
              "    remedy: add it; one with a title alone takes all defaults of SWITCH\n"
              "2 errors; no case was written\n");
    EXPECT_FALSE(std::filesystem::exists(scratch / "tire.toml"));
    const Json json = Json::parse(call("convert tire --json", scratch.path()).out);
    EXPECT_EQ(json["mistakes"].size(), 2U);
    EXPECT_EQ(json["mistakes"][0]["line"], 3);
}

TEST(Convert, FolderThatCannotBeMadeIsTold) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "file", "in the way\n");
    const Call wrong = call("convert " + example + " --out file/below", scratch.path());
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("no case was written; choose another directory with --out"), std::string::npos)
        << wrong.err;
}

}  // namespace
}  // namespace tiretherm::app_test
