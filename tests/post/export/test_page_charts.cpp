// SPDX-License-Identifier: BSD-3-Clause
// Charts are read back from the page that was written; a page that is none, or a damaged one, is refused with its reason.

#include <gtest/gtest.h>

#include "post/export/child_process.hpp"
#include "post/export/page_charts.hpp"
#include "post/page/charts.hpp"
#include "post/page/html_page.hpp"
#include "post/report/file.hpp"
#include "tests/post/scratch.hpp"

namespace tiretherm::post {
namespace {

/// A page with two charts of one title, and one whose title has letters of HTML.
std::string page() {
    Report report{.title = "A page"};
    ReportSection section("Heat");
    section.chart("Heat at the end", "", bar_chart("heat", "W", {{"laser", 1.0}}));
    section.chart("Heat at the end", "", bar_chart("heat", "kJ", {{"laser", 2.0}}));
    section.chart("k < 1 & \"so on\"", "", bar_chart("k", "", {{"tread", 0.3}}));
    report.add(std::move(section));
    return html_page(report, {.kind = "run", .source = "case.toml"});
}

PageCharts read(const std::string& text) {
    const sample::Scratch scratch;
    replace_file(scratch / "report.html", text);
    return read_page(scratch / "report.html");
}

std::string without(std::string text, const std::string& piece) { return text.erase(text.find(piece), piece.size()); }

}  // namespace

TEST(PageCharts, AreThoseThatWereWritten) {
    const PageCharts found = read(page());
    ASSERT_EQ(found.charts.size(), 3U);
    EXPECT_EQ(found.charts[2].title, "k < 1 & \"so on\"");
    EXPECT_NE(found.charts[1].element.find("\"unit\":\"kJ\""), std::string::npos);
    EXPECT_EQ(picture_names(found.charts),
              (std::vector<std::string>{"heat-at-the-end.png", "heat-at-the-end-2.png", "k-1-so-on.png"}));
}

// The first 80 letters and digits of a title; a title without any is a chart.
TEST(PageCharts, NamesArePlainAndShort) {
    const std::vector<std::string> names =
        picture_names({{"../../etc/passwd", ""}, {"°C", ""}, {"???", ""}, {std::string(300, 'x'), ""}});
    EXPECT_EQ(names[0], "etc-passwd.png");
    EXPECT_EQ(names[1], "c.png");
    EXPECT_EQ(names[2], "chart.png");
    EXPECT_EQ(names[3], std::string(80, 'x') + ".png");
}

TEST(PageCharts, DamagedPageIsRefused) {
    EXPECT_THROW(static_cast<void>(read("a text")), PageError);
    EXPECT_THROW(static_cast<void>(read(page().substr(0, 3000))), PageError);
    EXPECT_THROW(static_cast<void>(read(without(page(), "</figure>\n</section>"))), PageError);
    EXPECT_THROW(static_cast<void>(read(without(page(), "\"kind\":"))), PageError);
}

TEST(ChildProcess, GivesWhatWasWrittenAndHowItEnded) {
    const auto run = [](const std::string& script, int ms = 10000) {
        return run_child({"/bin/sh", "-c", script}, std::chrono::milliseconds(ms), [] { return false; });
    };
    const ChildResult said = run("echo out; echo err >&2; exit 3");
    EXPECT_EQ(said.end, ChildResult::End::exited);
    EXPECT_EQ(said.code, 3);
    EXPECT_EQ(said.out, "out\n");
    EXPECT_EQ(said.err, "err\n");
    EXPECT_EQ(run("head -c 300000 /dev/zero").out.size(), 300000U);  // more than a pipe holds
    EXPECT_EQ(run("kill -9 $$").end, ChildResult::End::killed_by_signal);
    EXPECT_EQ(run("sleep 1000 & sleep 1000", 200).end, ChildResult::End::timed_out);
    EXPECT_EQ(run("sleep 1000 & exit 0").end, ChildResult::End::exited);  // whatever it leaves behind
    EXPECT_EQ(run_child({"/nowhere/at/all"}, std::chrono::seconds(1), [] { return false; }).end,
              ChildResult::End::not_started);
}

}  // namespace tiretherm::post
