// SPDX-License-Identifier: BSD-3-Clause
// Reads messages whole before anything changes, all their mistakes at once, and steps the sessions of all tires.

#include "app/live/live_tires.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "input/text/quantity.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "solver/quantity.hpp"

namespace tiretherm::app::live {

namespace {

constexpr double longest_step = 1.0;  // s: a step has no error control
constexpr double latest_time = 1e7;   // s: beyond, a double does not hold a nanosecond
const std::vector<std::string> keys{"time", "inputs", "tires", "restart"};

std::string with_remedy(const std::string& what, const std::string& remedy) {
    return remedy.empty() ? what : what + "; " + remedy;
}

/// Of an input, a tire or a key that is not there. @param kind in the singular
std::string unknown(const std::string& kind, const std::string& name, const std::vector<std::string>& known) {
    return with_remedy(fmt::format("there is no {} \"{}\"", kind, name), input::suggest(name, known, kind + "s"));
}

/// A value of the wire: a number is SI, a text has its unit. @param error stays empty where there is none
double read_value(const physics::Signal& signal, const Json& value, std::string& error) {
    if (!value.is_string() && !value.is_number()) {
        error = fmt::format("{} is neither a number in {} nor a text with a unit", signal.name, signal.unit);
        return 0.0;
    }
    const input::QuantitySpec spec = input::quantity_specs::of(signal);
    const input::ParsedQuantity parsed =
        value.is_string() ? input::parse_quantity(value.get_ref<const std::string&>(), spec, signal.name)
                          : input::check_quantity(value.get<double>(), {}, signal.unit, spec, signal.name,
                                                  fmt::format("{} {}", value.dump(), signal.unit));
    error = parsed.error ? with_remedy(parsed.error->what, parsed.error->remedy) : "";
    return parsed.value;
}

/// Of {"speed": 30, "camber": "-2 deg"}. @param whose before what is wrong: "FL: "
InputValues read_inputs(const Json& given, const std::string& whose, std::vector<std::string>& errors) {
    InputValues values;
    if (!given.is_object()) {
        errors.push_back(whose + "inputs are no object; write {\"speed\": 30}");
        return values;
    }
    for (const auto& [name, value] : given.items()) {
        const physics::Signal* signal = physics::find_signal(name);
        std::string error;
        if (signal == nullptr) {
            error = unknown("input", name, input::names_of(physics::signals()));
        } else {
            values.emplace_back(signal, read_value(*signal, value, error));
        }
        if (!error.empty()) {
            errors.push_back(whose + error);
        }
    }
    return values;
}

std::span<const solver::Channel> sensors_of(const solver::TunableSession& session) {
    const solver::Problem& problem = session.model().problem;
    return std::span(problem.channels).first(problem.n_sensors());
}

}  // namespace

Json refusal(const std::vector<std::string>& sentences) { return {{"errors", sentences}}; }

LiveTires::LiveTires(const std::vector<input::RunOfCase>& runs, bool at_all_corners) {
    const auto add = [this](const std::string& name, const input::RunOfCase& run) {
        tires_.push_back({name, solver::TunableSession(solver::session_model(run.problem, {}))});
    };
    for (const input::RunOfCase& run : runs) {
        if (at_all_corners) {
            for (const char* corner : {"FL", "FR", "RL", "RR"}) {
                add(corner, run);
            }
        } else {
            add(run.corner.empty() ? "tire" : run.corner, run);
        }
    }
}

Json LiveTires::hello() const {
    const solver::Problem& problem = tires_.front().session.model().problem;
    Json json{{"tiretherm", TIRETHERM_VERSION}, {"protocol", 1},
              {"case", problem.name},           {"title", problem.title},
              {"longest_step", longest_step},   {"tires", Json::object()}};
    for (const Tire& tire : tires_) {
        Json& one = json["tires"][tire.name] = {{"inputs", Json::array()}, {"outputs", Json::array()}};
        for (const physics::Signal* signal : tire.session.model().inputs()) {
            one["inputs"].push_back({{"name", signal->name},
                                     {"unit", signal->unit},
                                     {"low", signal->low},
                                     {"high", signal->high},
                                     {"start", tire.session.model().start.*signal->member},
                                     {"meaning", signal->meaning}});
        }
        for (const solver::Channel& sensor : sensors_of(tire.session)) {
            const solver::ShownUnit shown = solver::shown_unit(sensor.quantity);
            one["outputs"].push_back({{"name", sensor.name},
                                      {"unit", solver::unit_of(sensor.quantity)},
                                      {"shown", {{"unit", shown.name}, {"factor", shown.factor}, {"zero", shown.zero}}},
                                      {"meaning", sensor.meaning}});
        }
    }
    return json;
}

LiveTires::Asked LiveTires::read(const Json& message) const {
    Asked asked;
    for (const auto& [key, value] : message.items()) {
        if (std::ranges::find(keys, key) == keys.end()) {
            asked.errors.push_back(unknown("key", key, keys));
        }
    }
    const Json time = message.value("time", Json());
    if (time.is_number() && std::abs(time.get<double>()) <= latest_time) {
        asked.time = time.get<double>();
    } else {
        asked.errors.push_back(
            fmt::format("time must be a number of seconds, of the simulator, up to {:g}", latest_time));
    }
    if (!message.value("restart", Json(false)).is_boolean()) {
        asked.errors.push_back("restart is true or false");
    }
    const InputValues of_all = read_inputs(message.value("inputs", Json::object()), "", asked.errors);
    const Json each = message.value("tires", Json::object());
    if (!each.is_object()) {
        asked.errors.push_back("tires is no object; write {\"FL\": {\"vertical_load\": 4000}}");
        return asked;
    }
    const std::vector<std::string> names = input::names_of(tires_);
    for (const std::string& name : names) {
        InputValues& values = asked.values.emplace_back(of_all);
        const InputValues own = read_inputs(each.value(name, Json::object()), name + ": ", asked.errors);
        values.insert(values.end(), own.begin(), own.end());
    }
    for (const auto& [name, value] : each.items()) {
        if (std::ranges::find(names, name) == names.end()) {
            asked.errors.push_back(unknown("tire", name, names));
        }
    }
    return asked;
}

Json LiveTires::begin(const Json& message) {
    const Asked asked = read(message);
    if (!asked.errors.empty()) {
        return refusal(asked.errors);
    }
    for (std::size_t i = 0; i < tires_.size(); ++i) {
        physics::Inputs start = tires_[i].session.model().start;
        for (const auto& [signal, value] : asked.values[i]) {
            start.*signal->member = value;
        }
        tires_[i].session.begin(start);
    }
    time_ = asked.time;
    steps_ = 0;
    is_broken_ = false;
    return frame();
}

Json LiveTires::step(const Json& message) {
    Asked asked = read(message);
    // Steps that a simulator takes alike are alike to the last bit, whatever its clock was rounded to.
    const double dt = std::round((asked.time - time_) * 1e9) / 1e9;
    if (asked.errors.empty() && is_broken_) {
        asked.errors.push_back("the last step failed; begin anew with \"restart\": true");
    } else if (asked.errors.empty() && !(dt > 0.0)) {
        asked.errors.push_back(fmt::format(
            "the time went from {} s to {} s; it must go on, or begin anew with \"restart\": true", time_, asked.time));
    } else if (asked.errors.empty() && dt > longest_step) {
        asked.errors.push_back(fmt::format(
            "a step of {:g} s is longer than {:g} s; send times between, or begin anew with \"restart\": true", dt,
            longest_step));
    }
    if (!asked.errors.empty()) {
        return refusal(asked.errors);
    }
    is_broken_ = true;  // unless all come through
    for (std::size_t i = 0; i < tires_.size(); ++i) {
        auto& [name, session] = tires_[i];
        for (const auto& [signal, value] : asked.values[i]) {
            static_cast<void>(session.set_input(*signal, value));  // within its range, which has been checked
        }
        if (const solver::Status status = session.advance(dt); !status.ok()) {
            return refusal({name + ": " + status.message + "; begin anew with \"restart\": true"});
        }
    }
    is_broken_ = false;
    time_ = asked.time;
    ++steps_;
    return frame();
}

Json LiveTires::frame() const {
    Json json{{"time", time_}, {"step", steps_}, {"tires", Json::object()}};
    for (const Tire& tire : tires_) {
        Json& one = json["tires"][tire.name] = Json::object();
        const std::span<const solver::Channel> sensors = sensors_of(tire.session);
        for (std::size_t i = 0; i < sensors.size(); ++i) {
            one[sensors[i].name] = tire.session.session().channel(i);
        }
    }
    return json;
}

}  // namespace tiretherm::app::live
