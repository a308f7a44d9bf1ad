// SPDX-License-Identifier: BSD-3-Clause
// Whole calls for C: the numbers of the solver, values by their addresses, a fit that finds what was hidden, and what is said of mistakes.

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "interface/tiretherm_cases.h"
#include "post/report/file.hpp"
#include "solver/time_integration/march.hpp"
#include "tests/interface/allocations.hpp"
#include "tests/post/scratch.hpp"

namespace tiretherm {
namespace {

const std::string warm_up = TIRETHERM_SOURCE_DIR "/cases/two_node/4000N_100kmh.toml";

struct Freer {
    void operator()(tiretherm_case* tire) const { tiretherm_close_case(tire); }
    void operator()(tiretherm_answer* answer) const { tiretherm_free_answer(answer); }
};
using Case = std::unique_ptr<tiretherm_case, Freer>;
using Answer = std::unique_ptr<tiretherm_answer, Freer>;

Case open_file(const std::string& file) {
    std::array<char, 200> message{};
    Case tire(tiretherm_open_case(file.c_str(), message.data(), message.size()));
    EXPECT_NE(tire, nullptr) << message.data();
    EXPECT_STREQ(message.data(), "");
    return tire;
}

Case open_text(const std::string& text) {
    std::array<char, 200> message{};
    Case tire(tiretherm_open_text(text.c_str(), "mine", message.data(), message.size()));
    EXPECT_NE(tire, nullptr) << message.data();
    return tire;
}

Answer run(const Case& tire, const char* folder = nullptr) {
    tiretherm_answer* answer = nullptr;
    EXPECT_EQ(tiretherm_run_case(tire.get(), nullptr, folder, &answer), TIRETHERM_OK)
        << tiretherm_case_message(tire.get());
    EXPECT_STREQ(tiretherm_case_message(tire.get()), "");
    return Answer(answer);
}

/// The last value of a channel.
double last(const Answer& answer, const char* channel) {
    const int n = tiretherm_channel_count(answer.get(), 0);
    const std::size_t rows = tiretherm_row_count(answer.get(), 0);
    return tiretherm_values(answer.get(),
                            0)[(rows - 1) * static_cast<std::size_t>(n) +
                               static_cast<std::size_t>(tiretherm_find_channel(answer.get(), 0, channel))];
}

TEST(TirethermCases, ARunHasTheNumbersOfTheSolver) {
    const solver::Problem problem = *input::read_case(warm_up).problem;
    std::vector<double> times;
    std::vector<double> values;
    std::vector<double> field;
    const auto watch = [&](const solver::Snapshot& row) {
        times.push_back(row.time);
        values.insert(values.end(), row.channels.begin(), row.channels.end());
        field.assign(row.temperature.begin(), row.temperature.end());
        return true;
    };
    ASSERT_TRUE(solver::run(problem, watch).status.ok());

    const Answer answer = run(open_file(warm_up));
    ASSERT_EQ(tiretherm_tire_count(answer.get()), 1);
    EXPECT_STREQ(tiretherm_tire_name(answer.get(), 0), "");
    const std::size_t rows = tiretherm_row_count(answer.get(), 0);
    const auto n = static_cast<std::size_t>(tiretherm_channel_count(answer.get(), 0));
    ASSERT_EQ(n, problem.channels.size());
    const double* const found = tiretherm_values(answer.get(), 0);
    EXPECT_EQ(std::vector(tiretherm_times(answer.get(), 0), tiretherm_times(answer.get(), 0) + rows), times);
    EXPECT_EQ(std::vector(found, found + rows * n), values);
    const double* const end = tiretherm_final_temperatures(answer.get(), 0);
    EXPECT_EQ(std::vector(end, end + tiretherm_final_temperature_count(answer.get(), 0)), field);
    const int bulk = tiretherm_find_channel(answer.get(), 0, "bulk_temperature");
    ASSERT_GE(bulk, 0);
    EXPECT_STREQ(tiretherm_channel_name(answer.get(), 0, bulk), "bulk_temperature");
    EXPECT_STREQ(tiretherm_channel_unit(answer.get(), 0, bulk), "K");
    EXPECT_NE(std::string(tiretherm_headline(answer.get())), "");
    EXPECT_NE(std::string(tiretherm_page(answer.get())).find(tiretherm_headline(answer.get()), 0), std::string::npos);
    EXPECT_NE(std::string(tiretherm_json(answer.get())).find("\"energy_closure\""), std::string::npos);
    EXPECT_EQ(tiretherm_file_count(answer.get()), 0);
    EXPECT_EQ(tiretherm_fitted_count(answer.get()), 0);
}

TEST(TirethermCases, AValueThatIsSetIsThatOfTheFile) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "given.toml", "include = \"" + warm_up +
                                                   "\"\n[drive]\nspeed = \"120 km/h\"\n[effects.air_convection]\n"
                                                   "lambda_h = 1.4\n[effects.road_contact]\non = false\n");
    const Answer given = run(open_file((scratch / "given.toml").string()));
    const Case tire = open_file(warm_up);
    EXPECT_STREQ(tiretherm_value(tire.get(), "drive.speed"), "100 km/h");
    EXPECT_EQ(tiretherm_value(tire.get(), "drive.sped"), nullptr);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "drive.speed", "300 km/h"), TIRETHERM_OK);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "drive.speed", "120 km/h"), TIRETHERM_OK);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "effects.air_convection.lambda_h", "1.4"), TIRETHERM_OK);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "effects.road_contact.on", "false"), TIRETHERM_OK);
    EXPECT_STREQ(tiretherm_value(tire.get(), "drive.speed"), "120 km/h");
    EXPECT_EQ(last(run(tire), "bulk_temperature"), last(given, "bulk_temperature"));
    // Taken away, the values are those of the file and of the catalogue again.
    for (const char* address : {"drive.speed", "effects.air_convection.lambda_h", "effects.road_contact.on"}) {
        ASSERT_EQ(tiretherm_unset_value(tire.get(), address), TIRETHERM_OK);
    }
    EXPECT_EQ(tiretherm_value(tire.get(), "drive.speed"), nullptr);
    EXPECT_EQ(tiretherm_check_case(tire.get(), nullptr), TIRETHERM_BAD_ARGUMENT);  // there is no speed
    EXPECT_NE(std::string(tiretherm_case_message(tire.get())).find("speed"), std::string::npos);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "drive.speed", "120 km/h"), TIRETHERM_OK);
    EXPECT_EQ(tiretherm_check_case(tire.get(), nullptr), TIRETHERM_OK) << tiretherm_case_message(tire.get());
    EXPECT_NE(last(run(tire), "bulk_temperature"), last(given, "bulk_temperature"));
}

