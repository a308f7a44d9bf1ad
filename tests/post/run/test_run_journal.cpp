// SPDX-License-Identifier: BSD-3-Clause
// What a run that was killed has kept comes back whole, or is known to be damaged and not used.

#include <gtest/gtest.h>

#include "post/report/file.hpp"
#include "post/run/run_journal.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

namespace fs = std::filesystem;

const solver::Digest::Value run_identity{3, 4};
const solver::Checkpoint checkpoint{.numbers = {1.0, 2.0, 3.0}};
const std::vector<double> follower{4.0};

/// A folder in which a run has kept two rows, the second with its field.
class Kept {
public:
    Kept() : problem_(sample::problem()) {
        OutputFolder folder(scratch_ / "o");
        RunJournal journal(folder, run_identity, problem_, false);
        journal.take(sample::Moment(problem_, 0.0, {296.15, 296.15}, false).snapshot);
        journal.take(row_with_field());
        journal.keep(checkpoint, follower);
        folder.keep_journals();
    }
    [[nodiscard]] fs::path file(const std::string& name) const { return scratch_ / "o/.tiretherm" / name; }

    /// What the next call finds. @returns whether it goes on
    [[nodiscard]] bool goes_on(bool& damaged, const solver::Digest::Value& by = run_identity) {
        OutputFolder folder(scratch_ / "o");
        RunJournal journal(folder, by, problem_, false);
        folder.keep_journals();
        damaged = journal.is_damaged();
        if (journal.checkpoint() == nullptr) {
            return false;
        }
        EXPECT_EQ(journal.checkpoint()->numbers, checkpoint.numbers);
        EXPECT_EQ(journal.follower(), follower);
        std::vector<double> times;
        std::vector<std::size_t> fields;
        journal.replay([&](const solver::Snapshot& row) {
            times.push_back(row.time);
            fields.push_back(row.temperature.size());
        });
        EXPECT_EQ(times, (std::vector<double>{0.0, 30.0}));
        EXPECT_EQ(fields, (std::vector<std::size_t>{0, static_cast<std::size_t>(problem_.mesh.n_nodes)}));
        return true;
    }

private:
    solver::Snapshot row_with_field() {
        temperature_.assign(static_cast<std::size_t>(problem_.mesh.n_nodes), 300.0);
        return {.time = 30.0,
                .temperature = temperature_,
                .channels = channels_,
                .watts = effects_,
                .joules = effects_,
                .stored = 1.0,
                .field = true};
    }
    sample::Scratch scratch_;
    solver::Problem problem_;
    std::vector<double> temperature_;
    std::vector<double> channels_{353.15, 303.15};
    std::vector<double> effects_{0.0, 1.0, -0.25};
};

}  // namespace

TEST(RunJournal, GivesBackStateAndRows) {
    Kept kept;
    bool damaged = true;
    EXPECT_TRUE(kept.goes_on(damaged));
    EXPECT_FALSE(damaged);
}

// Any byte of the state, and any length: never another state than that which was kept. The two words of the run_identity make
// it a state of another call, which is nothing that a user should hear of.
TEST(RunJournal, DamagedStateIsNotUsedAndSaidToBeSo) {
    const std::string whole = [] { return read_text(Kept().file("run.state")); }();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        SCOPED_TRACE(at);
        Kept kept;
        std::string text = whole;
        text[at] = static_cast<char>(text[at] ^ 0x21);
        replace_file(kept.file("run.state"), text);
        bool damaged = false;
        EXPECT_FALSE(kept.goes_on(damaged));
        EXPECT_EQ(damaged, at < 8 || at >= 24);
        EXPECT_FALSE(fs::exists(kept.file("run.state")));
    }
    for (std::size_t length = 1; length < whole.size(); length += 5) {
        SCOPED_TRACE(length);
        Kept kept;
        replace_file(kept.file("run.state"), whole.substr(0, length));
        bool damaged = false;
        EXPECT_FALSE(kept.goes_on(damaged));
        EXPECT_EQ(damaged, length != 24);  // a head alone is what a call leaves that wrote nothing
    }
}

// Rows that the state counts are not there, or are those of another case: a row has as many numbers as the run's rows.
TEST(RunJournal, RowsThatAreNotThoseOfTheRunAreNotUsed) {
    {
        Kept kept;
        const std::string rows = read_text(kept.file("run.rows"));
        replace_file(kept.file("run.rows"), rows.substr(0, rows.size() - 1));
        bool damaged = false;
        EXPECT_FALSE(kept.goes_on(damaged));
        EXPECT_TRUE(damaged);
    }
    Kept kept;
    {
        RecordFile rows(kept.file("run.rows"), run_identity);
        rows.truncate(0);
        rows.append(std::vector<double>{1.0});
        rows.append(std::vector<double>{1.0, 2.0, 3.0, 4.0});
    }
    bool damaged = false;
    EXPECT_FALSE(kept.goes_on(damaged));
    EXPECT_TRUE(damaged);
}

// Numbers that no run of today leaves, with the right checksums: counts that are negative, no numbers, or beyond the end.
TEST(RunJournal, CountsThatCannotBeAreNotUsed) {
    for (const double wrong : {-1.0, 1e300, std::nan(""), 3.0}) {
        for (const std::size_t place : {0U, 3U}) {
            Kept kept;
            std::vector<double> numbers{2.0, 30.0, 1.0, 3.0, 1.0};  // rows, time, seconds, numbers of the solver, one
            numbers[place] = wrong;
            fs::remove(kept.file("run.state"));
            RecordFile(kept.file("run.state"), run_identity).append(numbers);
            bool damaged = false;
            EXPECT_FALSE(kept.goes_on(damaged)) << wrong << " at " << place;
            EXPECT_TRUE(damaged);
        }
    }
}

TEST(RunJournal, StateOfAnotherCallIsNoDamage) {
    Kept kept;
    bool damaged = true;
    EXPECT_FALSE(kept.goes_on(damaged, {3, 5}));
    EXPECT_FALSE(damaged);
}

}  // namespace tiretherm::post
