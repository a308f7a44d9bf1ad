// SPDX-License-Identifier: BSD-3-Clause
// The targets: each puts the bytes where a user's file would be and reads it the way the commands do.

#include "fuzz/targets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "fuzz/promises.hpp"
#include "input/cameras/frame_file.hpp"
#include "input/effects/user_formula.hpp"
#include "input/log_survey/log_survey.hpp"
#include "input/new_case/new_case.hpp"
#include "input/runs/read_experiment.hpp"
#include "input/runs/reader.hpp"
#include "input/studies/study.hpp"
#include "input/tables/field_file.hpp"
#include "input/tire_property_file/tir_file.hpp"
#include "input/validation/validation.hpp"
#include "post/report/file.hpp"
#include "post/study/study_files.hpp"
#include "post/study/study_journal.hpp"
#include "post/study/study_report.hpp"
#include "post/study/study_tables.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr int most_cells = 200;             ///< of a case that is also run
constexpr double longest_simulated = 20.0;  ///< s

/// The first seconds of a case: it ends, or stops with a sentence; no temperature is without a number.
void run_shortly(solver::Problem problem) {
    const solver::Settings& asked = problem.settings;
    if (problem.mesh.n_cells > most_cells || asked.steady || asked.fixed_step.value_or(1.0) < 0.1 ||
        asked.tolerance < 1e-4) {
        return;
    }
    problem.settings.end = std::min(asked.end, asked.start + longest_simulated);
    int rows = 0;
    bool finite = true;
    const solver::MarchReport report = solver::run(problem, [&](const solver::Snapshot& snapshot) {
        for (const double kelvin : snapshot.temperature) {
            finite = finite && std::isfinite(kelvin);
        }
        return ++rows < 100;
    });
    promise(report.status.ok() || !report.status.message.empty(), "a run that failed without a sentence");
    promise(!report.status.ok() || finite, "a run that succeeded without a number");
}

bool take_case(std::string_view bytes) {
    // In the folder of the shipped cases, so that a text may include them.
    const input::Reading reading = input::read_case(shipped("two_node/fuzzed.toml"), std::string(bytes));
    check_outcome(reading.problem.has_value(), reading.errors, reading.warnings);
    if (reading.problem) {
        run_shortly(*reading.problem);
    }
    return reading.problem.has_value();
}

bool take_experiment(const fs::path& file, const std::vector<fs::path>& data, input::ReadMode mode) {
    const input::ExperimentReading reading = input::read_experiment(file, data, mode);
    check_outcome(reading.experiment.has_value(), reading.errors, reading.warnings);
    check_messages({}, reading.data_warnings);
    return reading.experiment.has_value();
}

bool take_run_csv(std::string_view bytes) {
    return take_experiment(shipped("practice/two_node_bench.toml"), {scratch_file("run.csv", bytes)},
                           input::ReadMode::planned);
}

bool take_run_hdf5(std::string_view bytes) {
    return take_experiment(shipped("practice/two_node_bench.toml"), {scratch_file("run.h5", bytes)},
                           input::ReadMode::planned);
}

bool take_run_ld(std::string_view bytes) {
    return take_experiment(shipped("practice/two_node_bench.toml"), {scratch_file("run.ld", bytes)},
                           input::ReadMode::planned);
}

/// A logger's file of any layout, with its laps.
bool take_log_survey(std::string_view bytes) {
    input::InputErrors errors;
    const std::optional<input::LogSurvey> survey = input::survey_log(scratch_file("log.csv", bytes), {}, errors);
    check_outcome(survey.has_value(), errors.in_order(), render(errors.warnings(), 0));
    for (std::size_t i = 1; survey && i < survey->laps.laps.size(); ++i) {
        promise(survey->laps.laps[i].start == survey->laps.laps[i - 1].end, "a gap between two laps");
    }
    return survey.has_value();
}

/// A logger's file of which `tiretherm new` makes a case.
bool take_new_case(std::string_view bytes) {
    const fs::path log = scratch_file("log.csv", bytes);
    const input::NewCaseRequest request{.size = std::get<input::TireSize>(input::read_tire_size("225/50 R17")),
                                        .log = log,
                                        .target = log.parent_path() / "case.toml"};
    const input::NewCase made = input::make_new_case(request);
    check_outcome(made.errors.empty(), made.errors, made.warnings);
    promise(made.errors.empty() != made.text.empty(), "a case beside errors, or neither");
    return made.errors.empty();
}

/// The place of a case that names the file.
input::SourceLocation mention(input::InputErrors& errors) {
    return {.file = errors.add_file("case.toml", "file = \"fuzzed\"\n"), .line = 1, .column = 8, .length = 8};
}

bool take_frames(const fs::path& path) {
    constexpr std::size_t most_frames = 20;
    input::InputErrors errors;
    const std::optional<input::FrameFile> file = input::open_frames(path, mention(errors), errors);
    check_outcome(file.has_value(), errors.in_order(), render(errors.warnings(), 0));
    if (file) {
        std::vector<double> kelvin(static_cast<std::size_t>(file->rows) * static_cast<std::size_t>(file->columns));
        for (std::size_t frame = 0; frame < std::min(file->time.size(), most_frames); ++frame) {
            if (!file->read(frame, kelvin)) {
                break;
            }
        }
    }
    return file.has_value();
}

bool take_frames_csv(std::string_view bytes) { return take_frames(scratch_file("frames.csv", bytes)); }

bool take_frames_hdf5(std::string_view bytes) { return take_frames(scratch_file("frames.h5", bytes)); }

