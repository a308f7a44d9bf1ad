// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm report`: prints a folder's page, lists its charts and draws them; folders without a page, damaged pages, and a browser
// that is missing, fails or hangs.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/export/chart_pictures.hpp"
#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// A program of this name at the only place of the search path beside the system's own.
std::string with_browser(const sample::Scratch& scratch, const std::string& script) {
    std::filesystem::create_directories(scratch / "bin");
    post::replace_file(scratch / "bin/chromium", "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(scratch / "bin/chromium", std::filesystem::perms::owner_all);
    return "export PATH='" + (scratch / "bin").string() + "'; ";
}

/// A call in a shell with something before it.
Call call_with(const std::string& before, const std::string& arguments, const std::filesystem::path& directory) {
    const sample::Scratch files;
    const std::string line =
        fmt::format("cd '{}' && {}'{}' {} >'{}' 2>'{}' </dev/null", directory.string(), before, TIRETHERM_PROGRAM,
                    arguments, (files / "out").string(), (files / "err").string());
    const int status = std::system(line.c_str());
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .out = post::read_text(files / "out"),
            .err = post::read_text(files / "err")};
}

/// Four bytes of a file as a number, the highest first.
int word_at(const std::string& bytes, std::size_t at) {
    int word = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
        word = word << 8 | static_cast<unsigned char>(bytes.at(i));
    }
    return word;
}

void make_page(const sample::Scratch& scratch) {
    ASSERT_EQ(call("run --no-vtk --quiet --out o " + two_node, scratch.path()).exit_code, 0);
}

}  // namespace

TEST(Report, PrintsThePageAndListsTheCharts) {
    const sample::Scratch scratch;
    const Call run = call("run --no-vtk --out o " + two_node, scratch.path());
    const std::string page = post::read_text(scratch / "o/page.txt");
    EXPECT_EQ(page, run.out);
    const Call shown = call("report o", scratch.path());
    EXPECT_EQ(shown.exit_code, 0) << shown.err;
    EXPECT_TRUE(shown.out.starts_with(page));
    EXPECT_NE(shown.out.find("Sensors against time", page.size()), std::string::npos) << shown.out;
    const Json json = Json::parse(call("report o --json", scratch.path()).out);
    EXPECT_EQ(json["report"], "o/report.html");
    EXPECT_EQ(json["page"], "o/page.txt");
    EXPECT_EQ(json["charts"][0]["title"], "Sensors against time");
}

TEST(Report, FoldersWithoutAPageAreRefusedWithARemedy) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "file", "x");
    std::filesystem::create_directories(scratch / "empty");
    for (const auto& [folder, words] :
         {std::pair("nowhere", "there is no folder nowhere"), std::pair("file", "file is a file"),
          std::pair("empty", "there is no report.html in empty")}) {
        const Call refused = call(std::string("report ") + folder, scratch.path());
        EXPECT_EQ(refused.exit_code, 1) << folder;
        EXPECT_NE(refused.err.find(words), std::string::npos) << refused.err;
    }
}

TEST(Report, DamagedPageIsRefused) {
    const sample::Scratch scratch;
    make_page(scratch);
    const std::string page = post::read_text(scratch / "o/report.html");
    for (const std::string& wrong : {page.substr(0, page.size() / 2), std::string("<html></html>"), std::string()}) {
        post::replace_file(scratch / "o/report.html", wrong);
        const Call refused = call("report o --png", scratch.path());
        EXPECT_EQ(refused.exit_code, 1);
        EXPECT_NE(refused.err.find("make the page again"), std::string::npos) << refused.err;
    }
    EXPECT_FALSE(std::filesystem::exists(scratch / "o/charts"));
}

TEST(Report, SaysWhichPackageIsMissing) {
    const sample::Scratch scratch;
    make_page(scratch);
    const Call missing = call_with("export PATH=/nowhere; ", "report o --png", scratch.path());
    EXPECT_EQ(missing.exit_code, 1);
    EXPECT_NE(missing.err.find("apt-get install chromium"), std::string::npos) << missing.err;
    EXPECT_EQ(
        Json::parse(call_with("export PATH=/nowhere; ", "report o --png --json", scratch.path()).out).contains("error"),
        true);
}

// In an address # begins a place in the page and % a code: of a path they are codes themselves.
TEST(Report, FolderOfAnyNameIsAnAddress) {
    const sample::Scratch scratch;
    make_page(scratch);
    const std::filesystem::path folder = scratch / "a#b%20c ?d";
    std::filesystem::create_directories(folder);
    const std::string note = (scratch / "address").string();
    const std::string before =
        with_browser(scratch, "for last; do :; done; printf %s \"$last\" >'" + note + "'; exit 3");
    EXPECT_EQ(
        call_with(before + "export TMPDIR='" + folder.string() + "'; ", "report o --png", scratch.path()).exit_code, 2);
    const std::string address = post::read_text(note);
    EXPECT_TRUE(address.starts_with("file:///")) << address;
    EXPECT_NE(address.find("/a%23b%2520c%20%3Fd/tiretherm_report_"), std::string::npos) << address;
}

TEST(Report, BrowserThatFailsOrHangsLeavesNothing) {
    const sample::Scratch scratch;
    make_page(scratch);
    const Call failed =
        call_with(with_browser(scratch, "echo no display >&2; exit 7"), "report o --png", scratch.path());
    EXPECT_EQ(failed.exit_code, 2);
    EXPECT_NE(failed.err.find("failed with exit code 7: no display"), std::string::npos) << failed.err;
    const Call hung =
        call_with(with_browser(scratch, "exec /bin/sleep 1000"), "report o --png --time-limit 0.3", scratch.path());
    EXPECT_EQ(hung.exit_code, 2);
    EXPECT_NE(hung.err.find("within 0.3 s"), std::string::npos) << hung.err;
    EXPECT_EQ(call_with(with_browser(scratch, "echo '<html></html>'"), "report o --png", scratch.path()).exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(scratch / "o/charts"));
}

