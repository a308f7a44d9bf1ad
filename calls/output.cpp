// SPDX-License-Identifier: BSD-3-Clause
// Opens and commits the folder of a call's files, with the sentences for what keeps it from that.

#include "calls/output.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "calls/build_identity.hpp"
#include "post/report/file.hpp"
#include "post/report/record_file.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

namespace {

constexpr const char* elsewhere = "choose another directory with --out";
constexpr const char* unchanged = "the files of an earlier call are as they were; choose another directory with --out";

}  // namespace

std::unique_ptr<post::OutputFolder> open_output(const std::filesystem::path& folder, std::vector<std::string> inputs,
                                                const std::vector<std::string>& names, const std::string& consequence,
                                                Caller& caller) {
    try {
        auto opened = std::make_unique<post::OutputFolder>(folder, std::move(inputs));
        opened->refuse_inputs(names);
        return opened;
    } catch (const std::runtime_error& error) {
        caller.refuse(error.what(), fmt::format("{}; {}", consequence, elsewhere));
        return nullptr;
    }
}

bool write_output(post::OutputFolder& folder, const std::vector<std::string>& stale, Caller& caller,
                  const std::function<void()>& write) {
    try {
        write();
        folder.commit(stale);
        return true;
    } catch (const std::exception& error) {
        const bool of_files = dynamic_cast<const post::FileError*>(&error) != nullptr ||
                              dynamic_cast<const post::OutputError*>(&error) != nullptr ||
                              dynamic_cast<const std::filesystem::filesystem_error*>(&error) != nullptr;
        // What was computed is worth more than the room that it takes: with a disk that is less full the call goes on.
        const bool kept = folder.has_journal();
        if (kept) {
            folder.keep_journals();
        }
        if (!of_files) {
            throw;
        }
        caller.refuse(
            folder.in_place(error.what()),
            kept ? fmt::format("{}, or make room: the same call goes on from what is kept", unchanged) : unchanged);
    }
    return false;
}

solver::Digest::Value call_identity(const std::vector<std::string>& files, const std::vector<std::string>& arguments) {
    solver::Digest digest;
    digest.add(std::string_view(build_identity()));
    for (const std::string& argument : arguments) {
        digest.add(std::string_view(argument));
    }
    post::add_files(digest, files);
    return digest.value();
}

void tell_of_continuation(const std::string& kept, Caller& caller) {
    caller.note(fmt::format("an interrupted call is continued: {}", kept));
}

void tell_of_damage(const std::string& consequence, Caller& caller) {
    caller.note(fmt::format("what an interrupted call has kept was cut off or damaged; {}", consequence));
}

bool was_stopped(const std::string& consequence, Caller& caller) {
    if (!solver::stop_requested()) {
        return false;
    }
    caller.refuse(stop_sentence(), consequence);
    return true;
}

std::string stop_sentence() { return solver::is_time_up() ? "the time limit has passed" : "stopped"; }

int stop_exit() { return solver::is_time_up() ? Exit::numerical_failure : Exit::interrupted; }

}  // namespace tiretherm::calls