TEST(TirethermCases, AListIsSetAsTomlHasIt) {
    const Case tire = open_text("include = \"" + warm_up + "\"\n[data]\nfiles = [\"none.csv\"]\n");
    ASSERT_EQ(tiretherm_set_value(tire.get(), "data.files", "[\"a.csv\", \"b.csv\"]"), TIRETHERM_OK);
    EXPECT_STREQ(tiretherm_value(tire.get(), "data.files"), "a.csv, b.csv");
    // What is no list does not get into the case as more than a text.
    ASSERT_EQ(tiretherm_set_value(tire.get(), "title", "[1]\n[drive]\nspeed = \"1 km/h\""), TIRETHERM_OK);
    EXPECT_STREQ(tiretherm_value(tire.get(), "drive.speed"), "100 km/h");
}

TEST(TirethermCases, SaysAllMistakesWithTheirPlacesAndWhatWasSetByItsAddress) {
    const Case tire = open_text("include = \"" + warm_up + "\"\ntitel = \"x\"\n[time]\nend = \"5 kg\"\n");
    ASSERT_EQ(tiretherm_set_value(tire.get(), "drive.speed", "120 kg"), TIRETHERM_OK);
    tiretherm_answer* answer = nullptr;
    ASSERT_EQ(tiretherm_run_case(tire.get(), nullptr, nullptr, &answer), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(answer, nullptr);
    const std::string text = tiretherm_case_message(tire.get());
    EXPECT_NE(text.find("mine:2"), std::string::npos) << text;
    EXPECT_NE(text.find("titel"), std::string::npos) << text;
    EXPECT_NE(text.find("mine:4"), std::string::npos) << text;
    EXPECT_NE(text.find("drive.speed: "), std::string::npos) << text;
    EXPECT_NE(text.find("120 kg"), std::string::npos) << text;
    EXPECT_NE(text.find("100 km/h"), std::string::npos) << text;  // the remedy
    EXPECT_EQ(text.find("/tiretherm_"), std::string::npos) << text;
    EXPECT_EQ(tiretherm_check_case(tire.get(), nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_case_message(tire.get()), text);
    EXPECT_EQ(tiretherm_identify_case(tire.get(), nullptr, nullptr, &answer), TIRETHERM_BAD_ARGUMENT);
    EXPECT_NE(std::string(tiretherm_case_message(tire.get())).find("drive.speed: "), std::string::npos);
}

TEST(TirethermCases, WritesTheFilesOfARunIntoAFolder) {
    const sample::Scratch scratch;
    const Answer answer = run(open_file(warm_up), (scratch / "out").c_str());
    ASSERT_GT(tiretherm_file_count(answer.get()), 3);
    for (int i = 0; i < tiretherm_file_count(answer.get()); ++i) {
        EXPECT_TRUE(std::filesystem::exists(tiretherm_file(answer.get(), i))) << tiretherm_file(answer.get(), i);
    }
    EXPECT_TRUE(std::filesystem::exists(scratch / "out/report.html"));
    EXPECT_EQ(tiretherm_file(answer.get(), 1000), nullptr);
}

/// Rows of a run as a log.
void write_log(const Answer& answer, const std::filesystem::path& file) {
    const int bulk = tiretherm_find_channel(answer.get(), 0, "bulk_temperature");
    const auto n = static_cast<std::size_t>(tiretherm_channel_count(answer.get(), 0));
    std::string text = "time [s],bulk_temperature [K]\n";
    for (std::size_t i = 0; i < tiretherm_row_count(answer.get(), 0); ++i) {
        // 0.05 K that go up and down from row to row: a fit wants to see noise
        text += fmt::format(
            "{},{}\n", tiretherm_times(answer.get(), 0)[i],
            tiretherm_values(answer.get(), 0)[i * n + static_cast<std::size_t>(bulk)] + (i % 2 == 0 ? 0.05 : -0.05));
    }
    post::replace_file(file, text);
}

TEST(TirethermCases, AFitFindsTheValueThatTheDataWereMadeWith) {
    const sample::Scratch scratch;
    const Case truth = open_file(warm_up);
    ASSERT_EQ(tiretherm_set_value(truth.get(), "effects.air_convection.lambda_h", "1.3"), TIRETHERM_OK);
    write_log(run(truth), scratch / "log.csv");
    const Case tire =
        open_text("include = \"" + warm_up + "\"\n[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\n");
    const std::string log = (scratch / "log.csv").string();
    const std::array<const char*, 2> data{log.c_str(), nullptr};
    tiretherm_answer* found = nullptr;
    ASSERT_EQ(tiretherm_identify_case(tire.get(), data.data(), nullptr, &found), TIRETHERM_OK)
        << tiretherm_case_message(tire.get());
    const Answer fit(found);
    ASSERT_EQ(tiretherm_fitted_count(fit.get()), 1);
    EXPECT_STREQ(tiretherm_fitted_name(fit.get(), 0), "air_convection.lambda_h");
    EXPECT_STREQ(tiretherm_fitted_unit(fit.get(), 0), "1");
    EXPECT_STREQ(tiretherm_fitted_word(fit.get(), 0), "determined");
    EXPECT_LE(tiretherm_fitted_low(fit.get(), 0), 1.3);
    EXPECT_GE(tiretherm_fitted_high(fit.get(), 0), 1.3);
    // 0.05 K of some 40 K above the air, in each of many rows.
    EXPECT_NEAR(tiretherm_fitted_value(fit.get(), 0), 1.3, 1.3 * 0.05 / 40.0);
    EXPECT_TRUE(std::isnan(tiretherm_fitted_value(fit.get(), 1)));
    EXPECT_EQ(tiretherm_tire_count(fit.get()), 0);
    ASSERT_GT(tiretherm_file_count(fit.get()), 0);
    EXPECT_TRUE(std::filesystem::exists(tiretherm_file(fit.get(), 0)));

    // The comparison sees what the fit corrects: without it the bulk is too warm by kelvins.
    ASSERT_EQ(tiretherm_compare_case(tire.get(), data.data(), nullptr, &found), TIRETHERM_OK);
    const Answer comparison(found);
    EXPECT_NE(std::string(tiretherm_json(comparison.get())).find("\"rmse\""), std::string::npos);
    const std::string gone = tiretherm_file(fit.get(), 0);
    tiretherm_close_case(const_cast<Case&>(tire).release());
    EXPECT_FALSE(std::filesystem::exists(gone));
}

TEST(TirethermCases, ADiagnosisGivesItsVerdict) {
    const sample::Scratch scratch;
    const Case truth = open_file(warm_up);
    ASSERT_EQ(tiretherm_set_value(truth.get(), "effects.air_convection.lambda_h", "1.3"), TIRETHERM_OK);
    write_log(run(truth), scratch / "log.csv");
    const Case tire =
        open_text("include = \"" + warm_up + "\"\n[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\n");
    const std::string log = (scratch / "log.csv").string();
    const std::array<const char*, 2> data{log.c_str(), nullptr};
    tiretherm_answer* found = nullptr;
    ASSERT_EQ(tiretherm_diagnose_case(tire.get(), data.data(), nullptr, 0.0, &found), TIRETHERM_OK)
        << tiretherm_case_message(tire.get());
    const Answer diagnosis(found);
    EXPECT_STRNE(tiretherm_headline(diagnosis.get()), "");
    EXPECT_NE(std::string(tiretherm_json(diagnosis.get())).find("\"verdict\""), std::string::npos);
}

TEST(TirethermCases, ProgressStopsARunWithItsRowsUpToThen) {
    struct Seen {
        int calls = 0;
        double done = 0.0;
        std::string line{};
    };
    // A row a second: some seconds of work, of which a tenth is the first that progress tells of.
    const Case tire = open_file(warm_up);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "time.end", "3000000 s"), TIRETHERM_OK);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "time.output", "1 s"), TIRETHERM_OK);
    Seen seen;
    const auto stop = [](double done, const char* line, void* user) {
        *static_cast<Seen*>(user) = {static_cast<Seen*>(user)->calls + 1, done, line};
        return 1;
    };
    ASSERT_EQ(tiretherm_watch_case(tire.get(), stop, &seen), TIRETHERM_OK);
    tiretherm_answer* found = nullptr;
    ASSERT_EQ(tiretherm_run_case(tire.get(), nullptr, nullptr, &found), TIRETHERM_STOPPED)
        << tiretherm_case_message(tire.get());
    const Answer answer(found);
    EXPECT_STRNE(tiretherm_case_message(tire.get()), "");
    EXPECT_EQ(seen.calls, 1);
    EXPECT_NE(seen.line.find(" % "), std::string::npos) << seen.line;
    const std::size_t rows = tiretherm_row_count(answer.get(), 0);
    ASSERT_GT(rows, 1u);
    EXPECT_LT(tiretherm_times(answer.get(), 0)[rows - 1], 3e6);
    EXPECT_NEAR(seen.done, tiretherm_times(answer.get(), 0)[rows - 1] / 3e6, 1e-5);
    // The next call is not stopped by what stopped this one.
    ASSERT_EQ(tiretherm_watch_case(tire.get(), nullptr, nullptr), TIRETHERM_OK);
    ASSERT_EQ(tiretherm_set_value(tire.get(), "time.end", "100 s"), TIRETHERM_OK);
    EXPECT_EQ(tiretherm_row_count(run(tire).get(), 0), 101u);
}

