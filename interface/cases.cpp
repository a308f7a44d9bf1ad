// SPDX-License-Identifier: BSD-3-Clause
// Cases for C: keeps the values that are set in a file that includes the case, as the Python package does, and makes the calls.

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "calls/doing.hpp"
#include "calls/outcome.hpp"
#include "input/parameters/study_value.hpp"
#include "input/runs/reader.hpp"
#include "input/runs/runs.hpp"
#include "input/studies/case_values.hpp"
#include "input/toml/toml_text.hpp"
#include "interface/answer.hpp"
#include "interface/guard.hpp"
#include "interface/tiretherm_cases.h"
#include "post/report/file.hpp"
#include "solver/stop_signal.hpp"

namespace fs = std::filesystem;
using namespace tiretherm;
using interface::guarded;
using interface::refuse;

namespace {

/// A folder that is made when it is asked for, and goes with its owner.
class WorkFolder {
public:
    WorkFolder() = default;
    ~WorkFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;

    /// @errors std::system_error
    const fs::path& path() {
        if (path_.empty()) {
            std::string pattern = (fs::temp_directory_path() / "tiretherm_XXXXXX").string();
            if (mkdtemp(pattern.data()) == nullptr) {
                throw std::system_error(errno, std::generic_category(), pattern);
            }
            path_ = pattern;
        }
        return path_;
    }

private:
    fs::path path_;
};

}  // namespace

struct tiretherm_case {
    /// A value that was set, or taken away.
    struct Change {
        std::string address;
        std::optional<std::string> value;
    };

    WorkFolder work{};
    fs::path file{};
    std::string name{};  ///< of a text
    std::vector<Change> changes{};
    tiretherm_progress* progress = nullptr;
    void* user = nullptr;
    std::string message{};
    std::string value{};  ///< that was asked for last
};

namespace {

/// The case as it is now: its own file, or one that includes it and sets values, a line each.
struct CaseAsSet {
    fs::path file;
    std::vector<const tiretherm_case::Change*> lines{};  ///< [lines] what was set there; null: nothing

    /// Puts what was set in the place of a line that nobody has written.
    void place(const tiretherm_case& tire, input::InputError& error) const {
        const auto line = static_cast<std::size_t>(std::max(error.line, 1)) - 1;
        if (!lines.empty() && error.file == file.string()) {
            const tiretherm_case::Change* change = line < lines.size() ? lines[line] : nullptr;
            error.file = change != nullptr ? change->address : tire.file.string();
            error.line = 0;
            error.source.clear();
        } else if (!tire.name.empty() && error.file == tire.file.string()) {
            error.file = tire.name;
        }
    }
};

CaseAsSet as_set(tiretherm_case& tire) {
    namespace toml = input::toml_text;
    if (tire.changes.empty()) {
        return {.file = tire.file};
    }
    CaseAsSet set{.file = tire.work.path() / "cases" / (input::case_name(tire.file) + ".toml")};
    std::string text;
    const auto line = [&](const std::string& written, const tiretherm_case::Change* change) {
        text += written + "\n";
        set.lines.push_back(change);
    };
    line(fmt::format("include = [{}]", toml::in_quotes(tire.file.string())), nullptr);
    line("unset = [", nullptr);
    for (const tiretherm_case::Change& change : tire.changes) {
        if (!change.value) {
            line(toml::in_quotes(change.address) + ",", &change);
        }
    }
    line("]", nullptr);
    line("[set]", nullptr);
    for (const tiretherm_case::Change& change : tire.changes) {
        if (change.value) {
            const input::TomlValue value = input::value_of({*change.value, {}});
            line(fmt::format("{} = {}", toml::in_quotes(change.address), toml::value(value)), &change);
        }
    }
    fs::create_directories(set.file.parent_path());
    post::replace_file(set.file, text);
    return set;
}

/// Forgets what was set at an address. @returns whether anything was
bool forget(tiretherm_case& tire, const std::string& address) {
    return std::erase_if(tire.changes, [&](const tiretherm_case::Change& one) { return one.address == address; }) > 0;
}

bool is_in_file(const tiretherm_case& tire, const std::string& address) {
    const auto values = input::case_values(tire.file);
    return std::ranges::any_of(values, [&](const auto& one) { return one.first == address; });
}

/// Keeps the rows of runs.
class RowRecorder final : public calls::Recorder {
public:
    RowRecorder(tiretherm_answer& answer, post::ProgressLine::Listener progress)
        : Recorder(true, std::move(progress)), answer_(&answer) {}

