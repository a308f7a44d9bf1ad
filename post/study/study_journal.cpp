// SPDX-License-Identifier: BSD-3-Clause
// Reads and appends the JSON lines, drops lines that were cut off or damaged, and locks the file against a second process.

#include "post/study/study_journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <ranges>
#include <type_traits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"
#include "solver/members.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

using Json = nlohmann::ordered_json;

/// The key of each member of an outcome in a line.
constexpr std::array outcome_keys{"failure", "hottest", "hottest_time",   "hottest_layer", "hottest_zone", "final",
                                  "min",     "max",     "energy_closure", "steps",         "parts",        "warnings"};
static_assert(outcome_keys.size() == solver::count_members<StudyOutcome>());

/// Lists and structs as arrays. JSON has no NaN: null. Numbers keep all their digits.
template <typename T>
Json to_json(const T& value) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
        return value;
    } else {
        Json all = Json::array();
        const auto add = [&](const auto& one) { all.push_back(to_json(one)); };
        if constexpr (std::ranges::range<T>) {
            std::ranges::for_each(value, add);
        } else {
            solver::for_each_member(value, add);
        }
        return all;
    }
}

/// @errors Json::exception where the type is another one
template <typename T>
void from_json(const Json& json, T& into) {
    if constexpr (std::is_same_v<T, double>) {
        into = json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
    } else if constexpr (std::is_arithmetic_v<T>) {
        into = json.get_ref<const std::int64_t&>();
    } else if constexpr (std::is_same_v<T, std::string>) {
        into = json.get<std::string>();
    } else if constexpr (std::ranges::range<T>) {
        for (const Json& item : json.get_ref<const Json::array_t&>()) {
            from_json(item, into.emplace_back());
        }
    } else {
        std::size_t i = 0;
        solver::for_each_member(into, [&](auto& member) { from_json(json.at(i++), member); });
    }
}

std::string line_of(const RunIdentity& run, const StudyOutcome& outcome, const std::string& build) {
    Json json{{"run", run.fingerprint}, {"values", run.values}, {"build", build}};
    std::size_t i = 0;
    solver::for_each_member(outcome, [&](const auto& member) {
        const char* key = outcome_keys[i++];
        if ((key == outcome_keys.front()) != outcome.ok()) {  // a failure has a reason and nothing else
            json[key] = to_json(member);
        }
    });
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// What a line says of a run, or nothing where it cannot be one of ours.
/// @errors Json::exception where a key is missing or its value is of another type
std::optional<StudyOutcome> outcome_of(const Json& json, std::size_t channels) {
    StudyOutcome outcome;
    const bool failed = json.contains(outcome_keys.front());
    std::size_t i = 0;
    solver::for_each_member(outcome, [&](auto& member) {
        const char* key = outcome_keys[i++];
        if ((key == outcome_keys.front()) == failed) {
            from_json(json.at(key), member);
        }
    });
    const auto is_whole = [&](const std::vector<double>& values) { return values.size() == channels; };
    const bool sound = failed ? !outcome.ok()
                              : std::isfinite(outcome.hottest) && is_whole(outcome.channel_final) &&
                                    is_whole(outcome.channel_min) && is_whole(outcome.channel_max);
    return sound ? std::optional(std::move(outcome)) : std::nullopt;
}

/// Whether the first line of a text that is not blank was one of ours, before it was cut off or damaged.
bool was_ours(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \n");
    const std::string first = from == std::string::npos ? "" : text.substr(from, text.find('\n', from) - from);
    constexpr std::string_view begin = "{\"run\":\"";
    const bool has_keys =
        first.find("\"values\":[") != std::string::npos && first.find("\"build\":") != std::string::npos;
    return begin.starts_with(first) || (first.starts_with(begin) && (has_keys || !Json::accept(first)));
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

StudyJournal::StudyJournal(const std::filesystem::path& path, std::size_t channels, std::string build, bool fresh)
    : path_(path), channels_(channels), build_(std::move(build)), lines_(std::make_unique<Lines>()) {
    lines_->file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (lines_->file < 0) {
        throw FileError("create", path, system_reason(errno));
    }
    struct stat kind {};
    if (fstat(lines_->file, &kind) != 0 || !S_ISREG(kind.st_mode)) {
        throw FileError("use", path, "it is not a regular file");
    }
    if (flock(lines_->file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        throw Busy(fmt::format("another call of tiretherm study works in {}", path.parent_path().string()));
    }
    const std::string text = read_text(path);
    std::size_t whole = text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1;
    const std::vector<std::string_view> damaged = read(std::string_view(text).substr(0, whole));
    const bool has_ours = !done_.empty() || outdated_ > 0;
    if (!has_ours && !was_ours(text)) {
        throw FileError("use", path, "it holds something else than the runs of a study and is left as it is");
    }
    if (fresh) {
        whole = 0;
        done_.clear();
        outdated_ = 0;
    }
    if (ftruncate(lines_->file, static_cast<off_t>(whole)) != 0) {  // what follows was cut off by the program's end
        throw FileError("write", path, system_reason(errno));
    }
    for (const std::string_view line : fresh ? std::vector<std::string_view>() : damaged) {
        // Blanks in its place: the next call need not tell of it again.
        ++damaged_;
        const std::string blank(line.size(), ' ');
        if (pwrite(lines_->file, blank.data(), blank.size(), line.data() - text.data()) < 0) {
            throw FileError("write", path_, system_reason(errno));
        }
    }
    lseek(lines_->file, 0, SEEK_END);
}

std::vector<std::string_view> StudyJournal::read(std::string_view text) {
    std::vector<std::string_view> damaged;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = text.find('\n', from);
        const std::string_view line = text.substr(from, end - from);
        if (line.find_first_not_of(' ') != std::string_view::npos && !take(line)) {
            damaged.push_back(line);
        }
        from = end + 1;
    }
    return damaged;
}

bool StudyJournal::take(std::string_view line) {
    try {
        const Json json = Json::parse(line);
        if (json.at("build").get<std::string>() != build_) {
            ++outdated_;
            return true;
        }
        const std::optional<StudyOutcome> outcome = outcome_of(json, channels_);
        if (outcome) {
            done_[{.fingerprint = json.at("run").get<std::string>(),
                   .values = json.at("values").get<std::vector<std::string>>()}] = *outcome;
        }
        return outcome.has_value();
    } catch (const Json::exception&) {
        return false;
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
