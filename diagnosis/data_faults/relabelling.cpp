// SPDX-License-Identifier: BSD-3-Clause
// Lists what columns may be by their quantities and by the other units that their sizes allow.

#include "diagnosis/data_faults/relabelling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

namespace tiretherm::diagnosis {

namespace {

using input::ColumnChange;
using input::MeasuredRun;
using input::ReadColumn;

std::string recording_of(const MeasuredRun& run) { return run.corner.empty() ? run.name : run.recording; }

const ReadColumn* find_column(const MeasuredRun& run, const LabelledColumn& column) {
    const auto found = std::ranges::find_if(
        run.columns, [&](const ReadColumn& one) { return one.name == column.name && one.is_input == column.is_input; });
    return found == run.columns.end() ? nullptr : &*found;
}

const ReadColumn::OtherUnit* find_unit(const ReadColumn& column, const std::string& unit) {
    const auto found = std::ranges::find(column.others, unit, &ReadColumn::OtherUnit::name);
    return found == column.others.end() ? nullptr : &*found;
}

/// Inputs that are others on the other side of a car.
constexpr std::array<std::string_view, 4> of_a_side{"vertical_load", "lateral_force", "slip_angle", "camber"};

/// A column's quantity, and the units in which it may be in some run.
struct KnownColumn {
    LabelledColumn label;
    std::string quantity;
    std::set<std::string> units{};
};

std::vector<KnownColumn> columns_of(const input::Experiment& experiment) {
    std::vector<KnownColumn> all;
    for (const MeasuredRun& run : experiment.runs) {
        for (const ReadColumn& column : run.columns) {
            const LabelledColumn label{.name = column.name, .is_input = column.is_input};
            auto known = std::ranges::find(all, label, &KnownColumn::label);
            if (known == all.end()) {
                known = all.insert(all.end(), {.label = label, .quantity = column.quantity});
            }
            for (const ReadColumn::OtherUnit& unit : column.others) {
                known->units.insert(unit.name);
            }
        }
    }
    return all;
}

/// Several temperatures that one logger writes in another unit: all sensors, and with them what the air and the road are.
void add_together(const std::vector<KnownColumn>& columns, bool with_inputs, std::vector<Relabelling>& into) {
    std::map<std::string, std::vector<LabelledColumn>> by_unit;
    bool has_input = false;
    for (const KnownColumn& column : columns) {
        for (const std::string& unit : column.units) {
            if (column.quantity == "K" && (with_inputs || !column.label.is_input)) {
                by_unit[unit].push_back(column.label);
                has_input = has_input || column.label.is_input;
            }
        }
    }
    for (auto& [unit, labels] : by_unit) {
        if (labels.size() > 1 && has_input == with_inputs) {
            into.push_back({.kind = Relabelling::Kind::unit, .columns = std::move(labels), .unit = unit});
        }
    }
}

bool is_of_sensor(const NoiseBlock& block, const Observations& observations) {
    return block.channel >= 0 && block.rows() > 0 && observations.rows[static_cast<std::size_t>(block.first)].image < 0;
}

/// Rows by run, channel and time.
using RowsByTime = std::map<std::tuple<std::size_t, std::size_t, std::size_t>, Eigen::Index>;

RowsByTime rows_by_time(const Observations& observations) {
    RowsByTime found;
    for (const Eigen::Index i : sensor_rows(observations)) {
        const Observations::Row& row = observations.rows[static_cast<std::size_t>(i)];
        found.emplace(std::tuple(row.run, row.channel, row.time), i);
    }
    return found;
}

}  // namespace

std::vector<FaultScope> fault_scopes(const input::Experiment& experiment) {
    std::vector<FaultScope> scopes(1);
    std::vector<std::string> names;
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        scopes.front().runs.push_back(r);
        const std::string name = recording_of(experiment.runs[r]);
        if (std::ranges::find(names, name) == names.end()) {
            names.push_back(name);
        }
    }
    for (const bool alone : {true, false}) {
        for (const std::string& name : names.size() > (alone ? 1U : 2U) ? names : std::vector<std::string>{}) {
            FaultScope scope;
            for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
                const std::string own = recording_of(experiment.runs[r]);
                if ((own == name) == alone) {
                    scope.runs.push_back(r);
                    if (std::ranges::find(scope.recordings, own) == scope.recordings.end()) {
                        scope.recordings.push_back(own);
                    }
                }
            }
            scopes.push_back(std::move(scope));
        }
    }
    return scopes;
}

