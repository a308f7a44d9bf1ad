// SPDX-License-Identifier: BSD-3-Clause
// The calling sequence of an FMU. A session takes its steps; here is what the standard asks for around it.

#include "interface/fmu/instance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace tiretherm::fmu {

namespace {

solver::SessionModel read_model(const std::filesystem::path& resources, std::string_view token) {
    const std::filesystem::path path = resources / "session.bin";
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    if (!file) {
        throw std::runtime_error(fmt::format("{} cannot be read", path.string()));
    }
    const std::string own = solver::token_of(bytes);
    if (token != own) {
        throw std::runtime_error(fmt::format("the FMU is {}, not {}: its description is of another", own, token));
    }
    return solver::session_model_from(bytes);
}

/// Two times that differ by rounding only. @param scale s
bool is_same(double a, double b, double scale) { return std::abs(a - b) <= 1e-9 * (std::abs(b) + scale); }

constexpr std::array known_categories{log_events, log_discard, log_error, log_all};

}  // namespace

std::string_view name_of(Mode mode) {
    constexpr std::array<std::string_view, 4> names{"instantiated", "in initialization mode", "in step mode",
                                                    "terminated"};
    return names[static_cast<std::size_t>(mode)];
}

Instance::Instance(const std::filesystem::path& resources, std::string_view token, Logger logger, bool logging)
    : token_(token),
      logger_(std::move(logger)),
      logs_events_(logging),
      session_(std::make_unique<solver::TunableSession>(read_model(resources, token))),
      inputs_(session_->model().inputs()),
      numbers_(session_->model()) {
    kept_.stop_time = std::numeric_limits<double>::infinity();
    log(Status::ok, log_events,
        fmt::format("{} nodes, {} inputs, {} parameters, {} outputs", session_->session().temperature().size(),
                    inputs_.size(), session_->model().parameters.size(), session_->model().problem.channels.size()));
}

void Instance::check_mode(std::initializer_list<Mode> allowed) const {
    if (std::ranges::find(allowed, mode_) == allowed.end()) {
        throw std::logic_error(fmt::format("it cannot be called while the instance is {}", name_of(mode_)));
    }
}

void Instance::log(Status status, std::string_view category, const std::string& message) const {
    if (logger_ && (status != Status::ok || logs_events_)) {
        logger_(status, category.data(), message);
    }
}

void Instance::set_logging(bool on, std::span<const char* const> categories) {
    bool events = categories.empty();
    for (const char* category : categories) {
        if (category == nullptr || std::ranges::find(known_categories, category) == known_categories.end()) {
            throw std::invalid_argument(
                fmt::format("there is no log category \"{}\"", category != nullptr ? category : ""));
        }
        events = events || category == log_events || category == log_all;
    }
    logs_events_ = on && events;
}

void Instance::set_up(double start_time, bool has_stop, double stop_time) {
    if (!std::isfinite(start_time) || (has_stop && !(stop_time > start_time))) {
        throw std::invalid_argument(fmt::format("from {} s to {} s is no experiment", start_time, stop_time));
    }
    kept_.start_time = kept_.point = start_time;
    kept_.stop_time = has_stop ? stop_time : std::numeric_limits<double>::infinity();
    is_set_up_ = true;
}

void Instance::exit_initialization() {
    follow_settings();
    mode_ = Mode::step;
    log(Status::ok, log_events, fmt::format("initialized at {} s", kept_.start_time));
}

void Instance::reset() {
    session_ = std::make_unique<solver::TunableSession>(session_->model());
    kept_ = {.stop_time = std::numeric_limits<double>::infinity(), .session = {}};
    mode_ = Mode::instantiated;
    is_set_up_ = is_stale_ = false;
}

/// Before the first step the session begins with what was set; then a parameter that was moved acts from now on.
void Instance::follow_settings() {
    if (!is_stale_) {
        return;
    }
    if (mode_ == Mode::step) {
        session_->apply_parameters();
    } else {
        session_->begin(session_->inputs());
    }
    is_stale_ = false;
}

void Instance::get(std::span<const std::uint32_t> which, std::span<double> values) {
    if (values.size() != which.size()) {
        throw std::invalid_argument(fmt::format("{} values of {} variables", values.size(), which.size()));
    }
    follow_settings();
    for (std::size_t i = 0; i < which.size(); ++i) {
        const std::size_t number = which[i];
        if (number >= numbers_.end) {
            throw std::invalid_argument(fmt::format("there is no variable {}", number));
        }
        values[i] = number == 0 ? kept_.point
                    : number < numbers_.first_parameter
                        ? session_->inputs().*inputs_[number - numbers_.first_input]->member
                    : number < numbers_.first_output ? session_->parameter(number - numbers_.first_parameter)
                                                     : session_->session().channel(number - numbers_.first_output);
    }
}

void Instance::check_settable(std::uint32_t which) const {
    if (which < numbers_.first_input || which >= numbers_.first_output) {
        throw std::invalid_argument(
            fmt::format("variable {} {}", which, which < numbers_.end ? "cannot be set" : "is unknown"));
    }
    if (which >= numbers_.first_parameter && mode_ != Mode::instantiated && mode_ != Mode::initialization &&
        session_->model().parameters[which - numbers_.first_parameter].kind == solver::FreeParameter::Kind::initial) {
        throw std::invalid_argument(fmt::format("variable {} is fixed after initialization", which));
    }
}

