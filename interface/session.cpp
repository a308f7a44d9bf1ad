// SPDX-License-Identifier: BSD-3-Clause
// The C interface: reads a case, keeps a session, and turns what goes wrong into numbers and messages. No exception leaves it.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/runs/reader.hpp"
#include "interface/guard.hpp"
#include "interface/tiretherm.h"
#include "solver/quantity.hpp"
#include "solver/real_time/tunable_session.hpp"

using tiretherm::interface::guarded;
using tiretherm::interface::item_of;
using tiretherm::interface::refuse;
using tiretherm::physics::Signal;

struct tiretherm_session {
    struct Output {
        std::string name;
        std::string unit;
    };
    explicit tiretherm_session(const tiretherm::solver::SessionModel& model) : session(model) {
        for (const tiretherm::solver::Channel& channel : model.problem.channels) {
            outputs.push_back({channel.name, std::string(tiretherm::solver::description_of(channel.quantity).unit)});
        }
    }

    tiretherm::solver::TunableSession session;
    std::vector<Output> outputs;
    std::string message;
};

namespace {

const Signal* signal_of(int input) {
    const auto signals = tiretherm::physics::signals();
    return item_of(signals, input);
}

const tiretherm_session::Output* output_of(const tiretherm_session* session, int output) {
    return session != nullptr ? item_of(session->outputs, output) : nullptr;
}

const tiretherm::solver::FreeParameter* parameter_of(const tiretherm_session* session, int parameter) {
    return session != nullptr ? item_of(session->session.model().parameters, parameter) : nullptr;
}

/// A call with a session that may be none. @param call returns a tiretherm_result
template <typename Call>
int with(tiretherm_session* session, const Call& call) {
    return session != nullptr ? guarded(session->message, call) : TIRETHERM_BAD_ARGUMENT;
}

tiretherm_session* open_case(const char* case_file, std::string& message) {
    if (case_file == nullptr) {
        message = "no case file was named";
        return nullptr;
    }
    const tiretherm::input::Reading reading = tiretherm::input::read_case_run(case_file, "");
    if (!reading.problem) {
        message = tiretherm::input::render(reading);
        return nullptr;
    }
    const auto& [name, corner, problem, laps, parameters] = reading.chosen.front();
    if (const auto defects = tiretherm::solver::defects(problem); !defects.empty()) {
        message = fmt::format("{}: {}", case_file, fmt::join(defects, "; "));
        return nullptr;
    }
    return new tiretherm_session(tiretherm::solver::session_model(problem, parameters));
}

}  // namespace