bool Relabelling::touches_inputs() const { return std::ranges::any_of(columns, &LabelledColumn::is_input); }

std::vector<Relabelling> relabellings(const input::Experiment& experiment) {
    const std::vector<KnownColumn> columns = columns_of(experiment);
    const bool is_car = !experiment.runs.front().corner.empty();  // its sides are compared when it is read
    std::vector<Relabelling> all;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        for (const std::string& unit : columns[i].units) {
            all.push_back({.kind = Relabelling::Kind::unit, .columns = {columns[i].label}, .unit = unit});
        }
        for (std::size_t j = i + 1; j < columns.size() && !is_car; ++j) {
            if (columns[i].quantity == columns[j].quantity && columns[i].label.is_input == columns[j].label.is_input) {
                all.push_back({.kind = Relabelling::Kind::exchange, .columns = {columns[i].label, columns[j].label}});
            }
        }
    }
    add_together(columns, false, all);
    add_together(columns, true, all);
    Relabelling mirrored{.kind = Relabelling::Kind::mirror, .columns = {}};
    for (const KnownColumn& column : columns) {
        if (column.label.is_input && std::ranges::find(of_a_side, column.label.name) != of_a_side.end()) {
            mirrored.columns.push_back(column.label);
        }
    }
    if (!is_car && !mirrored.columns.empty()) {
        all.push_back(std::move(mirrored));
    }
    return all;
}

std::vector<const ReadColumn*> columns_in(const Relabelling& what, const MeasuredRun& run) {
    std::vector<const ReadColumn*> found;
    for (const LabelledColumn& label : what.columns) {
        const ReadColumn* column = find_column(run, label);
        if (column == nullptr || (what.kind == Relabelling::Kind::unit && find_unit(*column, what.unit) == nullptr)) {
            return {};
        }
        found.push_back(column);
    }
    return found;
}

bool is_possible(const Relabelling& what, const FaultScope& scope, const input::Experiment& experiment) {
    return std::ranges::all_of(scope.runs, [&](std::size_t r) {
        const std::vector<const ReadColumn*> columns = columns_in(what, experiment.runs[r]);
        // A run on another compound makes as much more heat as one whose speed or load is in another unit.
        const auto is_of_all = [&](const ReadColumn* one) { return one->is_input && one->quantity != "K"; };
        return !columns.empty() && (scope.recordings.empty() || std::ranges::none_of(columns, is_of_all));
    });
}

std::vector<ColumnChange> changes_of(const Relabelling& what, const FaultScope& scope,
                                     const input::Experiment& experiment) {
    std::vector<ColumnChange> changes;
    if (what.kind == Relabelling::Kind::mirror || !is_possible(what, scope, experiment)) {
        return changes;
    }
    for (const std::size_t r : scope.runs) {
        const MeasuredRun& run = experiment.runs[r];
        const std::vector<const ReadColumn*> columns = columns_in(what, run);
        const std::string recording = scope.recordings.empty() ? "" : recording_of(run);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            ColumnChange change{.heading = columns[i]->heading, .run = recording};
            if (what.kind == Relabelling::Kind::unit) {
                change.unit = what.unit;
            } else {
                change.name = what.columns[1 - i].name;
            }
            if (std::ranges::find(changes, change) == changes.end()) {
                changes.push_back(std::move(change));
            }
        }
    }
    return changes;
}