TEST(TirethermCases, NothingInThePlaceOfACaseOrAnAnswerIsAnErrorAndNoCrash) {
    std::array<char, 200> message{};
    EXPECT_EQ(tiretherm_open_case(nullptr, message.data(), message.size()), nullptr);
    EXPECT_STREQ(message.data(), "no case file was named");
    EXPECT_EQ(tiretherm_open_case("none.toml", message.data(), message.size()), nullptr);
    EXPECT_STREQ(message.data(), "there is no file none.toml");
    EXPECT_EQ(tiretherm_open_text(nullptr, "mine", nullptr, 0), nullptr);
    EXPECT_EQ(tiretherm_open_text("", "a/b", nullptr, 0), nullptr);
    tiretherm_close_case(nullptr);
    tiretherm_free_answer(nullptr);
    EXPECT_EQ(tiretherm_set_value(nullptr, "drive.speed", "1 m/s"), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_unset_value(nullptr, "drive.speed"), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_value(nullptr, "drive.speed"), nullptr);
    EXPECT_EQ(tiretherm_check_case(nullptr, nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_watch_case(nullptr, nullptr, nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_STREQ(tiretherm_case_message(nullptr), "there is no case");
    auto* answer = reinterpret_cast<tiretherm_answer*>(&message);
    EXPECT_EQ(tiretherm_run_case(nullptr, nullptr, nullptr, &answer), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(answer, nullptr);
    EXPECT_EQ(tiretherm_compare_case(nullptr, nullptr, nullptr, nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_identify_case(nullptr, nullptr, nullptr, nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_diagnose_case(nullptr, nullptr, nullptr, 0.0, nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_headline(nullptr), nullptr);
    EXPECT_EQ(tiretherm_json(nullptr), nullptr);
    EXPECT_EQ(tiretherm_file(nullptr, 0), nullptr);
    EXPECT_EQ(tiretherm_tire_name(nullptr, 0), nullptr);
    EXPECT_EQ(tiretherm_values(nullptr, 0), nullptr);
    EXPECT_EQ(tiretherm_final_temperatures(nullptr, 0), nullptr);
    EXPECT_TRUE(std::isnan(tiretherm_fitted_low(nullptr, 0)));

    const Case tire = open_file(warm_up);
    EXPECT_EQ(tiretherm_set_value(tire.get(), nullptr, "1 m/s"), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_set_value(tire.get(), "drive.speed", nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_STREQ(tiretherm_case_message(tire.get()), "an address and a value are wanted");
    EXPECT_EQ(tiretherm_unset_value(tire.get(), nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_value(tire.get(), nullptr), nullptr);
    EXPECT_EQ(tiretherm_run_case(tire.get(), "no such run", nullptr, nullptr), TIRETHERM_BAD_ARGUMENT);
    EXPECT_EQ(tiretherm_run_case(tire.get(), nullptr, nullptr, nullptr), TIRETHERM_OK);
    const Answer answered = run(tire);
    for (const int none : {-1, 1}) {
        EXPECT_EQ(tiretherm_channel_count(answered.get(), none), 0);
        EXPECT_EQ(tiretherm_row_count(answered.get(), none), 0u);
        EXPECT_EQ(tiretherm_times(answered.get(), none), nullptr);
        EXPECT_EQ(tiretherm_find_channel(answered.get(), none, "bulk_temperature"), -1);
    }
    EXPECT_EQ(tiretherm_channel_unit(answered.get(), 0, -1), nullptr);
    EXPECT_EQ(tiretherm_find_channel(answered.get(), 0, nullptr), -1);
}

#ifdef TIRETHERM_COUNTS_ALLOCATIONS
TEST(TirethermCases, WithoutMemoryItFails) {
    const Case tire = open_file(warm_up);
    sample::allocations_left = 0;
    const int set = tiretherm_set_value(tire.get(), "effects.air_convection.lambda_h", "1.3");
    const int ran = tiretherm_run_case(tire.get(), nullptr, nullptr, nullptr);
    tiretherm_case* const opened = tiretherm_open_case(warm_up.c_str(), nullptr, 0);
    sample::allocations_left = std::numeric_limits<long>::max();
    EXPECT_EQ(set, TIRETHERM_FAILED);
    EXPECT_EQ(ran, TIRETHERM_FAILED);
    EXPECT_EQ(opened, nullptr);
    EXPECT_STREQ(tiretherm_case_message(tire.get()), "out of memory");
    run(tire);
}
#endif

}  // namespace
}  // namespace tiretherm
