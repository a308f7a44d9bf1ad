// SPDX-License-Identifier: BSD-3-Clause
// The command line as the caller of a call: results on stdout, as text or JSON, the rest on stderr.
#pragma once

#include <string>
#include <vector>

#include "app/messages.hpp"
#include "app/output.hpp"
#include "calls/caller.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

/// Prints what comes of a call.
class Terminal : public calls::Caller {
public:
    using Caller::refuse;

    Terminal(bool json, bool quiet) : Caller(quiet), json_(json) {}

    void refuse(const std::vector<std::string>& sentences, const std::string& remedy) override;
    void refuse(const input::CaseFindings& findings, const std::string& consequence) override;
    void take(const post::Report& page) override;
    void take(const std::string& text) override;
    void complain(const std::string& sentence, const std::string& remedy) override;
    void note(const std::string& sentence) override;

private:
    bool json_;
};

/// The options of a call with those of how it is told.
template <class Options>
struct Told : Options {
    bool json = false;
    bool quiet = false;
};

/// --quiet and --json. @param instead_of the page
template <class Options>
void add_told_options(CLI::App& command, Told<Options>& options, const std::string& instead_of) {
    add_quiet_option(command, options.quiet);
    add_json_option(command, options.json, instead_of);
}

/// Makes a call that Ctrl-C ends. @param options are Told  @param call takes them and a caller  @returns the exit code
template <class Options, class Call>
[[nodiscard]] int make(const Options& options, const Call& call) {
    solver::install_stop_handlers();
    Terminal terminal(options.json, options.quiet);
    return call(options, terminal);
}

}  // namespace tiretherm::app