bool take_field(const fs::path& path) {
    using physics::FieldOf;
    bool read = false;
    for (const FieldOf of : {FieldOf::pressure, FieldOf::friction, FieldOf::loss}) {
        input::InputErrors errors;
        const auto file =
            input::read_field_file(path, mention(errors), of, of != FieldOf::pressure, of == FieldOf::loss, errors);
        check_outcome(file.has_value(), errors.in_order(), render(errors.warnings(), 0));
        if (file && file->against == input::FieldFile::Against::wheel_angle) {
            double sum = 0.0;
            for (const double share : file->shares_of_revolution()) {
                sum += share;
            }
            promise(std::abs(sum - 1.0) < 1e-9, fmt::format("shares of a revolution with the sum {}", sum));
        }
        read = read || file.has_value();
    }
    return read;
}

bool take_field_csv(std::string_view bytes) { return take_field(scratch_file("field.csv", bytes)); }

bool take_field_hdf5(std::string_view bytes) { return take_field(scratch_file("field.h5", bytes)); }

bool take_tir(std::string_view bytes) {
    input::InputErrors errors;
    const std::optional<input::TirFile> tire = input::read_tir_file(scratch_file("tire.tir", bytes), {}, errors);
    check_outcome(tire.has_value(), errors.in_order(), render(errors.warnings(), 0));
    return tire.has_value();
}

bool take_study(std::string_view bytes) {
    const input::StudyReading reading = input::read_study(scratch_file("study.toml", bytes));
    check_outcome(reading.study.has_value(), reading.errors, reading.warnings);
    return reading.study.has_value();
}

bool take_validation(std::string_view bytes) {
    const input::ValidationReading reading = input::read_validation(scratch_file("validation.toml", bytes));
    check_outcome(reading.table.has_value(), reading.errors, reading.warnings);
    return reading.table.has_value();
}

/// A study of three runs whose journal was damaged: what is found in it can be written.
bool take_study_journal(std::string_view bytes) {
    static const input::Study study = [] {
        const std::string text = fmt::format(
            "case = \"{}\"\n[[vary]]\nkey = \"drive.speed\"\nvalues = [\"80 km/h\", \"100 km/h\", \"120 km/h\"]\n",
            shipped("two_node/4000N_100kmh.toml").string());
        input::StudyReading reading = input::read_study(scratch_file("journal_study.toml", text));
        promise(reading.study.has_value(), "the study of the target cannot be read");
        return std::move(*reading.study);
    }();
    const fs::path path = scratch_file("runs.jsonl", bytes);
    std::vector<diagnosis::StudyOutcome> outcomes;
    bool any = false;
    try {
        const post::StudyJournal journal(path, study.channels.size(), "build", false);
        for (std::size_t run = 0; run < study.runs.size(); ++run) {
            // The fingerprint depends on this machine's paths: the corpus calls the runs by their numbers.
            const diagnosis::StudyOutcome* found = journal.find({fmt::format("run {}", run), {}});
            diagnosis::StudyOutcome none;
            none.failure = "not made";
            any = any || found != nullptr;
            outcomes.push_back(found ? *found : none);
        }
    } catch (const post::FileError&) {
        promise(post::read_text(path) == bytes, "a file of somebody else's is another than before");
        return false;
    }
    const diagnosis::StudyRecord record = post::study_record(study, outcomes);
    promise(!post::study_csv(record).empty(), "a study without a table");
    static_cast<void>(post::study_report(record, {}));
    return any;
}

/// A formula as it is parsed, and its values where they are unusual.
bool take_formula(std::string_view bytes) {
    input::Formula::Wrong wrong;
    const std::string text(bytes);
    const std::optional<input::Formula> formula = input::Formula::read(text, "follows", wrong);
    if (!formula) {
        promise(!wrong.error.what.empty() && wrong.error.what.size() < 4000, "a formula refused without a sentence");
        promise(wrong.from <= text.size(), "a formula that is wrong behind its end");
        return false;
    }
    std::vector<double> values(formula->signals().size());
    input::FormulaDecisions decisions;
    for (const double value : {0.0, -1.0, 0.5, 1e308, -1e-308, std::numeric_limits<double>::infinity(), std::nan("")}) {
        std::fill(values.begin(), values.end(), value);
        formula->evaluate(values, decisions);
        promise(decisions.taken.size() == decisions.margins.size(), "decisions without margins");
    }
    return true;
}

/// A formula of the time as a user's heat source.
bool take_formula_run(std::string_view bytes) {
    if (bytes.find("'''") != std::string_view::npos || (!bytes.empty() && bytes.back() == '\'')) {
        return false;
    }
    const std::string text = fmt::format(
        "include = [\"4000N_100kmh.toml\"]\n[time]\nend = \"20 s\"\n"
        "[[source]]\nname = \"made\"\nat = \"surface\"\nwatts = \"1 W\"\nfollows = '''{}'''\n",
        bytes);
    return take_case(text);
}

constexpr std::array all{
    Target{"case", take_case},
    Target{"run_csv", take_run_csv},
    Target{"run_hdf5", take_run_hdf5},
    Target{"run_ld", take_run_ld},
    Target{"log_survey", take_log_survey},
    Target{"new_case", take_new_case},
    Target{"frames_csv", take_frames_csv},
    Target{"frames_hdf5", take_frames_hdf5},
    Target{"field_csv", take_field_csv},
    Target{"field_hdf5", take_field_hdf5},
    Target{"tir", take_tir},
    Target{"study", take_study},
    Target{"study_journal", take_study_journal},
    Target{"validation", take_validation},
    Target{"formula", take_formula},
    Target{"formula_run", take_formula_run},
};

}  // namespace

std::span<const Target> targets() { return all; }

const Target* find_target(std::string_view name) {
    const auto* found = std::find_if(all.begin(), all.end(), [&](const Target& target) { return target.name == name; });
    return found == all.end() ? nullptr : found;
}

}  // namespace tiretherm::fuzz
