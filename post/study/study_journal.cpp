// SPDX-License-Identifier: BSD-3-Clause
// Reads and appends the JSON lines, drops a line that was cut off, and locks the file against a second process.

#include "post/study/study_journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN: null. Numbers keep all their digits.
double number(const Json& json) {
    return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

std::vector<double> numbers(const Json& json) {
    std::vector<double> values;
    for (const Json& item : json) {
        values.push_back(number(item));
    }
    return values;
}

std::string line_of(const RunIdentity& run, const StudyOutcome& outcome, const std::string& build) {
    Json json{{"run", run.fingerprint}, {"values", run.values}, {"build", build}};
    if (!outcome.ok()) {
        json["failure"] = outcome.failure;
    } else {
        json["hottest"] = outcome.hottest;
        json["hottest_time"] = outcome.hottest_time;
        json["hottest_layer"] = outcome.hottest_layer;
        json["hottest_zone"] = outcome.hottest_zone;
        json["final"] = outcome.channel_final;
        json["min"] = outcome.channel_min;
        json["max"] = outcome.channel_max;
        json["energy_closure"] = outcome.energy_closure;
        json["steps"] = outcome.steps;
    }
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

StudyOutcome outcome_of(const Json& json) {
    StudyOutcome outcome;
    if (json.contains("failure")) {
        outcome.failure = json.at("failure").get<std::string>();
        return outcome;
    }
    outcome.hottest = number(json.at("hottest"));
    outcome.hottest_time = number(json.at("hottest_time"));
    outcome.hottest_layer = json.at("hottest_layer").get<std::string>();
    outcome.hottest_zone = json.at("hottest_zone").get<std::string>();
    outcome.channel_final = numbers(json.at("final"));
    outcome.channel_min = numbers(json.at("min"));
    outcome.channel_max = numbers(json.at("max"));
    outcome.energy_closure = number(json.at("energy_closure"));
    outcome.steps = json.at("steps").get<long>();
    return outcome;
}

}  // namespace

/// The lock is the system's and ends with the process, however that ends.
struct StudyJournal::Lines {
    int file = -1;
    ~Lines() {
        if (file >= 0) {
            close(file);
        }
    }
};

StudyJournal::~StudyJournal() = default;

StudyJournal::StudyJournal(const std::filesystem::path& path, std::string build, bool fresh)
    : path_(path), build_(std::move(build)), lines_(std::make_unique<Lines>()) {
    lines_->file = open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (lines_->file < 0) {
        throw FileError("create", path, system_reason(errno));
    }
    if (flock(lines_->file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        throw Busy(fmt::format("another call of tiretherm study works in {}", path.parent_path().string()));
    }
    const std::string text = fresh ? std::string() : read_text(path);
    const std::size_t whole = text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1;
    if (ftruncate(lines_->file, static_cast<off_t>(whole)) != 0) {  // what follows was cut off by the program's end
        throw FileError("write", path, system_reason(errno));
    }
    read(text.substr(0, whole));
}

void StudyJournal::read(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        try {
            const Json json = Json::parse(line);
            if (json.at("build").get<std::string>() != build_) {
                ++outdated_;
                continue;
            }
            done_[{.fingerprint = json.at("run").get<std::string>(),
                   .values = json.at("values").get<std::vector<std::string>>()}] = outcome_of(json);
        } catch (const Json::exception&) {
            continue;  // a line that is none of ours, or damaged: its run is made again
        }
    }
}

const StudyOutcome* StudyJournal::find(const RunIdentity& run) const {
    const auto found = done_.find(run);
    return found == done_.end() ? nullptr : &found->second;
}

void StudyJournal::add(const RunIdentity& run, const StudyOutcome& outcome) {
    const std::string line = line_of(run, outcome, build_);
    // One call for the whole line: a process that is killed leaves all of it or nothing, save where the disk is full.
    if (write(lines_->file, line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
        throw FileError("write", path_, system_reason(errno));
    }
    done_[run] = outcome;
}

}  // namespace tiretherm::post
