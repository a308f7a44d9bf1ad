#include "input/studies/study.hpp"

#include <algorithm>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include "input/model/reader.hpp"
#include "input/measurements/runs.hpp"
#include "input/studies/study_fingerprint.hpp"
#include "input/parameters/study_key.hpp"
#include "input/text/wanted.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_runs = 100'000;

/// Adds what is not known yet: most runs of a study say the same.
void add_new(std::vector<Mistake>& known, const std::vector<Mistake>& found) {
    for (const Mistake& mistake : found) {
        const auto same = [&](const Mistake& other) {
            return other.file == mistake.file && other.line == mistake.line && other.what == mistake.what;
        };
        if (std::none_of(known.begin(), known.end(), same)) {
            known.push_back(mistake);
        }
    }
}

/// Files as they were first complained about, the study's before all; each from its first line down.
void put_in_order(std::vector<Mistake>& mistakes, const std::string& study) {
    std::vector<std::string> files{study};
    for (const Mistake& mistake : mistakes) {
        if (std::find(files.begin(), files.end(), mistake.file) == files.end()) {
            files.push_back(mistake.file);
        }
    }
    std::stable_sort(mistakes.begin(), mistakes.end(), [&](const Mistake& a, const Mistake& b) {
        const auto rank = [&](const Mistake& m) {
            return std::tuple(std::find(files.begin(), files.end(), m.file), m.line, m.column);
        };
        return rank(a) < rank(b);
    });
}

bool same_channels(const std::vector<solver::Channel>& a, const std::vector<solver::Channel>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const solver::Channel& one, const solver::Channel& two) {
                          return one.name == two.name && one.quantity == two.quantity;
                      });
}

}  // namespace

/// Reads a study step by step; every step goes on behind mistakes, so that all are told.
class StudyReader {
public:
    [[nodiscard]] StudyReading read(const std::filesystem::path& file) {
        study_.file = file;
        const std::optional<Node> document = read_document(file, study_.mistakes_);
        bool has_case = false;
        if (document) {
            Section root(*document, "the study", study_.mistakes_);
            has_case = read_root(root);
        }
        StudyReading reading{
            .study = std::nullopt, .mistakes = study_.mistakes_.in_order(), .warnings = study_.mistakes_.warnings()};
        if (has_case && document) {
            read_runs_into(reading);
        }
        put_in_order(reading.mistakes, file.generic_string());
        reading.warnings = unique(reading.warnings);
        if (reading.mistakes.empty()) {
            reading.study = std::move(study_);
        }
        return reading;
    }

private:
    /// @returns whether there is a case to be read
    bool read_root(Section& root) {
        root.know({"include"});
        study_.title = root.text("title").value_or(study_.file.stem().string());
        study_.critical = root.quantity("critical", wanted::temperature);
        const std::optional<std::string> path = root.text("case", Need::required);
        study_.inputs = read_study_inputs(root, study_.samples, study_.seed);
        if (path) {
            read_base(*path, root.place("case"));
        }
        std::size_t n = study_.samples;
        for (const StudyInput& input : study_.inputs) {
            n *= input.is_drawn ? 1 : std::min(std::max<std::size_t>(1, input.values.size()), most_runs + 1);
            n = std::min(n, most_runs + 1);
        }
        if (n > most_runs) {
            root.mistake("case", fmt::format("the study has more than {} runs", most_runs),
                         "vary fewer values, or draw samples");
            return false;
        }
        lay_out_runs(n);
        return study_.document_.kind == Node::Kind::table;
    }

    void read_base(const std::string& path, const Place& mentioned) {
        study_.case_file = (study_.file.parent_path() / path).lexically_normal();
        study_.case_name = case_name(study_.case_file);
        Mistakes& mistakes = study_.mistakes_;
        std::error_code error;
        if (!std::filesystem::is_regular_file(study_.case_file, error)) {
            static_cast<void>(read_text(study_.case_file, mentioned, mistakes));
            return;
        }
        std::optional<Node> document = read_document(study_.case_file, mistakes);
        if (document && document->find("run") != nullptr) {
            mistakes.add(mentioned, fmt::format("{} has measured runs, each with inputs of its own", path),
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
        for (std::size_t r = 0; r < study_.runs.size(); ++r) {
            Mistakes mistakes = study_.mistakes_;
            const Node document = study_.document_of(r, mistakes);
            const solver::Problem problem =
                read_runs(document, study_.case_name, {}, Occasion::measured, mistakes).problem;
            if (r == 0) {
                study_.channels = problem.channels;
            } else if (mistakes.count() == 0 && !same_channels(study_.channels, problem.channels)) {
                mistakes.add({.file = 0}, fmt::format("run {} has other channels than the first run", r + 1),
                             "vary no names of sensors");
            }
            add_new(reading.mistakes, mistakes.in_order());
            reading.warnings.insert(reading.warnings.end(), mistakes.warnings().begin(), mistakes.warnings().end());
            reading.warnings = unique(reading.warnings);
            study_.runs[r].fingerprint = fingerprints.of(document, mistakes);
        }
    }

    Study study_;
};

bool Study::is_sampled() const {
    return std::any_of(inputs.begin(), inputs.end(), [](const StudyInput& input) { return input.is_drawn; });
}

Node Study::document_of(std::size_t run, Mistakes& mistakes) const {
    Node document = document_;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!inputs[i].values.empty()) {
            static_cast<void>(write_at(document, inputs[i].key, value(run, i).node, mistakes));
        }
    }
    return document;
}

solver::Problem Study::problem(std::size_t run) const {
    Mistakes mistakes = mistakes_;
    return read_runs(document_of(run, mistakes), case_name, {}, Occasion::measured, mistakes).problem;
}

StudyReading read_study(const std::filesystem::path& file) { return StudyReader().read(file); }

}  // namespace tiretherm::input
