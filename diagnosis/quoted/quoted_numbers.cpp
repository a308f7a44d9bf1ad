// SPDX-License-Identifier: BSD-3-Clause
// Collects the rows of one model, groups those that are read from the same tests, and spreads unknown inputs over their
// ranges: numbers evenly, words each alike.

#include "diagnosis/quoted/quoted_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "input/runs/runs.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr std::size_t n_points = 21;  ///< of a range

/// The median stated uncertainty of each unit; a temperature and a difference of two share theirs.
std::map<std::string, double> usual_uncertainties(const std::vector<ValidationRow>& table) {
    std::map<std::string, std::vector<double>> stated;
    for (const ValidationRow& row : table) {
        if (row.uncertainty > 0.0) {
            stated[row.unit == "degC" ? "K" : row.unit].push_back(row.uncertainty);
        }
    }
    std::map<std::string, double> usual;
    for (auto& [unit, all] : stated) {
        std::ranges::sort(all);
        usual[unit] = 0.5 * (all[(all.size() - 1) / 2] + all[all.size() / 2]);
    }
    return usual;
}

/// Where a number was inferred from, the middle of the range stands for the value, so that it does not judge itself.
void centre(UnknownInput& input, const std::vector<std::size_t>& rows) {
    for (const std::size_t row : rows) {
        double mean = 0.0;
        for (const std::vector<double>& point : input.changes) {
            mean += point[row] / static_cast<double>(input.changes.size());
        }
        for (std::vector<double>& point : input.changes) {
            point[row] -= mean;
        }
    }
}

/// An input with its points, before any row says what it changes.
UnknownInput unknown_input(const input::ValidationInput& shown, const InputEffect& effect, std::size_t n_rows) {
    UnknownInput input{.name = shown.name, .unit = shown.unit, .value = shown.number, .at = {}, .changes = {}};
    input.is_number = effect.numbers.size() == 2;
    const std::size_t points = input.is_number ? n_points : effect.ends.size() + 1;
    for (std::size_t i = 0; i < points; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(points - 1, 1));
        input.at.push_back(input.is_number ? effect.numbers[0] + share * (effect.numbers[1] - effect.numbers[0])
                                           : static_cast<double>(i));
    }
    input.changes.assign(points, std::vector<double>(n_rows, 0.0));
    return input;
}

/// What an input changes of one row's value.
void add_changes(UnknownInput& input, const InputEffect& effect, std::size_t model, std::size_t row, double value) {
    const std::vector<std::optional<double>>& ends = effect.at_ends[model];
    for (std::size_t i = 0; i < input.at.size(); ++i) {
        if (input.is_number) {
            const std::vector<double> at{effect.numbers[0], input.value, effect.numbers[1]};
            input.changes[i][row] = physics::Curve::table(at, {*ends[0], value, *ends[1]}).value(input.at[i]) - value;
        } else if (i > 0) {
            input.changes[i][row] = *ends[i - 1] - value;
        }
    }
}

/// Which experiment each row belongs to: rows of one id, and rows that read one run, are of the same.
std::vector<std::size_t> experiments_of(const std::vector<QuotedResult>& rows,
                                        const std::vector<std::vector<std::size_t>>& runs) {
    std::vector<std::size_t> group(runs.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t a = 0; a < runs.size(); ++a) {
            for (std::size_t b = a + 1; b < runs.size(); ++b) {
                const bool shared = rows[a].id == rows[b].id || std::ranges::any_of(runs[a], [&](std::size_t run) {
                                        return std::ranges::find(runs[b], run) != runs[b].end();
                                    });
                if (shared && group[a] != group[b]) {
                    group[a] = group[b] = std::min(group[a], group[b]);
                    changed = true;
                }
            }
        }
    }
    return group;
}

/// "M4", or "M4, M5" of rows that share a run.
void name_experiments(Numbers& numbers, const std::vector<std::size_t>& groups) {
    std::map<std::size_t, std::size_t> index;
    std::vector<std::vector<std::string>> ids;
    for (std::size_t r = 0; r < numbers.rows.size(); ++r) {
        QuotedResult& row = numbers.rows[r];
        row.experiment = index.try_emplace(groups[r], index.size()).first->second;
        ids.resize(index.size());
        ids[row.experiment].push_back(row.id);
    }
    for (const std::vector<std::string>& of_one : ids) {
        numbers.experiments.push_back(fmt::format("{}", fmt::join(input::unique(of_one), ", ")));
    }
}

}  // namespace