extern "C" {

const char* tiretherm_version(void) { return TIRETHERM_VERSION; }

tiretherm_session* tiretherm_open(const char* case_file, char* message, size_t size) {
    return tiretherm::interface::opened(message, size, [&](std::string& text) { return open_case(case_file, text); });
}

void tiretherm_close(tiretherm_session* session) { delete session; }

int tiretherm_input_count(void) { return static_cast<int>(tiretherm::physics::signals().size()); }

// The names and units of signals are literals, which end with a zero.
const char* tiretherm_input_name(int input) {
    const Signal* signal = signal_of(input);
    return signal != nullptr ? signal->name.data() : nullptr;
}

const char* tiretherm_input_unit(int input) {
    const Signal* signal = signal_of(input);
    return signal != nullptr ? signal->unit.data() : nullptr;
}

int tiretherm_find_input(const char* name) {
    const auto signals = tiretherm::physics::signals();
    const auto found =
        std::ranges::find_if(signals, [&](const Signal& s) { return name != nullptr && s.name == name; });
    return found == signals.end() ? -1 : static_cast<int>(found - signals.begin());
}

int tiretherm_output_count(const tiretherm_session* session) {
    return session != nullptr ? static_cast<int>(session->outputs.size()) : 0;
}

const char* tiretherm_output_name(const tiretherm_session* session, int output) {
    const auto* found = output_of(session, output);
    return found != nullptr ? found->name.c_str() : nullptr;
}

const char* tiretherm_output_unit(const tiretherm_session* session, int output) {
    const auto* found = output_of(session, output);
    return found != nullptr ? found->unit.c_str() : nullptr;
}

int tiretherm_find_output(const tiretherm_session* session, const char* name) {
    for (int i = 0; name != nullptr && i < tiretherm_output_count(session); ++i) {
        if (session->outputs[static_cast<std::size_t>(i)].name == name) {
            return i;
        }
    }
    return -1;
}

int tiretherm_set_input(tiretherm_session* session, int input, double value) {
    return with(session, [&] {
        const Signal* signal = signal_of(input);
        if (signal == nullptr) {
            return refuse(session->message, TIRETHERM_BAD_ARGUMENT,
                          "there is no such input; tiretherm_find_input gives its number");
        }
        std::string reason = session->session.set_input(*signal, value);
        return reason.empty() ? TIRETHERM_OK : refuse(session->message, TIRETHERM_BAD_ARGUMENT, std::move(reason));
    });
}

int tiretherm_step(tiretherm_session* session, double dt) {
    return with(session, [&] {
        if (!(dt > 0.0) || !std::isfinite(dt)) {
            return refuse(session->message, TIRETHERM_BAD_ARGUMENT, "a step must be positive");
        }
        const tiretherm::solver::Status status = session->session.advance(dt);
        return status.ok() ? TIRETHERM_OK : refuse(session->message, TIRETHERM_FAILED, status.message);
    });
}

double tiretherm_output(const tiretherm_session* session, int output) {
    return output_of(session, output) != nullptr ? session->session.session().channel(static_cast<std::size_t>(output))
                                                 : std::numeric_limits<double>::quiet_NaN();
}

double tiretherm_time(const tiretherm_session* session) {
    return session != nullptr ? session->session.session().time() : std::numeric_limits<double>::quiet_NaN();
}

size_t tiretherm_temperature_count(const tiretherm_session* session) {
    return session != nullptr ? session->session.session().temperature().size() : 0;
}

const double* tiretherm_temperatures(const tiretherm_session* session) {
    return session != nullptr ? session->session.session().temperature().data() : nullptr;
}

int tiretherm_parameter_count(const tiretherm_session* session) {
    return session != nullptr ? static_cast<int>(session->session.model().parameters.size()) : 0;
}

const char* tiretherm_parameter_name(const tiretherm_session* session, int parameter) {
    const auto* found = parameter_of(session, parameter);
    return found != nullptr ? found->name.c_str() : nullptr;
}

const char* tiretherm_parameter_unit(const tiretherm_session* session, int parameter) {
    const auto* found = parameter_of(session, parameter);
    return found != nullptr ? found->unit.c_str() : nullptr;
}

double tiretherm_parameter(const tiretherm_session* session, int parameter) {
    return parameter_of(session, parameter) != nullptr ? session->session.parameter(static_cast<std::size_t>(parameter))
                                                       : std::numeric_limits<double>::quiet_NaN();
}

int tiretherm_set_parameter(tiretherm_session* session, int parameter, double value) {
    return with(session, [&] {
        if (parameter_of(session, parameter) == nullptr) {
            return refuse(session->message, TIRETHERM_BAD_ARGUMENT, "there is no such parameter");
        }
        std::string reason = session->session.set_parameter(static_cast<std::size_t>(parameter), value);
        if (!reason.empty()) {
            return refuse(session->message, TIRETHERM_BAD_ARGUMENT, std::move(reason));
        }
        session->session.apply_parameters();
        return static_cast<int>(TIRETHERM_OK);
    });
}

size_t tiretherm_state(tiretherm_session* session, double* state, size_t size) {
    std::size_t needed = 0;
    std::string why_not;
    static_cast<void>(guarded(why_not, [&] {
        if (session == nullptr) {
            return TIRETHERM_BAD_ARGUMENT;
        }
        const std::vector<double> now = session->session.state();
        if (state != nullptr && size >= now.size()) {
            std::ranges::copy(now, state);
        }
        needed = now.size();
        return TIRETHERM_OK;
    }));
    return needed;
}

int tiretherm_restore(tiretherm_session* session, const double* state, size_t size) {
    return with(session, [&] {
        return state != nullptr && session->session.restore({state, size})
                   ? TIRETHERM_OK
                   : refuse(session->message, TIRETHERM_BAD_ARGUMENT, "this is no state of the session's case");
    });
}

const char* tiretherm_message(const tiretherm_session* session) {
    return session != nullptr ? session->message.c_str() : "there is no session";
}

}  // extern "C"
