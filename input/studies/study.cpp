// SPDX-License-Identifier: BSD-3-Clause
// Makes the runs as the product of grid and samples, and reads the case with the values of every run before the first
// one starts.

#include "input/studies/study.hpp"

#include <algorithm>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include "input/parameters/parameter_path.hpp"
#include "input/runs/reader.hpp"
#include "input/runs/runs.hpp"
#include "input/studies/study_fingerprint.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/word_lists.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_runs = 100'000;

/// Adds what is not known yet: most runs of a study say the same.
void add_new(std::vector<InputError>& known, const std::vector<InputError>& found) {
    for (const InputError& error : found) {
        const auto same = [&](const InputError& other) {
            return other.file == error.file && other.line == error.line && other.what == error.what;
        };
        if (std::none_of(known.begin(), known.end(), same)) {
            known.push_back(error);
        }
    }
}

/// Files in the order of their first errors, the study's before all; each from its first line down.
void put_in_order(std::vector<InputError>& errors, const std::string& study) {
    std::vector<std::string> files{study};
    for (const InputError& error : errors) {
        if (std::find(files.begin(), files.end(), error.file) == files.end()) {
            files.push_back(error.file);
        }
    }
    std::stable_sort(errors.begin(), errors.end(), [&](const InputError& a, const InputError& b) {
        const auto rank = [&](const InputError& m) {
            return std::tuple(std::find(files.begin(), files.end(), m.file), m.line, m.column);
        };
        return rank(a) < rank(b);
    });
}

/// What runs say, each once: of those of one form at one place the first.
class SaidByRuns {
public:
    void take(const std::vector<InputWarning>& warnings) {
        ++runs_;
        for (const InputWarning& one : warnings) {
            auto known = std::ranges::find_if(said_, [&](const Said& said) {
                const InputWarning& first = said.first;
                const bool is_alike = one.form.empty() ? one.what == first.what : one.form == first.form;
                return said.last_run != runs_ && is_alike && one.file == first.file && one.line == first.line;
            });
            if (known == said_.end()) {
                known = said_.insert(said_.end(), {.first = one});
            }
            known->differs = known->differs || known->first.what != one.what;
            known->runs += 1;
            known->last_run = runs_;
        }
    }
    [[nodiscard]] std::vector<std::string> sentences() const {
        std::vector<std::string> all;
        for (const Said& said : said_) {
            const std::string first = render(said.first);
            all.push_back(said.runs == runs_ && !said.differs
                              ? first
                              : fmt::format("{} (in {} of {} runs{})", first, said.runs, runs_,
                                            said.differs ? ", with numbers of their own" : ""));
        }
        return all;
    }

private:
    struct Said {
        InputWarning first;
        bool differs = false;
        std::size_t runs = 0;
        std::size_t last_run = 0;
    };
    std::vector<Said> said_;
    std::size_t runs_ = 0;
};

bool same_channels(const std::vector<solver::Channel>& a, const std::vector<solver::Channel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const solver::Channel& one, const solver::Channel& two) {
                          return one.name == two.name && one.quantity == two.quantity;
                      });
}

}  // namespace

/// Reads a study step by step; every step goes on after errors, so that all are reported.
class StudyReader {
public:
    [[nodiscard]] StudyReading read(const std::filesystem::path& file) {
        study_.file = file;
        const std::optional<TomlValue> document = read_document(file, study_.errors_);
        bool has_case = false;
        if (document) {
            TomlTable root(*document, "the study", study_.errors_);
            has_case = read_root(root);
        }
        StudyReading reading{.study = std::nullopt,
                             .errors = study_.errors_.in_order(),
                             .warnings = render(study_.errors_.warnings(), 0)};
        reading.files = study_.errors_.files();
        if (has_case && document) {
            read_runs_into(reading);
        }
        put_in_order(reading.errors, file.generic_string());
        reading.warnings = unique(reading.warnings);
        if (reading.errors.empty()) {
            reading.study = std::move(study_);
        }
        return reading;
    }

private:
    /// @returns whether there is a case to be read
    bool read_root(TomlTable& root) {
        root.declare_keys({"include", "unset", "set"});
        study_.title = root.text("title").value_or(study_.file.stem().string());
        study_.critical = root.quantity("critical");
        const std::optional<std::string> path = root.text("case", Need::required);
        study_.inputs = read_study_inputs(root, study_.samples, study_.seed);
        if (path) {
            read_base(*path, root.place("case"));
        }
        std::size_t n = study_.samples;
        // Cut at the limit step by step: the product of several long lists passes the largest integer.
        for (const StudyInput& input : study_.inputs) {
            n *= input.is_drawn ? 1 : std::min(std::max<std::size_t>(1, input.values.size()), most_runs + 1);
            n = std::min(n, most_runs + 1);
        }
        if (n > most_runs) {
            root.add_error("case", fmt::format("the study has more than {} runs", most_runs),
                           "vary fewer values, or draw samples");
            return false;
        }
        lay_out_runs(n);
        return study_.document_.kind == TomlValue::Kind::table;
    }

