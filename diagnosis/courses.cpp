#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "diagnosis/dictionary.hpp"

namespace tiretherm::diagnosis {

namespace {

using physics::Inputs;

/// A formula of the inputs.
struct Formula {
    std::string_view text;
    std::string_view unit;
    std::array<std::string_view, 2> signals;  ///< that it needs; the second may be empty
    double (*value)(const Inputs&);
};

constexpr std::array formulas{
    Formula{"speed", "m s-1", {"speed"}, [](const Inputs& u) { return u.speed; }},
    Formula{"speed^2", "m2 s-2", {"speed"}, [](const Inputs& u) { return u.speed * u.speed; }},
    Formula{"vertical_load", "N", {"vertical_load"}, [](const Inputs& u) { return u.vertical_load; }},
    Formula{"speed * vertical_load",
            "W",
            {"speed", "vertical_load"},
            [](const Inputs& u) { return u.speed * u.vertical_load; }},
    Formula{"lateral_force", "N", {"lateral_force"}, [](const Inputs& u) { return u.lateral_force; }},
    Formula{"abs(lateral_force)", "N", {"lateral_force"}, [](const Inputs& u) { return std::abs(u.lateral_force); }},
    Formula{"speed * abs(lateral_force)",
            "W",
            {"speed", "lateral_force"},
            [](const Inputs& u) { return u.speed * std::abs(u.lateral_force); }},
    Formula{"speed * abs(slip_angle)",
            "m s-1",
            {"speed", "slip_angle"},
            [](const Inputs& u) { return u.speed * std::abs(u.slip_angle); }},
    Formula{"longitudinal_force", "N", {"longitudinal_force"}, [](const Inputs& u) { return u.longitudinal_force; }},
    Formula{"abs(longitudinal_force)",
            "N",
            {"longitudinal_force"},
            [](const Inputs& u) { return std::abs(u.longitudinal_force); }},
    Formula{"camber", "rad", {"camber"}, [](const Inputs& u) { return u.camber; }},
    Formula{"inflation_pressure", "Pa", {"inflation_pressure"}, [](const Inputs& u) { return u.inflation_pressure; }},
    Formula{"air_temperature", "K", {"air_temperature"}, [](const Inputs& u) { return u.air_temperature; }},
    Formula{"road_temperature", "K", {"road_temperature"}, [](const Inputs& u) { return u.road_temperature; }},
    Formula{"wet", "1", {"wet"}, [](const Inputs& u) { return u.wet; }},
    Formula{"laser_power", "W", {"laser_power"}, [](const Inputs& u) { return u.laser_power; }},
};

bool is_given(const cases::Experiment& experiment, std::string_view signal) {
    return signal.empty() || std::ranges::all_of(experiment.runs, [&](const cases::MeasuredRun& run) {
               return run.problem.drive.gives(*physics::find_signal(signal));
           });
}

/// Times at which a run's inputs may bend.
std::vector<double> bends(const cases::MeasuredRun& run) {
    const solver::Settings& settings = run.problem.settings;
    std::vector<double> times = run.time;
    times.insert(times.end(), {settings.start, settings.end});
    const std::vector<double>& samples = run.problem.drive.samples();
    times.insert(times.end(), samples.begin(), samples.end());
    for (const double stop : run.problem.drive.stops()) {
        times.insert(times.end(), {std::nextafter(stop, settings.start), stop});
    }
    std::erase_if(times, [&](double t) { return t < settings.start || t > settings.end; });
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// A value that was not logged is taken from the straight line between its neighbours.
void fill_gaps(const std::vector<double>& time, std::vector<double>& value) {
    std::size_t last = value.size();
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (std::isnan(value[i])) {
            continue;
        }
        if (last == value.size()) {
            std::fill(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(i), value[i]);
        } else {
            for (std::size_t j = last + 1; j < i; ++j) {
                value[j] = value[last] + (value[i] - value[last]) * (time[j] - time[last]) / (time[i] - time[last]);
            }
        }
        last = i;
    }
    for (std::size_t i = last + 1; i < value.size(); ++i) {
        value[i] = value[last];
    }
}

/// Whether it changes anywhere; keeps its largest value.
bool varies(Course& course) {
    double low = course.value.front().front();
    double high = low;
    for (const std::vector<double>& values : course.value) {
        const auto [least, most] = std::ranges::minmax(values);
        low = std::min(low, least);
        high = std::max(high, most);
    }
    course.largest = std::max(std::abs(low), std::abs(high));
    return std::isfinite(low) && std::isfinite(high) && high - low > 1e-6 * course.largest;
}

/// A column that every run has and the model does not use; empty when a run lacks it.
std::optional<Course> unused(const cases::Experiment& experiment, const cases::UnusedSignal& signal) {
    Course course{.follows = signal.name, .unit = signal.unit, .time = {}, .value = {}};
    for (const cases::MeasuredRun& run : experiment.runs) {
        const auto found = std::ranges::find(run.unused, signal.name, &cases::UnusedSignal::name);
        if (found == run.unused.end() ||
            std::ranges::all_of(found->value, [](double value) { return std::isnan(value); })) {
            return std::nullopt;
        }
        course.time.push_back(run.time);
        course.value.push_back(found->value);
        fill_gaps(run.time, course.value.back());
    }
    return course;
}

}  // namespace

std::vector<Course> courses_of(const cases::Experiment& experiment) {
    std::vector<Course> courses;
    const auto add = [&](std::string_view text, std::string_view unit, double (*value)(const Inputs&)) {
        Course course{.follows = std::string(text), .unit = std::string(unit), .time = {}, .value = {}};
        for (const cases::MeasuredRun& run : experiment.runs) {
            course.time.push_back(bends(run));
            std::vector<double>& values = course.value.emplace_back();
            for (const double t : course.time.back()) {
                values.push_back(value(run.problem.drive.at(t, solver::Limit::after)));
            }
        }
        if (varies(course) || text == "1") {
            courses.push_back(std::move(course));
        }
    };
    add("1", "1", [](const Inputs& /*u*/) { return 1.0; });
    add("time", "s", [](const Inputs& u) { return u.time; });
    for (const Formula& formula : formulas) {
        if (is_given(experiment, formula.signals[0]) && is_given(experiment, formula.signals[1])) {
            add(formula.text, formula.unit, formula.value);
        }
    }
    for (const cases::UnusedSignal& signal : experiment.runs.front().unused) {
        if (std::optional<Course> course = unused(experiment, signal); course && varies(*course)) {
            courses.push_back(std::move(*course));
        }
    }
    return courses;
}

}  // namespace tiretherm::diagnosis
