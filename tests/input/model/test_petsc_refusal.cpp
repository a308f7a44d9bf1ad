// SPDX-License-Identifier: BSD-3-Clause
// PETSc's linear solver is refused where runs are simulated side by side; whether the program has it does not matter.

#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "input/studies/study.hpp"
#include "input/validation/validation.hpp"
#include "solver/linear/petsc_factor.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view refusal =
    "PETSc solves for one simulation at a time, and this command makes several side by side";

std::string two_node_case(const std::string& time) {
    return "include = [\"" + (source_folder() / "cases/two_node/4000N_100kmh.toml").generic_string() + "\"]\n[time]\n" +
           time;
}

/// The places of the refusals, as file:line.
std::vector<std::string> refused(const std::vector<InputError>& errors) {
    std::vector<std::string> places;
    for (const InputError& error : errors) {
        if (error.what == refusal) {
            places.push_back(std::filesystem::path(error.file).filename().string() + ":" + std::to_string(error.line));
            EXPECT_NE(error.remedy.find("leave linear_solver out"), std::string::npos);
        }
    }
    return places;
}

}  // namespace

TEST(PetscRefusal, RunsOfMeasuredDataMayNotAskForPetsc) {
    const Written written;
    const std::filesystem::path file = written.add("mine.toml", two_node_case("linear_solver = \"petsc\"\n"));
    EXPECT_EQ(refused(read_experiment(file, {}, ReadMode::planned).errors), std::vector<std::string>{"mine.toml:3"});
    // `run` and `check` read the case alone.
    EXPECT_TRUE(refused(read_case(file).errors).empty());
    EXPECT_EQ(read_case(file).problem.has_value(), solver::has_petsc());
}

TEST(PetscRefusal, TheCaseOfAStudyMayNotAskForPetsc) {
    const Written written;
    written.add("mine.toml", two_node_case("linear_solver = \"petsc\"\n"));
    written.add("other.toml", two_node_case("linear_solver = \"automatic\"\n"));
    const std::string speeds = "[[vary]]\nkey = \"drive.speed\"\nvalues = [\"60 km/h\", \"80 km/h\"]\n";
    EXPECT_EQ(refused(read_study(written.add("study.toml", "case = \"mine.toml\"\n" + speeds)).errors),
              std::vector<std::string>{"mine.toml:3"});
    EXPECT_TRUE(read_study(written.add("study.toml", "case = \"other.toml\"\n" + speeds)).errors.empty());
}

TEST(PetscRefusal, CasesOfAValidationTableMayNotAskForPetsc) {
    const Written written;
    written.add("mine.toml", two_node_case("linear_solver = \"petsc\"\n"));
    const ValidationReading reading = read_validation(
        written.add("table.toml",
                    "[[number]]\nid = \"A\"\nwhat = \"bulk\"\nfiles = { two_node = \"mine.toml\" }\nchannel = "
                    "\"bulk_temperature\"\nvalue = \"64 degC\"\nuncertainty = \"1 K\"\nsource = \"page 1\"\n"));
    EXPECT_EQ(refused(reading.errors), std::vector<std::string>{"mine.toml:3"});
}

// Side by side with PETSc is one at a time; another solver has as many threads as there are, which is 0.
TEST(PetscRefusal, SimulationsWithPetscAreMadeOneAtATime) {
    EXPECT_EQ(solver::side_by_side(solver::LinearSolver::petsc), 1U);
    EXPECT_EQ(solver::side_by_side(solver::LinearSolver::cholesky), 0U);
}

}  // namespace tiretherm::input