    void read_base(const std::string& path, const SourceLocation& mentioned) {
        study_.case_file = (study_.file.parent_path() / path).lexically_normal();
        study_.case_name = case_name(study_.case_file);
        InputErrors& errors = study_.errors_;
        std::error_code error;
        if (!std::filesystem::is_regular_file(study_.case_file, error)) {
            static_cast<void>(read_text(study_.case_file, mentioned, errors));
            return;
        }
        std::optional<TomlValue> document = read_document(study_.case_file, errors);
        if (document && document->find("run") != nullptr) {
            errors.add(mentioned, fmt::format("{} has measured runs, each with inputs of its own", path),
                       "give a case without [[run]], whose [drive] says how it is driven");
        } else if (document) {
            study_.document_ = std::move(*document);
        }
    }

    /// The first key is slowest, the samples are fastest.
    void lay_out_runs(std::size_t n) {
        for (std::size_t r = 0; r < n; ++r) {
            StudyRun run{.at = std::vector<std::size_t>(study_.inputs.size()), .fingerprint = {}};
            std::size_t rest = r / study_.samples;
            for (std::size_t i = study_.inputs.size(); i-- > 0;) {
                const StudyInput& input = study_.inputs[i];
                run.at[i] = input.is_drawn ? r % study_.samples : rest % std::max<std::size_t>(1, input.values.size());
                rest /= input.is_drawn ? 1 : std::max<std::size_t>(1, input.values.size());
            }
            study_.runs.push_back(std::move(run));
        }
    }

    void read_runs_into(StudyReading& reading) {
        Fingerprints fingerprints;
        SaidByRuns said;
        for (std::size_t r = 0; r < study_.runs.size() && !solver::stop_requested(); ++r) {
            InputErrors errors = study_.errors_;
            const TomlValue document = study_.document_of(r, errors);
            const Runs made = read_runs(document, study_.case_name, {}, ReadMode::measured, errors);
            const solver::Problem& problem = made.problem;
            if (r == 0) {
                study_.channels = problem.channels;
                study_.parts = names_of(made.critical);
            } else if (errors.count() == 0 && study_.parts != names_of(made.critical)) {
                errors.add({.file = 0}, fmt::format("run {} has other [[critical]] than the first run", r + 1),
                           "vary no names of critical temperatures");
            } else if (errors.count() == 0 && !same_channels(study_.channels, problem.channels)) {
                errors.add({.file = 0}, fmt::format("run {} has other channels than the first run", r + 1),
                           "vary no names of sensors");
            }
            add_new(reading.errors, errors.in_order());
            said.take(merged(errors.warnings(), made.corners.size()));
            const std::vector<std::string> files = errors.files();
            reading.files.insert(reading.files.end(), files.begin(), files.end());
            reading.files = unique(reading.files);
            study_.runs[r].fingerprint = fingerprints.of(document, errors);
        }
        reading.warnings = said.sentences();
    }

    Study study_;
};

bool Study::is_sampled() const {
    return std::any_of(inputs.begin(), inputs.end(), [](const StudyInput& input) { return input.is_drawn; });
}

TomlValue Study::document_of(std::size_t run, InputErrors& errors) const {
    TomlValue document = document_;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (inputs[i].values.empty()) {
            continue;
        }
        if (const auto path = ParameterPath::parse(inputs[i].key, document, errors)) {
            static_cast<void>(path->set(document, value(run, i).node, errors));
        }
    }
    return document;
}

StudyCase Study::case_of(std::size_t run) const {
    InputErrors errors = errors_;
    Runs made = read_runs(document_of(run, errors), case_name, {}, ReadMode::measured, errors);
    return {.problem = std::move(made.problem), .critical = std::move(made.critical)};
}

StudyReading read_study(const std::filesystem::path& file) { return StudyReader().read(file); }

}  // namespace tiretherm::input
