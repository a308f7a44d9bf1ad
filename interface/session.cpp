// SPDX-License-Identifier: BSD-3-Clause
// The C interface: reads a case, keeps a session and the inputs of its next step, and turns what goes wrong into numbers and
// messages. No exception leaves it.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "input/runs/reader.hpp"
#include "interface/tiretherm.h"
#include "solver/quantity.hpp"
#include "solver/time_integration/session.hpp"

using tiretherm::physics::Signal;

struct tiretherm_session {
    struct Output {
        std::string name;
        std::string unit;
    };
    tiretherm_session(const tiretherm::solver::Problem& problem, const tiretherm::physics::Inputs& start)
        : session(problem, start), inputs(start) {
        for (const tiretherm::solver::Channel& channel : problem.channels) {
            outputs.push_back({channel.name, std::string(tiretherm::solver::description_of(channel.quantity).unit)});
        }
    }

    tiretherm::solver::Session session;
    tiretherm::physics::Inputs inputs;
    std::vector<Output> outputs;
    std::string message;
};

namespace {

const Signal* signal_of(int input) {
    const auto signals = tiretherm::physics::signals();
    return input >= 0 && static_cast<std::size_t>(input) < signals.size() ? &signals[static_cast<std::size_t>(input)]
                                                                          : nullptr;
}

const tiretherm_session::Output* output_of(const tiretherm_session* session, int output) {
    return session != nullptr && output >= 0 && static_cast<std::size_t>(output) < session->outputs.size()
               ? &session->outputs[static_cast<std::size_t>(output)]
               : nullptr;
}

/// As much of a text as there is room for.
void copy(const std::string& text, char* to, std::size_t size) {
    if (to != nullptr && size > 0) {
        const std::size_t n = std::min(text.size(), size - 1);
        std::memcpy(to, text.data(), n);
        to[n] = '\0';
    }
}

int refuse(tiretherm_session* session, int result, const char* reason) {
    session->message = reason;
    return result;
}

tiretherm_session* open_case(const char* case_file, std::string& message) {
    if (case_file == nullptr) {
        message = "no case file was named";
        return nullptr;
    }
    const tiretherm::input::Reading reading = tiretherm::input::read_case(case_file);
    if (!reading.problem) {
        message = tiretherm::input::render(reading);
        return nullptr;
    }
    const tiretherm::solver::Problem& problem = *reading.problem;
    if (const auto defects = tiretherm::solver::defects(problem); !defects.empty()) {
        message = fmt::format("{}: {}", case_file, fmt::join(defects, "; "));
        return nullptr;
    }
    tiretherm::physics::Inputs start =
        problem.input_signals.at(problem.settings.start, tiretherm::solver::JumpSide::after);
    start.time = 0.0;
    return new tiretherm_session(problem, start);
}

}  // namespace

extern "C" {

const char* tiretherm_version(void) { return TIRETHERM_VERSION; }

tiretherm_session* tiretherm_open(const char* case_file, char* message, size_t size) {
    std::string text;
    tiretherm_session* session = nullptr;
    try {
        session = open_case(case_file, text);
    } catch (const std::exception& error) {
        text = error.what();
    }
    copy(text, message, size);
    return session;
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
    if (session == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    session->message.clear();
    const Signal* signal = signal_of(input);
    if (signal == nullptr) {
        return refuse(session, TIRETHERM_BAD_ARGUMENT, "there is no such input; tiretherm_find_input gives its number");
    }
    if (!(value >= signal->low && value <= signal->high)) {
        return refuse(session, TIRETHERM_BAD_ARGUMENT,
                      fmt::format("{} = {} {} is not between {} and {}", signal->name, value, signal->unit, signal->low,
                                  signal->high)
                          .c_str());
    }
    session->inputs.*signal->member = value;
    return TIRETHERM_OK;
}

int tiretherm_step(tiretherm_session* session, double dt) {
    if (session == nullptr) {
        return TIRETHERM_BAD_ARGUMENT;
    }
    session->message.clear();
    if (!(dt > 0.0) || !std::isfinite(dt)) {
        return refuse(session, TIRETHERM_BAD_ARGUMENT, "a step must be positive");
    }
    try {
        const tiretherm::solver::Status status = session->session.advance(dt, session->inputs);
        return status.ok() ? TIRETHERM_OK : refuse(session, TIRETHERM_FAILED, status.message.c_str());
    } catch (const std::exception& error) {
        return refuse(session, TIRETHERM_FAILED, error.what());
    }
}

double tiretherm_output(const tiretherm_session* session, int output) {
    return output_of(session, output) != nullptr ? session->session.channel(static_cast<std::size_t>(output))
                                                 : std::numeric_limits<double>::quiet_NaN();
}

double tiretherm_time(const tiretherm_session* session) {
    return session != nullptr ? session->session.time() : std::numeric_limits<double>::quiet_NaN();
}

size_t tiretherm_temperature_count(const tiretherm_session* session) {
    return session != nullptr ? session->session.temperature().size() : 0;
}

const double* tiretherm_temperatures(const tiretherm_session* session) {
    return session != nullptr ? session->session.temperature().data() : nullptr;
}

const char* tiretherm_message(const tiretherm_session* session) {
    return session != nullptr ? session->message.c_str() : "there is no session";
}

}  // extern "C"
