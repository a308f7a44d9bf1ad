// SPDX-License-Identifier: BSD-3-Clause
// The page as HTML: what the user's files hold stays text, charts stand in it and in no other form, nothing is fetched.

#include "post/page/html_page.hpp"

#include <gtest/gtest.h>

#include "post/page/assets.hpp"
#include "post/page/charts.hpp"

namespace tiretherm::post {
namespace {

std::size_t occurrences(std::string_view text, std::string_view what) {
    std::size_t n = 0;
    for (std::size_t at = text.find(what); at != std::string_view::npos; at = text.find(what, at + what.size())) {
        ++n;
    }
    return n;
}

/// What is tiretherm's own in a page: all before the scripts at its end.
std::string own_part(const Report& report) {
    const std::string page = html_page(report, {.kind = "run", .source = "a.toml"});
    return page.substr(0, page.find("</footer>"));
}

Report sample() {
    Report report{.title = "A <b>tire</b> & \"rim\""};
    report.lead = {"hottest 80 degC"};
    ReportSection section("Heat budget");
    section.say("one");
    section.item("two");
    section.item("three");
    DataTable table;
    table.add({Field("unit", "unit", "degC"), Field("final", "final", shown("{:.2f}", 80.0))});
    section.add(std::move(table));
    section.chart("Sensors </script><script>alert(1)", "How it is read.", bar_chart("heat", "W", {{"</script>", 1.5}}));
    report.add(std::move(section));
    return report;
}

TEST(HtmlPage, NamesOfTheUserStayText) {
    const std::string page = own_part(sample());
    EXPECT_EQ(occurrences(page, "<b>tire"), 0u);
    EXPECT_EQ(occurrences(page, "A &lt;b&gt;tire&lt;/b&gt; &amp; &quot;rim&quot;"),
              2u);  // title of the window, heading
    // Of the data of the chart and of its name; the one that is left ends the data.
    EXPECT_EQ(occurrences(page, "</script>"), 1u);
    EXPECT_EQ(occurrences(page, "<script>"), 0u);
}

TEST(HtmlPage, SectionsTablesListsAndCharts) {
    const std::string page = own_part(sample());
    EXPECT_EQ(occurrences(page, "<h2>Heat budget</h2>"), 1u);
    EXPECT_EQ(occurrences(page, "<a href=\"#heat-budget\">"), 1u);
    EXPECT_EQ(occurrences(page, "<li>"), 2u);
    EXPECT_EQ(occurrences(page, "<ul>"), 1u);
    EXPECT_EQ(occurrences(page, "<td class=\"right\">80.00</td>"), 1u);
    EXPECT_EQ(occurrences(page, "<figure class=\"chart\""), 1u);
}

TEST(HtmlPage, DegreesAreWrittenAsOnAThermometer) {
    const std::string page = own_part(sample());
    EXPECT_EQ(occurrences(page, "degC"), 0u);
    EXPECT_EQ(occurrences(page, "°C"), 2u);
}

std::string without_breaks(std::string page) {
    for (std::size_t at = 0; (at = page.find("<wbr>", at)) != std::string::npos;) {
        page.erase(at, 5);
    }
    return page;
}

// The letters of the unit in a name of the user's are no unit; a character that turns the line round is a blank.
TEST(HtmlPage, NamesOfFilesStayAsTheyAre) {
    for (const char* name : {"log_degC.csv", "degC.csv", "degC log.csv", "in degC.csv", "5 degCs.csv", "a/degC/b.csv",
                             "[degC]x.csv", "Tire degC_2"}) {
        Report report{.title = name};
        EXPECT_EQ(occurrences(without_breaks(own_part(report)), name), 2u) << name;
    }
    for (const auto& [text, shown] :
         {std::pair("T [degC]", "T [°C]"), std::pair("80.5 degC, 3 K", "80.5 °C, 3 K"), std::pair("in degC", "in °C"),
          std::pair("8 degC/s", "8 °C/s"), std::pair("90 degC.", "90 °C."), std::pair("(degC)", "(°C)")}) {
        Report report{.title = text};
        EXPECT_EQ(occurrences(own_part(report), shown), 2u) << text;
    }
    Report turned{.title = "log_\u202Evsc.exe \u2066x"};
    EXPECT_EQ(occurrences(without_breaks(own_part(turned)), "log_ vsc.exe  x"), 2u);
}

TEST(HtmlPage, NothingIsFetched) {
    const std::string page = html_page(sample(), {.kind = "run", .source = "a.toml"});
    EXPECT_EQ(occurrences(page, "src="),
              occurrences(assets::charting_library(), "src=") + occurrences(assets::script(), "src="));
    EXPECT_EQ(occurrences(own_part(sample()), "<link"), 0u);
    EXPECT_EQ(occurrences(own_part(sample()), "http"), 0u);
    EXPECT_LT(page.size(), 1'000'000u);
}

TEST(HtmlPage, TheTextHasNoCharts) {
    Report report = sample();
    const std::string with = page_text(report, false);
    ReportSection only("Only a chart");
    only.chart("title", "caption", bar_chart("heat", "W", {}));
    report.add(std::move(only));
    EXPECT_EQ(page_text(report, false), with);
    EXPECT_EQ(with.find("How it is read"), std::string::npos);
}

TEST(HtmlPage, TheVerdictStandsBelowTheTitleAndTheFilesAtTheEnd) {
    Report report = sample();
    report.verdict = {"Hottest: 80 degC."};
    ReportSection last("What to cite");
    last.item("a thesis");
    report.appendix.push_back(std::move(last));
    const std::string page = html_page(report, {.kind = "run", .source = "a.toml", .files = {"a.toml", "log.csv"}});
    const std::size_t verdict = page.find("<p class=\"verdict\">Hottest: 80 °C.</p>");
    EXPECT_LT(page.find("<h1>"), verdict);
    EXPECT_LT(verdict, page.find("<p class=\"lead\">"));
    EXPECT_LT(page.find("<h2>Heat budget</h2>"), page.find("<h2>What to cite</h2>"));
    EXPECT_LT(page.find("<h2>What to cite</h2>"), page.find("<h2>Files and versions</h2>"));
    EXPECT_EQ(occurrences(page, ">log.csv</td>"), 1u);
    EXPECT_EQ(occurrences(page, ">a.toml</td>"), 1u);  // once, as the case file
    EXPECT_TRUE(page_text(report, false).starts_with(report.title + "\nHottest: 80 degC.\n"));
}

// A diagnosis says its verdict in a section of the text; at the head of the page it stands once.
TEST(HtmlPage, AVerdictWithASectionOfItsOwnIsSaidOnce) {
    Report report = sample();
    report.add_verdict({"One cause: rim.", "Confidence: none."});
    EXPECT_EQ(occurrences(own_part(report), "Confidence: none."), 1u);
    EXPECT_EQ(occurrences(own_part(report), "<h2>Verdict</h2>"), 0u);
    EXPECT_EQ(occurrences(page_text(report, false), "Confidence: none."), 1u);
    EXPECT_NE(page_text(report, false).find("Verdict\n  One cause: rim.\n"), std::string::npos);
}

// A name may be broken behind its underscores, points and strokes, a number and a unit nowhere.
TEST(HtmlPage, LongNamesFitANarrowScreen) {
    Report report = sample();
    report.title = "A test (durability/un_r30)";
    DataTable table;
    table.add({page_only("channel", "effects.tan_delta_a"), page_only("speed", "57.5 km/h, 0.3 W/mK")});
    report.add(ReportSection("Channels", std::move(table)));
    const std::string page = own_part(report);
    EXPECT_EQ(occurrences(page, "<td>effects.<wbr>tan_<wbr>delta_<wbr>a</td>"), 1u) << page;
    EXPECT_EQ(occurrences(page, "<td>57.5 km/h, 0.3 W/mK</td>"), 1u) << page;
    EXPECT_EQ(occurrences(html_page(report, {}), "<h1>A test (durability/un_<wbr>r30)</h1>"), 1u);
}

}  // namespace
}  // namespace tiretherm::post
