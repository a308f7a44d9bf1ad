// SPDX-License-Identifier: BSD-3-Clause
// Lock by flock, whose end is the process's; a list of what is to be moved makes the moves of a commit one whole.

#include "post/report/output_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "post/report/file.hpp"

namespace tiretherm::post {

namespace fs = std::filesystem;

namespace {

constexpr const char* hidden_name = ".tiretherm";
constexpr const char* lock_name = "lock";
constexpr const char* list_name = "commit";
constexpr const char* stage_name = "new";

/// Bytes: of a journal without a record, which has a head alone, or fewer.
constexpr std::uintmax_t head_of_journal = 24;

/// Marks of the lines of the list.
constexpr char moved = '+';
constexpr char removed = '-';

/// Names of the files in a folder, in order.
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

/// First line of a list: which folder it was written for. A list that came with a copy, an archive or a repository has
/// another number in it, and what it names is somebody's.
std::string head_of_list(const fs::path& hidden) {
    struct stat about {};
    const bool known = stat(hidden.c_str(), &about) == 0;
    return fmt::format("tiretherm {}", known ? about.st_ino : 0);
}

bool is_own_directory(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(fs::symlink_status(path, error));
}

/// A folder of ours: never a link, through which files of others would be removed.
void make_own_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directory(folder, error);
    if (!is_own_directory(folder)) {
        throw FileError("create the directory", folder,
                        error ? error.message() : "a file or a link of that name is in its place; remove it");
    }
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, std::vector<std::string> inputs)
    : folder_(std::move(folder)),
      hidden_(folder_ / hidden_name),
      stage_(hidden_ / stage_name),
      inputs_(std::move(inputs)) {
    std::error_code error;
    created_ = !fs::exists(folder_, error);
    create_folder(folder_);
    lock();
    try {
        roll_forward();
        fs::remove_all(stage_);
        make_own_folder(stage_);
    } catch (const fs::filesystem_error& failure) {
        keep_journals();
        clear();
        close(lock_);
        throw FileError("work in", folder_, failure.code().message());
    } catch (...) {
        keep_journals();
        clear();
        close(lock_);
        throw;
    }
}

OutputFolder::~OutputFolder() {
    clear();
    close(lock_);
}

fs::path OutputFolder::journal(const std::string& name) {
    journals_.push_back(name);
    return hidden_ / name;
}

bool OutputFolder::has_journal() const {
    return std::ranges::any_of(journals_, [this](const std::string& name) {
        std::error_code error;
        return fs::file_size(hidden_ / name, error) > head_of_journal && !error;
    });
}

/// The lock's file goes last and under the lock, so that nobody else holds it.
void OutputFolder::clear() const noexcept {
    std::error_code ignored;
    if (fs::exists(hidden_ / list_name, ignored)) {  // a half-done commit is left to the next call
        return;
    }
    fs::remove_all(stage_, ignored);
    for (const std::string& name : keep_journals_ ? std::vector<std::string>() : journals_) {
        fs::remove(hidden_ / name, ignored);
    }
    fs::remove(hidden_ / lock_name, ignored);
    fs::remove(hidden_, ignored);  // unless a journal is in it
    if (created_) {
        fs::remove(folder_, ignored);  // where nothing came into it
    }
}

void OutputFolder::lock() {
    // A call that ends takes the file away under its lock; whoever has opened it before looks again.
    while (!try_lock()) {
    }
}

bool OutputFolder::try_lock() {
    make_own_folder(hidden_);
    const fs::path path = hidden_ / lock_name;
    lock_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (lock_ < 0) {
        if (errno == ENOENT) {
            return false;
        }
        throw FileError("create", path, system_reason(errno));
    }
    if (flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        close(lock_);
        throw OutputError(fmt::format("another call of tiretherm works in {}", folder_.string()));
    }
    struct stat opened {};
    struct stat named {};
    if (fstat(lock_, &opened) == 0 && stat(path.c_str(), &named) == 0 && opened.st_ino == named.st_ino &&
        opened.st_dev == named.st_dev) {
        return true;
    }
    close(lock_);
    return false;
}

fs::path OutputFolder::home(const fs::path& staged) const { return folder_ / staged.filename(); }

std::vector<fs::path> OutputFolder::homes(const std::vector<fs::path>& staged) const {
    std::vector<fs::path> all;
    std::ranges::transform(staged, std::back_inserter(all), [this](const fs::path& path) { return home(path); });
    return all;
}

std::string OutputFolder::in_place(std::string message) const {
    const std::string from = stage_.string();
    for (std::size_t at = message.find(from); at != std::string::npos; at = message.find(from, at)) {
        message.replace(at, from.size(), folder_.string());
    }
    return message;
}

void OutputFolder::refuse_inputs(std::span<const std::string> names) const {
    for (const std::string& name : names) {
        for (const std::string& input : inputs_) {
            std::error_code error;
            if (fs::equivalent(folder_ / name, input, error) && !error) {
                throw OutputError(fmt::format("{} would be replaced, and it is a file that the call reads ({})",
                                              (folder_ / name).string(), input));
            }
        }
    }
}

void OutputFolder::commit(std::vector<std::string> stale) {
    const std::vector<std::string> fresh = names_in(stage_);
    std::erase_if(stale, [&](const std::string& name) {
        return std::ranges::binary_search(fresh, name) ||
               !fs::exists(fs::symlink_status(folder_ / name));  // a link that leads nowhere is there too
    });
    refuse_inputs(fresh);
    refuse_inputs(stale);
    std::string list = head_of_list(hidden_) + "\n";
    const auto add = [&](char mark, const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            if (is_own_directory(folder_ / name)) {
                throw FileError("replace", folder_ / name, "it is a directory");
            }
            list += fmt::format("{}{}\n", mark, name);
        }
    };
    add(removed, stale);
    add(moved, fresh);
    replace_file(hidden_ / list_name, list);
    roll_forward();
}

/// Does what the list says, as far as it is not done yet.
void OutputFolder::roll_forward() const {
    const fs::path list = hidden_ / list_name;
    std::error_code error;
    if (!fs::exists(list, error)) {
        return;
    }
    std::istringstream lines(read_text(list));
    std::string line;
    if (!std::getline(lines, line) || line != head_of_list(hidden_)) {
        throw OutputError(fmt::format(
            "{} was not written by a call in this folder, and would remove or replace files of it: look into "
            "{} and remove it",
            list.string(), hidden_.string()));
    }
    std::vector<std::pair<char, std::string>> steps;
    std::vector<std::string> names;
    while (std::getline(lines, line) && !line.empty()) {
        names.push_back(fs::path(line.substr(1)).filename().string());  // nothing leads out of the folder
        steps.emplace_back(line.front(), names.back());
    }
    refuse_inputs(names);
    for (const auto& [mark, name] : steps) {
        const fs::path target = folder_ / name;
        if (mark == removed) {
            fs::remove(target, error);
        } else if (fs::exists(fs::symlink_status(stage_ / name))) {  // otherwise it has been moved
            fs::rename(stage_ / name, target, error);
        }
        if (error) {
            throw FileError("replace", target, error.message());
        }
    }
    fs::remove(list);
}

}  // namespace tiretherm::post
