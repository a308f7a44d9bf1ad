// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis says of its runs alone: the table, the sentence, the data.

#include "post/diagnosis/run_verdicts.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/diagnosis/made_up_diagnosis.hpp"

namespace tiretherm::diagnosis {
namespace {

using namespace post;
using Json = nlohmann::json;
using sample::MadeUp;

RunVerdict shows(const std::string& run, std::vector<std::vector<Cause>> hypotheses) {
    const Verdict verdict = hypotheses.empty()       ? Verdict::consistent
                            : hypotheses.size() == 1 ? Verdict::named
                                                     : Verdict::confounded;
    return {.name = run, .verdict = verdict, .hypotheses = std::move(hypotheses)};
}

MadeUp with(std::vector<RunVerdict> runs) {
    MadeUp made_up = sample::named();
    made_up.by_run.runs = std::move(runs);
    return made_up;
}

std::string said(std::vector<RunVerdict> runs) { return agreement_of(with(std::move(runs)).record()); }

const Cause sidewalls = sample::sidewalls();
const Cause gas = sample::gas();
const Cause lag = sample::lag();

}  // namespace

TEST(RunVerdictsReport, RunsAgreeOnWhatIsInAllTheirSets) {
    EXPECT_EQ(said({shows("run1", {}), shows("run2", {})}),
              "All runs agree: none of them alone shows anything significant.");
    EXPECT_EQ(said({shows("run1", {{lag}}), shows("run2", {{lag}})}),
              "All runs agree on sensor_lag of bulk_temperature.");
    // Gas stands first in run2 and is no difference: run2 cannot tell it from what run1 names.
    EXPECT_EQ(said({shows("run1", {{sidewalls}}), shows("run2", {{gas}, {sidewalls}})}),
              "All runs agree on sidewall_convection.");
}

TEST(RunVerdictsReport, WhatOnlySomeShowIsSaidOfThem) {
    EXPECT_EQ(
        said({shows("run1", {}), shows("run2", {{lag}}), shows("run3", {})}),
        "run2 alone shows sensor_lag of bulk_temperature. run1 and run3 alone show nothing significant, which may "
        "be for want of data.");
    EXPECT_EQ(said({shows("run1", {{lag}}), shows("run2", {{lag}}), shows("run3", {{sidewalls}})}),
              "run1 and run2 show sensor_lag of bulk_temperature. run3 alone shows sidewall_convection.");
    EXPECT_EQ(said({shows("run1", {{lag, sidewalls}}), shows("run2", {{gas}})}),
              "run1 alone shows sensor_lag of bulk_temperature and sidewall_convection. run2 alone shows inner_gas.");
    // A pair is one explanation: the lag is in both runs, the sidewalls in one.
    EXPECT_EQ(said({shows("run1", {{lag, sidewalls}}), shows("run2", {{lag}})}),
              "All runs agree on sensor_lag of bulk_temperature. run1 alone shows sidewall_convection.");
}

// A run that could not be judged is no witness; one that is left has nobody to agree with.
TEST(RunVerdictsReport, RunsThatWereNotJudgedAreNotCompared) {
    RunVerdict poor{.name = "run1", .verdict = Verdict::cannot_tell};
    RunVerdict late{.name = "run1", .verdict = Verdict::consistent, .stopped = Part::causes};
    EXPECT_EQ(said({poor, shows("run2", {{lag}}), shows("run3", {{lag}})}),
              "All runs agree on sensor_lag of bulk_temperature.");
    EXPECT_EQ(said({late, shows("run2", {{lag}})}), "");
    EXPECT_EQ(said({}), "");
}

TEST(RunVerdictsReport, ThePageHasARowForEachCauseAndTheDataAllOfThem) {
    RunVerdict many = shows("run1", {{sidewalls}, {gas}, {lag}, {lag, gas}});
    many.gain = {.measured = true, .removable_removed = 0.91, .low = 0.8, .high = 0.98, .confirmed = true};
    RunVerdict strange{.name = "run2", .verdict = Verdict::unknown, .unknown = sample::unknown().result.unknown};
    const MadeUp made_up = with({many, strange, shows("run3", {})});
    const Report report = diagnosis_report(made_up.record(), {});
    const std::string page = page_text(report, false);
    const std::size_t at = page.find("\nEach run alone\n");
    ASSERT_NE(at, std::string::npos) << page;
    const std::string part = page.substr(at, page.find("\n\n", at + 1) - at);
    for (const char* words : {"run1  confounded  sidewall_convection", "91 % (80 to 98 %)", "or inner_gas",
                              "conductance 8.10 W/K (7.20 to 9.00)", "or 1 more",
                              "run2  unknown     unknown heat at surface", "310 W (250 to 370)", "run3  consistent"}) {
        EXPECT_NE(part.find(words), std::string::npos) << words << part;
    }
    const Json runs = Json::parse(json_text(report.data))["runs"];
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[0]["name"], "run1");
    EXPECT_EQ(runs[0]["verdict"], "confounded");
    ASSERT_EQ(runs[0]["causes"].size(), 5U);
    EXPECT_EQ(runs[0]["causes"][4]["id"], "inner_gas");
    EXPECT_EQ(runs[0]["causes"][4]["hypothesis"], 4);
    EXPECT_DOUBLE_EQ(runs[0]["gain"], 0.91);
    EXPECT_TRUE(runs[1]["causes"][0]["id"].is_null());
    EXPECT_EQ(runs[1]["causes"][0]["place"], "surface");
    EXPECT_TRUE(runs[2]["causes"].empty());
    EXPECT_TRUE(runs[2]["gain"].is_null());
}

// Where the runs were left out, the page says why and has no table.
TEST(RunVerdictsReport, WhatWasLeftOutIsSaid) {
    MadeUp made_up = sample::named();
    EXPECT_EQ(page_text(diagnosis_report(made_up.record(), {}), false).find("Each run alone"), std::string::npos);
    made_up.by_run.left_out = LeftOutRuns::stopped_after;
    EXPECT_NE(page_text(diagnosis_report(made_up.record(), {}), false)
                  .find(fmt::format("Stopped after 0 of {} runs.", made_up.experiment.runs.size())),
              std::string::npos);
}

}  // namespace tiretherm::diagnosis
