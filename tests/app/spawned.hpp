// SPDX-License-Identifier: BSD-3-Clause
// Begins the built program beside the test, to be killed, stopped or waited for; and compares folders byte by byte.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {

/// A call of the program that is under way.
class Spawned {
public:
    /// @param arguments separated by blanks  @param folder where it works  @param checkpoints seconds between them
    Spawned(const std::string& arguments, std::filesystem::path folder, const std::string& checkpoints = "")
        : folder_(std::move(folder)) {
        std::vector<std::string> words{"tiretherm"};
        std::istringstream text(arguments);
        for (std::string word; text >> word;) {
            words.push_back(word);
        }
        std::vector<char*> pointers;
        pointers.reserve(words.size() + 1);
        for (std::string& word : words) {
            pointers.push_back(word.data());
        }
        pointers.push_back(nullptr);
        begin_ = std::chrono::steady_clock::now();
        child_ = fork();
        if (child_ == 0) {
            dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
            dup2(open(scratch_.path().append("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
            dup2(open(scratch_.path().append("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
            if (!checkpoints.empty()) {
                setenv("TIRETHERM_CHECKPOINT_SECONDS", checkpoints.c_str(), 1);
            }
            if (chdir(folder_.c_str()) == 0) {
                execv(TIRETHERM_PROGRAM, pointers.data());
            }
            _exit(99);
        }
    }
    ~Spawned() {
        if (!over_) {
            send(SIGKILL);
            wait();
        }
    }
    Spawned(const Spawned&) = delete;
    Spawned& operator=(const Spawned&) = delete;

    void send(int signal) const { kill(child_, signal); }
    /// @returns its status as waitpid gives it
    int wait() {
        if (!over_) {
            waitpid(child_, &status_, 0);
            over_ = true;
        }
        return status_;
    }
    /// Its exit code, or minus the signal that ended it.
    int end() { return WIFEXITED(wait()) ? WEXITSTATUS(status_) : -WTERMSIG(status_); }
    /// Seconds from its begin to its end, which this waits for.
    double seconds() {
        wait();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    }
    [[nodiscard]] std::string err() const { return post::read_text(scratch_ / "err"); }
    [[nodiscard]] std::string out() const { return post::read_text(scratch_ / "out"); }
    /// Waits until it has said what it does with a signal.
    [[nodiscard]] bool hears(int signal) const {
        for (int i = 0; i < 6000; ++i) {
            std::ifstream status("/proc/" + std::to_string(child_) + "/status");
            for (std::string line; std::getline(status, line);) {
                if (line.starts_with("SigCgt:") &&
                    ((std::stoull(line.substr(7), nullptr, 16) >> (signal - 1)) & 1U) != 0) {
                    return true;
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }
    /// Waits until it works in a folder of results: it has read its files by then.
    [[nodiscard]] bool works_in(const std::string& out) const {
        for (int i = 0; i < 6000; ++i) {
            if (std::filesystem::exists(folder_ / out / ".tiretherm/new")) {
                return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        return false;
    }

private:
    struct Files : sample::Scratch {
        [[nodiscard]] std::filesystem::path path() const { return sample::Scratch::path(); }
    };
    Files scratch_;
    std::filesystem::path folder_;
    pid_t child_ = -1;
    bool over_ = false;
    int status_ = 0;
    std::chrono::steady_clock::time_point begin_;
};

/// All files of a folder by their names; the seconds that a report says it took are left out, and of the page, which says them
/// in words, all but that it is whole.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
    static const std::regex seconds("\"seconds\": [-0-9.e]+");
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            std::string text = post::read_text(entry.path());
            if (entry.path().extension() == ".json") {
                text = std::regex_replace(text, seconds, "\"seconds\": 0");
            }
            if (entry.path().filename() == "report.html") {
                text = text.ends_with("</html>\n") ? "a whole page" : "cut off";
            }
            if (entry.path().filename() == "page.txt") {  // it says how long the call took
                text = text.ends_with('\n') ? "a whole page" : "cut off";
            }
            files[entry.path().lexically_relative(folder).string()] = std::move(text);
        }
    }
    return files;
}

/// Lines of a text in order: of a study's journal, whose runs end in any.
inline std::string sorted_lines(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    std::ranges::sort(lines);
    return fmt::format("{}", fmt::join(lines, "\n"));
}

}  // namespace tiretherm::app_test