double QuotedResult::total() const { return std::hypot(uncertainty, spread); }

double QuotedResult::residual(double simulated) const { return simulated - std::clamp(simulated, low, high); }

double UnknownInput::covariance(std::size_t row, std::size_t other) const {
    double sum = 0.0;
    for (const std::vector<double>& point : changes) {
        sum += point[row] * point[other];
    }
    return sum / static_cast<double>(changes.size());
}

Eigen::MatrixXd Numbers::covariance(const std::vector<std::size_t>& of, const std::vector<int>& free) const {
    const auto n = static_cast<Eigen::Index>(of.size());
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index a = 0; a < n; ++a) {
        for (Eigen::Index b = 0; b <= a; ++b) {
            const std::size_t row = of[static_cast<std::size_t>(a)];
            const std::size_t other = of[static_cast<std::size_t>(b)];
            double value = a == b ? rows[row].uncertainty * rows[row].uncertainty : 0.0;
            for (std::size_t k = 0; k < inputs.size(); ++k) {
                value +=
                    std::ranges::find(free, static_cast<int>(k)) == free.end() ? inputs[k].covariance(row, other) : 0.0;
            }
            all(a, b) = all(b, a) = value;
        }
    }
    return all;
}

Numbers quoted_numbers(const input::Validation& validation, const std::vector<ValidationRow>& table,
                       std::size_t model) {
    Numbers numbers;
    const std::map<std::string, double> usual = usual_uncertainties(table);
    std::vector<std::vector<std::size_t>> runs;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const ValidationRow& shown = table[i];
        const Judgement judgement = judge(shown, model);
        if (judgement == Judgement::none || judgement == Judgement::no_result) {
            continue;
        }
        if (validation.numbers[i].about_the_model) {
            ++numbers.about_the_model;
            continue;
        }
        const auto scale = usual.find(shown.unit == "degC" ? "K" : shown.unit);
        if (shown.uncertainty <= 0.0 && scale == usual.end()) {
            ++numbers.without_scale;
            continue;
        }
        numbers.rows.push_back({.number = i,
                                .id = shown.id,
                                .what = shown.what,
                                .unit = shown.unit,
                                .low = shown.low,
                                .high = shown.high,
                                .uncertainty = shown.uncertainty > 0.0 ? shown.uncertainty : scale->second,
                                .value = *shown.models[model].value,
                                .is_open = shown.is_open(),
                                .decidable = judgement != Judgement::not_decidable});
        runs.push_back(validation.numbers[i].models[model]->runs());
    }
    name_experiments(numbers, experiments_of(numbers.rows, runs));

    const std::size_t n = numbers.rows.size();
    for (const input::ValidationInput& known : validation.inputs) {
        std::optional<UnknownInput> input;
        std::vector<std::size_t> rows;
        for (std::size_t r = 0; r < n; ++r) {
            const ValidationRow& shown = table[numbers.rows[r].number];
            const auto effect = std::ranges::find(shown.inputs, known.name, &InputEffect::name);
            if (effect == shown.inputs.end() || effect->ends.empty() || effect->at_ends[model].empty()) {
                continue;
            }
            if (!input) {
                input = unknown_input(known, *effect, n);
            }
            add_changes(*input, *effect, model, r, *shown.models[model].value);
            rows.push_back(r);
        }
        if (!input) {
            continue;
        }
        if (known.standing == input::Standing::inferred) {
            for (const std::size_t row : rows) {
                const double before = input->changes.front()[row];
                centre(*input, {row});
                numbers.rows[row].value += before - input->changes.front()[row];
            }
            input->value = input->is_number ? 0.5 * (input->at.front() + input->at.back()) : input->value;
        }
        numbers.inputs.push_back(std::move(*input));
    }
    for (std::size_t r = 0; r < n; ++r) {
        double variance = 0.0;
        for (const UnknownInput& input : numbers.inputs) {
            variance += input.covariance(r, r);
        }
        numbers.rows[r].spread = std::sqrt(std::max(variance, 0.0));
    }
    return numbers;
}

}  // namespace tiretherm::diagnosis::quoted