// Width and height of a PNG are the words at 16 and 20 of its file. What it shows is checked in a browser: tests/browser/pages.
TEST(Report, DrawsEveryChartAtTheWidthAskedFor) {
    if (!post::find_browser()) {
        GTEST_SKIP() << "Chromium is not installed";
    }
    const sample::Scratch scratch;
    const std::string specimen = TIRETHERM_SOURCE_DIR "/cases/laser/one_watt.toml";  // its page has a field
    ASSERT_EQ(call("run --no-vtk --quiet --out o " + specimen, scratch.path()).exit_code, 0);
    for (const auto& [options, width] : {std::pair("", 1600), std::pair(" --width 700 --dark", 700)}) {
        const Call drawn = call(std::string("report o --png --json --time-limit 300") + options, scratch.path());
        ASSERT_EQ(drawn.exit_code, 0) << drawn.out << drawn.err;
        const Json json = Json::parse(drawn.out);
        ASSERT_GE(json["charts"].size(), 3U);
        for (const Json& chart : json["charts"]) {
            const std::string png = post::read_text(scratch / chart["file"].get<std::string>());
            EXPECT_EQ(word_at(png, 16), width) << chart;
            EXPECT_EQ(word_at(png, 20), chart["height"].get<int>());
        }
    }
    EXPECT_TRUE(std::filesystem::exists(scratch / "o/charts/temperature-field.png"));
}

// Of two pages one chart each, by the name of its picture; at 600 s and at the end of 1800 s the spot is not equally warm.
TEST(Report, DrawsChosenChartsOfSeveralPagesAtAMoment) {
    if (!post::find_browser()) {
        GTEST_SKIP() << "Chromium is not installed";
    }
    const sample::Scratch scratch;
    for (const char* name : {"one_watt", "three_watts"}) {
        const std::string specimen = fmt::format("{}/cases/laser/{}.toml", TIRETHERM_SOURCE_DIR, name);
        ASSERT_EQ(call(fmt::format("run --no-vtk --quiet --out {} {}", name, specimen), scratch.path()).exit_code, 0);
    }
    const std::string field = "report one_watt three_watts --png --time-limit 300 --chart temperature-field --at ";
    const Call at_600 = call(field + "600 --json", scratch.path());
    ASSERT_EQ(at_600.exit_code, 0) << at_600.out << at_600.err;
    const Json json = Json::parse(at_600.out);
    ASSERT_EQ(json["reports"].size(), 2U);
    for (const Json& one : json["reports"]) {
        ASSERT_EQ(one["charts"].size(), 1U);
        EXPECT_EQ(one["charts"][0]["title"], "Temperature field");
    }
    const std::string early = post::read_text(scratch / "three_watts/charts/temperature-field.png");
    const Call at_end = call(field + "end", scratch.path());
    ASSERT_EQ(at_end.exit_code, 0) << at_end.err;
    EXPECT_NE(at_end.out.find("one_watt/charts/temperature-field.png"), std::string::npos) << at_end.out;
    EXPECT_NE(post::read_text(scratch / "three_watts/charts/temperature-field.png"), early);
    EXPECT_FALSE(std::filesystem::exists(scratch / "one_watt/charts/sensors-against-time.png"));
}

TEST(Report, AChartThatAPageHasNotIsNamedWithThoseThatItHas) {
    const sample::Scratch scratch;
    make_page(scratch);
    const Call refused = call("report o --png --chart \"Tread, unrolled\"", scratch.path());
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.err.find("o/report.html has no chart \"Tread, unrolled\"; it has \"Sensors against time\", "),
              std::string::npos)
        << refused.err;
    EXPECT_EQ(call("report o o o", scratch.path()).exit_code, 1);  // of two results alone there is a page
}

// A kind of chart that no version has: it is named, and each of the others gets its picture.
TEST(Report, AChartThatCannotBeDrawnIsNamedAndTheOthersAreDrawn) {
    if (!post::find_browser()) {
        GTEST_SKIP() << "Chromium is not installed";
    }
    const sample::Scratch scratch;
    make_page(scratch);
    std::string page = post::read_text(scratch / "o/report.html");
    const std::string bars = "{\"kind\":\"bars\"";
    ASSERT_NE(page.find(bars), std::string::npos);
    page.replace(page.find(bars), bars.size(), "{\"kind\":\"pies\"");
    post::replace_file(scratch / "o/report.html", page);
    const Call drawn = call("report o --png --json --time-limit 300", scratch.path());
    EXPECT_EQ(drawn.exit_code, 1) << drawn.err;
    const Json json = Json::parse(drawn.out);
    std::size_t failed = 0;
    for (const Json& chart : json["charts"]) {
        failed += chart.contains("error") ? 1U : 0U;
        EXPECT_NE(chart.contains("error"), chart.contains("file")) << chart;
        EXPECT_TRUE(chart.contains("error") || std::filesystem::exists(scratch / chart["file"].get<std::string>()));
    }
    EXPECT_EQ(failed, 1U);
    EXPECT_TRUE(json["error"].get<std::string>().starts_with("no picture of \"Heat at the end\": ")) << drawn.out;
    const Call said = call("report o --png --time-limit 300", scratch.path());
    EXPECT_NE(said.err.find("no picture of \"Heat at the end\""), std::string::npos) << said.err;
    EXPECT_NE(said.out.find("sensors-against-time.png"), std::string::npos) << said.out;
}

}  // namespace tiretherm::app_test
