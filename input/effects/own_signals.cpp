#include "input/effects/own_signals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

using solver::Course;
using solver::Limit;

/// Straight lines deviate from a formula by less than this share of its largest value.
constexpr double close = 1e-4;
constexpr int most_halvings = 12;

/// Straight between its points and held beyond them.
double value_at(const Course& course, double t) {
    const auto next = std::ranges::lower_bound(course.time, t);
    const auto i = static_cast<std::size_t>(next - course.time.begin());
    if (i == 0 || i == course.time.size()) {
        return i == 0 ? course.value.front() : course.value.back();
    }
    const double width = course.time[i] - course.time[i - 1];
    return course.time[i] == t
               ? course.value[i]
               : course.value[i - 1] + (course.value[i] - course.value[i - 1]) * (t - course.time[i - 1]) / width;
}

/// A formula over the signals of a run.
class Follower {
public:
    Follower(const Formula& formula, const solver::Drive& drive, const std::vector<OwnColumn>& columns)
        : formula_(&formula), drive_(&drive), values_(formula.signals().size()) {
        for (const std::string& name : formula.signals()) {
            const auto column = std::ranges::find(columns, name, &OwnColumn::name);
            signals_.push_back(physics::find_signal(name));
            columns_.push_back(signals_.back() == nullptr && column != columns.end() ? &*column : nullptr);
        }
    }

    double operator()(double t, Limit limit) {
        const physics::Inputs inputs = drive_->at(t, limit);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_[i] = columns_[i] != nullptr   ? value_at(columns_[i]->course, t)
                         : signals_[i] != nullptr ? inputs.*(signals_[i]->member)
                                                  : inputs.time;
        }
        return (*formula_)(values_);
    }

    /// Points of the signals within the run, its ends among them. @param logged out, whether any of them is a log
    std::vector<double> points(const solver::Settings& settings, bool& logged) const {
        std::vector<double> times{settings.start, settings.end};
        const auto add = [&](const std::vector<double>& more) {
            std::ranges::copy_if(more, std::back_inserter(times),
                                 [&](double t) { return t > settings.start && t < settings.end; });
        };
        logged = false;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (columns_[i] != nullptr) {
                add(columns_[i]->course.time);
                logged = true;
            }
            for (const solver::Series& series : drive_->series()) {
                if (series.signal == signals_[i]) {
                    add(series.time);
                    logged = logged || series.logged;
                }
            }
        }
        std::ranges::sort(times);
        times.erase(std::unique(times.begin(), times.end()), times.end());
        return times;
    }

private:
    const Formula* formula_;
    const solver::Drive* drive_;
    std::vector<const physics::Signal*> signals_;  ///< [signals] null for a column and for the time
    std::vector<const OwnColumn*> columns_;        ///< [signals] null for an input and for the time
    std::vector<double> values_;
};

/// Points between two others where the formula bends.
void refine(Follower& follower, double t0, double v0, double t1, double v1, double tolerance, int halvings,
            Course& into) {
    const double width = t1 - t0;
    double worst = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {
        worst = std::max(worst, std::abs(follower(t0 + share * width, Limit::before) - v0 - share * (v1 - v0)));
    }
    if (worst > tolerance && halvings < most_halvings) {
        const double middle = 0.5 * (t0 + t1);
        const double v = follower(middle, Limit::before);
        refine(follower, t0, v0, middle, v, tolerance, halvings + 1, into);
        into.time.push_back(middle);
        into.value.push_back(v);
        refine(follower, middle, v, t1, v1, tolerance, halvings + 1, into);
    }
}

Course refined(Follower& follower, const Course& coarse) {
    double largest = 0.0;
    for (std::size_t i = 0; i < coarse.time.size(); ++i) {
        largest = std::max(largest, std::abs(coarse.value[i]));
        const double middle = i > 0 ? 0.5 * (coarse.time[i - 1] + coarse.time[i]) : coarse.time[i];
        largest = std::max(largest, std::abs(follower(middle, Limit::before)));
    }
    Course fine;
    for (std::size_t i = 0; i < coarse.time.size(); ++i) {
        if (i > 0 && coarse.time[i] > coarse.time[i - 1]) {
            refine(follower, coarse.time[i - 1], coarse.value[i - 1], coarse.time[i], coarse.value[i], close * largest,
                   0, fine);
        }
        fine.time.push_back(coarse.time[i]);
        fine.value.push_back(coarse.value[i]);
    }
    return fine;
}

OwnColumn column_of(const MeasuredRun& run, const std::string& name, std::string unit, const Conversion& si,
                    const std::vector<double>& value) {
    OwnColumn column{.name = name, .unit = std::move(unit), .course = {}};
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        if (!std::isnan(value[i])) {
            column.course.time.push_back(run.time[i]);
            column.course.value.push_back(si.to_si(value[i]));
        }
    }
    return column;
}

/// What a measured run has beside its inputs.
std::vector<OwnColumn> columns_of(const MeasuredRun& run) {
    std::vector<OwnColumn> columns;
    for (const UnusedSignal& signal : run.unused) {
        const std::string unit = base_unit(signal.unit);
        const auto read = conversion(signal.unit, unit, Scale::absolute);
        const Conversion* known = std::get_if<Conversion>(&read);
        columns.push_back(column_of(run, signal.name, unit, known != nullptr ? *known : Conversion{}, signal.value));
    }
    for (const MeasuredSeries& series : run.series) {
        const solver::Channel& channel = run.problem.channels[series.channel];
        columns.push_back(
            column_of(run, channel.name, std::string(solver::unit_of(channel.quantity)), {}, series.value));
    }
    std::erase_if(columns, [](const OwnColumn& column) { return column.course.time.empty(); });
    return columns;
}

}  // namespace

std::string base_unit(const std::optional<std::string>& unit) {
    const std::string base = unit && !unit->empty() ? signature(*unit) : "1";
    return base.empty() ? "1" : base;
}

Course course_of(const Formula& formula, const solver::Drive& drive, const std::vector<OwnColumn>& columns,
                 const solver::Settings& settings) {
    Follower follower(formula, drive, columns);
    bool logged = false;
    Course course;
    for (const double t : follower.points(settings, logged)) {
        const double before = follower(t, Limit::before);
        const double after = follower(t, Limit::after);
        if (t > settings.start) {
            course.time.push_back(t);
            course.value.push_back(before);
        }
        if (t == settings.start || (after != before && t < settings.end)) {
            course.time.push_back(t);
            course.value.push_back(after);
        }
    }
    return logged ? course : refined(follower, course);
}

Course course_of(std::string_view follows, const MeasuredRun& run) {
    Formula::Wrong wrong;
    const std::string text(follows);
    const std::vector<OwnColumn> columns = columns_of(run);
    const bool is_column =
        physics::find_signal(text) == nullptr && std::ranges::count(columns, text, &OwnColumn::name) > 0;
    const std::optional<Formula> formula = is_column ? Formula::of_signal(text) : Formula::read(text, "follows", wrong);
    if (!formula) {
        throw std::invalid_argument(wrong.error.what);
    }
    for (const std::string& name : formula->signals()) {
        const physics::Signal* signal = physics::find_signal(name);
        const bool known = signal != nullptr
                               ? run.problem.drive.gives(*signal)
                               : name == "time" || std::ranges::count(columns, name, &OwnColumn::name) > 0;
        if (!known) {
            throw std::invalid_argument(fmt::format("the run {} has no signal {}", run.name, name));
        }
    }
    return course_of(*formula, run.problem.drive, columns, run.problem.settings);
}

}  // namespace tiretherm::input