void Instance::set(std::span<const std::uint32_t> which, std::span<const double> values) {
    if (values.size() != which.size()) {
        throw std::invalid_argument(fmt::format("{} values of {} variables", values.size(), which.size()));
    }
    std::ranges::for_each(which, [this](std::uint32_t number) { check_settable(number); });
    const auto each = [&](const auto& of_input, const auto& of_parameter) {
        for (std::size_t i = 0; i < which.size(); ++i) {
            const bool is_input = which[i] < numbers_.first_parameter;
            std::string refusal = is_input ? of_input(*inputs_[which[i] - numbers_.first_input], values[i])
                                           : of_parameter(which[i] - numbers_.first_parameter, values[i]);
            if (!refusal.empty()) {
                throw Discarded(refusal);
            }
            is_stale_ = is_stale_ || !is_input || mode_ != Mode::step;
        }
    };
    // What is out of range leaves all as it was.
    each([this](const physics::Signal& signal, double value) { return session_->refusal(signal, value); },
         [this](std::size_t index, double value) { return session_->refusal(index, value); });
    each([this](const physics::Signal& signal, double value) { return session_->set_input(signal, value); },
         [this](std::size_t index, double value) { return session_->set_parameter(index, value); });
    if (mode_ == Mode::step) {
        follow_settings();  // a step allocates nothing
    }
}

void Instance::derive(std::span<const std::uint32_t> unknowns, std::span<const std::uint32_t> knowns,
                      std::span<const double> seed, std::span<double> sensitivity) {
    if (seed.size() != knowns.size() || sensitivity.size() != unknowns.size()) {
        throw std::invalid_argument(fmt::format("{} seeds of {} knowns, {} places for {} unknowns", seed.size(),
                                                knowns.size(), sensitivity.size(), unknowns.size()));
    }
    for (const std::uint32_t unknown : unknowns) {
        if (unknown < numbers_.first_output || unknown >= numbers_.end) {
            throw std::invalid_argument(
                fmt::format("variable {} is no output, which the unknowns have to be", unknown));
        }
    }
    solver::SessionDirection direction;
    for (std::size_t i = 0; i < knowns.size(); ++i) {
        check_settable(knowns[i]);
        if (!std::isfinite(seed[i])) {
            throw std::invalid_argument(fmt::format("the seed of variable {} is {}", knowns[i], seed[i]));
        }
        if (knowns[i] < numbers_.first_parameter) {
            direction.inputs.push_back({inputs_[knowns[i] - numbers_.first_input], seed[i]});
        } else {
            direction.parameters.push_back({knowns[i] - numbers_.first_parameter, seed[i]});
        }
    }
    follow_settings();
    std::vector<double> slopes(numbers_.end - numbers_.first_output);
    if (const solver::Status status = session_->find_slopes(direction, slopes); !status.ok()) {
        throw Discarded(status.message);
    }
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        sensitivity[i] = slopes[unknowns[i] - numbers_.first_output];
    }
}

void Instance::step(double point, double size) {
    if (!is_same(point, kept_.point, size)) {
        throw std::invalid_argument(fmt::format("a step from {} s, where the instance is at {} s", point, kept_.point));
    }
    if (!(size > 0.0) || !std::isfinite(size)) {
        throw std::invalid_argument(fmt::format("a step of {} s; a step must be positive", size));
    }
    const double end = point + size;
    if (end > kept_.stop_time && !is_same(end, kept_.stop_time, size)) {
        throw std::invalid_argument(fmt::format("a step to {} s, past the end at {} s", end, kept_.stop_time));
    }
    if (const solver::Status status = session_->advance(size); !status.ok()) {
        throw Discarded(status.message);
    }
    kept_.point = end;
}

KeptState Instance::state() {
    follow_settings();
    KeptState state = kept_;
    state.mode = mode_;
    state.session = session_->state();
    return state;
}

void Instance::restore(const KeptState& state) {
    if (!session_->restore(state.session)) {
        throw std::invalid_argument("this is no state of the FMU");
    }
    mode_ = state.mode;
    is_stale_ = false;
    is_set_up_ = true;
    kept_ = state;
    kept_.session.clear();
}

namespace {

/// The head of a serialised state: the token, then the mode, the times, and how many numbers follow.
struct Head {
    std::array<char, 32> token{};
    double mode = 0.0;
    std::array<double, 3> times{};
    std::uint64_t length = 0;
};

}  // namespace

std::string Instance::serialised(const KeptState& state) const {
    Head head{.mode = static_cast<double>(state.mode),
              .times = {state.start_time, state.stop_time, state.point},
              .length = state.session.size()};
    std::ranges::copy_n(token_.begin(), static_cast<std::ptrdiff_t>(head.token.size()), head.token.begin());
    std::string bytes(sizeof head + sizeof(double) * state.session.size(), '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, state.session.data(), bytes.size() - sizeof head);
    return bytes;
}

KeptState Instance::deserialised(std::string_view bytes) const {
    Head head;
    if (bytes.size() < sizeof head) {
        throw std::invalid_argument("these bytes are no state");
    }
    std::memcpy(&head, bytes.data(), sizeof head);
    // Older versions of FMPy hand over a zero more than they were given: what comes behind is not looked at.
    if (!std::ranges::equal(head.token, token_) || !(head.mode >= 0.0 && head.mode <= 3.0) ||
        head.length > (bytes.size() - sizeof head) / sizeof(double)) {
        throw std::invalid_argument("these bytes are no state of this FMU");
    }
    KeptState state{.mode = static_cast<Mode>(head.mode),
                    .start_time = head.times[0],
                    .stop_time = head.times[1],
                    .point = head.times[2],
                    .session = {}};
    state.session.resize(head.length);
    std::memcpy(state.session.data(), bytes.data() + sizeof head, sizeof(double) * head.length);
    return state;
}

}  // namespace tiretherm::fmu