    void begin(const input::RunOfCase& run) override { answer_->tires.push_back({.rows = calls::RecordedRows(run)}); }
    void row(const solver::Snapshot& row) override {
        answer_->tires.back().rows.take(row);
        answer_->tires.back().last.assign(row.temperature.begin(), row.temperature.end());
    }

private:
    tiretherm_answer* answer_;
};

int result_of(const calls::Outcome& outcome) {
    switch (outcome.exit) {
        case calls::Exit::done:
            return TIRETHERM_OK;
        case calls::Exit::input_error:
            return TIRETHERM_BAD_ARGUMENT;
        case calls::Exit::interrupted:
            return TIRETHERM_STOPPED;
        default:
            return TIRETHERM_FAILED;
    }
}

/// Why a call did not come to its end.
std::string reason_of(const tiretherm_case& tire, const CaseAsSet& set, calls::Outcome& outcome) {
    if (!outcome.errors.empty()) {
        input::CaseFindings findings{.errors = outcome.errors, .warnings = outcome.warnings};
        for (input::InputError& error : findings.errors) {
            set.place(tire, error);
        }
        return input::render(findings);
    }
    std::vector<std::string> parts = outcome.refused;
    if (!outcome.remedy.empty()) {
        parts.push_back(outcome.remedy);
    }
    if (parts.empty()) {
        return outcome.exit == calls::Exit::interrupted ? "stopped" : "the search did not converge";
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

/// Makes a call with the file of a case as it is set.
template <typename Call>
int make(tiretherm_case* tire, tiretherm_answer** answer, const Call& call) {
    if (answer != nullptr) {
        *answer = nullptr;
    }
    if (tire == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    return guarded(tire->message, [&] {
        const CaseAsSet set = as_set(*tire);
        auto made = std::make_unique<tiretherm_answer>();
        solver::StopScope scope;
        const auto tell = [&](const std::string& line, double share) {
            if (tire->progress(share, line.c_str(), tire->user) != 0) {
                scope.ask();
            }
        };
        RowRecorder recorder(*made, tire->progress != nullptr ? post::ProgressLine::Listener(tell) : nullptr);
        recorder.make([&](calls::Caller& caller) { return call(set.file.string(), caller); });
        calls::Outcome& outcome = recorder.outcome();
        const int result = result_of(outcome);
        if (result != TIRETHERM_OK) {
            tire->message = reason_of(*tire, set, outcome);
        }
        if (answer != nullptr && outcome.page) {
            interface::take(outcome, *made);
            *answer = made.release();
        }
        return result;
    });
}

std::string text_or_empty(const char* text) { return text != nullptr ? text : ""; }

/// What calls with measured data share. @param command whose folder it is where the caller names none
calls::MeasuredCall measured(tiretherm_case& tire, const std::string& file, const char* const* data, const char* folder,
                             const char* command) {
    calls::MeasuredCall call{.case_file = file, .data = {}, .directory = text_or_empty(folder)};
    for (; data != nullptr && *data != nullptr; ++data) {
        call.data.emplace_back(*data);
    }
    if (folder == nullptr) {
        call.directory = (tire.work.path() / command).string();
        call.no_report = true;
    }
    return call;
}

}  // namespace

extern "C" {

tiretherm_case* tiretherm_open_case(const char* case_file, char* message, size_t size) {
    return interface::opened(message, size, [&](std::string& text) -> tiretherm_case* {
        if (case_file == nullptr || !fs::is_regular_file(case_file)) {
            text = case_file == nullptr ? "no case file was named" : fmt::format("there is no file {}", case_file);
            return nullptr;
        }
        auto tire = std::make_unique<tiretherm_case>();
        tire->file = fs::absolute(case_file);
        return tire.release();
    });
}

tiretherm_case* tiretherm_open_text(const char* text, const char* name, char* message, size_t size) {
    return interface::opened(message, size, [&](std::string& why_not) -> tiretherm_case* {
        if (text == nullptr || name == nullptr || *name == '\0' || std::string(name).find('/') != std::string::npos) {
            why_not = text == nullptr ? "there is no text" : "a case needs a name, without a \"/\"";
            return nullptr;
        }
        auto tire = std::make_unique<tiretherm_case>();
        tire->name = name;
        tire->file = tire->work.path() / (tire->name + ".toml");
        post::replace_file(tire->file, text);
        return tire.release();
    });
}

void tiretherm_close_case(tiretherm_case* tire) { delete tire; }

int tiretherm_set_value(tiretherm_case* tire, const char* address, const char* value) {
    if (tire == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    return guarded(tire->message, [&] {
        if (address == nullptr || value == nullptr) {
            return refuse(tire->message, TIRETHERM_BAD_ARGUMENT, "an address and a value are wanted");
        }
        forget(*tire, address);
        tire->changes.push_back({address, value});
        return static_cast<int>(TIRETHERM_OK);
    });
}

int tiretherm_unset_value(tiretherm_case* tire, const char* address) {
    if (tire == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    return guarded(tire->message, [&] {
        if (address == nullptr) {
            return refuse(tire->message, TIRETHERM_BAD_ARGUMENT, "an address is wanted");
        }
        if (!forget(*tire, address) || is_in_file(*tire, address)) {
            tire->changes.push_back({address, std::nullopt});
        }
        return static_cast<int>(TIRETHERM_OK);
    });
}

const char* tiretherm_value(tiretherm_case* tire, const char* address) {
    if (tire == nullptr || address == nullptr) {
        return nullptr;
    }
    bool is_there = false;
    std::string why_not;
    static_cast<void>(guarded(why_not, [&] {
        for (auto& [path, value] : input::case_values(as_set(*tire).file)) {
            if (path == address) {
                tire->value = std::move(value);
                is_there = true;
            }
        }
        return TIRETHERM_OK;
    }));
    return is_there ? tire->value.c_str() : nullptr;
}

int tiretherm_check_case(tiretherm_case* tire, const char* run) {
    if (tire == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    return guarded(tire->message, [&] {
        const CaseAsSet set = as_set(*tire);
        input::Reading reading = input::read_case_run(set.file, text_or_empty(run));
        for (input::InputError& error : reading.errors) {
            set.place(*tire, error);
        }
        tire->message = reading.errors.empty() ? interface::in_lines(reading.warnings) : input::render(reading);
        return reading.errors.empty() ? TIRETHERM_OK : TIRETHERM_BAD_ARGUMENT;
    });
}

const char* tiretherm_case_message(const tiretherm_case* tire) {
    return tire != nullptr ? tire->message.c_str() : "there is no case";
}

int tiretherm_watch_case(tiretherm_case* tire, tiretherm_progress* progress, void* user) {
    if (tire == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    tire->message.clear();
    tire->progress = progress;
    tire->user = user;
    return TIRETHERM_OK;
}

int tiretherm_run_case(tiretherm_case* tire, const char* run, const char* folder, tiretherm_answer** answer) {
    return make(tire, answer, [&](const std::string& file, calls::Caller& caller) {
        const calls::RunOptions options{.case_file = file,
                                        .run = text_or_empty(run),
                                        .directory = text_or_empty(folder),
                                        .in_memory = folder == nullptr,
                                        .changes = {},
                                        .switched = {}};
        return calls::run(options, caller);
    });
}

int tiretherm_compare_case(tiretherm_case* tire, const char* const* data, const char* folder,
                           tiretherm_answer** answer) {
    return make(tire, answer, [&](const std::string& file, calls::Caller& caller) {
        return calls::compare(measured(*tire, file, data, folder, "compare"), caller);
    });
}

int tiretherm_identify_case(tiretherm_case* tire, const char* const* data, const char* folder,
                            tiretherm_answer** answer) {
    return make(tire, answer, [&](const std::string& file, calls::Caller& caller) {
        calls::IdentifyOptions options;
        static_cast<calls::MeasuredCall&>(options) = measured(*tire, file, data, folder, "identify");
        return calls::identify(options, caller);
    });
}

int tiretherm_diagnose_case(tiretherm_case* tire, const char* const* data, const char* folder, double time_limit,
                            tiretherm_answer** answer) {
    return make(tire, answer, [&](const std::string& file, calls::Caller& caller) {
        calls::DiagnoseOptions options;
        static_cast<calls::MeasuredCall&>(options) = measured(*tire, file, data, folder, "diagnose");
        options.time_limit = time_limit;
        return calls::diagnose(options, {}, caller);
    });
}

}  // extern "C"