Eigen::VectorXd relabelled(const Relabelling& what, const input::Experiment& experiment,
                           const Observations& observations) {
    const RowsByTime by_time = rows_by_time(observations);
    Eigen::VectorXd read = observations.measured;
    for (const NoiseBlock& block : observations.blocks) {
        if (!is_of_sensor(block, observations)) {
            continue;
        }
        const Observations::Row& first = observations.rows[static_cast<std::size_t>(block.first)];
        const std::vector<solver::Channel>& channels = experiment.runs[first.run].problem.channels;
        const std::vector<const ReadColumn*> columns = columns_in(what, experiment.runs[first.run]);
        const auto own = std::ranges::find_if(columns, [&](const ReadColumn* column) {
            return !column->is_input && column->name == channels[first.channel].name;
        });
        if (own == columns.end()) {
            continue;
        }
        if (what.kind == Relabelling::Kind::unit) {
            const input::Conversion& as = find_unit(**own, what.unit)->from_read;
            read.segment(block.first, block.rows()) =
                (as.factor * observations.measured.segment(block.first, block.rows())).array() + as.offset;
            continue;
        }
        const std::string& other = own == columns.begin() ? columns.back()->name : columns.front()->name;
        const auto channel = std::ranges::find(channels, other, &solver::Channel::name) - channels.begin();
        for (Eigen::Index i = block.first; i < block.first + block.rows(); ++i) {
            const std::size_t time = observations.rows[static_cast<std::size_t>(i)].time;
            const auto there = by_time.find({first.run, static_cast<std::size_t>(channel), time});
            read[i] = there == by_time.end() ? std::nan("") : observations.measured[there->second];
        }
    }
    return read;
}

std::vector<Eigen::Index> sensor_rows(const Observations& observations) {
    std::vector<Eigen::Index> rows;
    for (const NoiseBlock& block : observations.blocks) {
        for (Eigen::Index i = 0; is_of_sensor(block, observations) && i < block.rows(); ++i) {
            rows.push_back(block.first + i);
        }
    }
    return rows;
}

void mirror_inputs(input::Experiment& experiment, const std::vector<std::size_t>& runs) {
    const physics::Signal& load_signal = *physics::find_signal("vertical_load");
    const physics::Signal& force_signal = *physics::find_signal("lateral_force");
    for (const std::size_t r : runs) {
        solver::InputSignals& inputs = experiment.runs[r].problem.input_signals;
        const auto series_of = [&](const physics::Signal& signal) {
            const auto found = std::ranges::find(inputs.series(), &signal, &solver::Series::signal);
            return found == inputs.series().end() ? std::nullopt : std::optional(*found);
        };
        const std::optional<solver::Series> load = series_of(load_signal);
        std::optional<solver::Series> force = series_of(force_signal);
        if (load && !load->value.empty()) {
            const double sum = std::accumulate(load->value.begin(), load->value.end(), 0.0);
            const double both = 2.0 * sum / static_cast<double>(load->value.size());
            std::vector<double> other(load->value.begin(), load->value.end());
            std::ranges::transform(other, other.begin(), [&](double one) { return std::max(0.0, both - one); });
            solver::Series mirrored = *load;
            mirrored.value = solver::SharedSamples(std::move(other));
            std::vector<double> forces;
            for (std::size_t i = 0; force && i < force->value.size(); ++i) {
                const double t = force->time[i];
                const double one = load->at(t, solver::JumpSide::after);
                const double there = mirrored.at(t, solver::JumpSide::after);
                forces.push_back(force->value[i] * (one > 0.0 ? there / one : 1.0));
            }
            inputs.replace(std::move(mirrored));
            if (force) {
                force->value = solver::SharedSamples(std::move(forces));
                inputs.replace(std::move(*force));
            }
        }
        for (const std::string_view name : {"lateral_force", "slip_angle", "camber"}) {
            if (inputs.gives(*physics::find_signal(name))) {
                inputs.move(*physics::find_signal(name), -1.0, 0.0);
            }
        }
    }
}

}  // namespace tiretherm::diagnosis
