// SPDX-License-Identifier: BSD-3-Clause
// Applies all data checks to the columns of a recording; statistics of a column and its values in the unit of the file.

#include "input/measurements/data_warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "solver/order_statistics.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::input {

namespace {

/// What is looked for in each column, in this order. Where the unit is doubted, that an input is unusual follows.
struct ColumnCheck {
    std::string (*look)(const Recording& recording, const RecordedColumn& column);
    bool ends = false;  ///< the rules after it are skipped when it has found something
};
constexpr std::array rules{
    ColumnCheck{find_frozen, true}, ColumnCheck{find_dead, true},      ColumnCheck{find_resampled},
    ColumnCheck{find_clipped},      ColumnCheck{find_stuck},           ColumnCheck{find_dead_stretches},
    ColumnCheck{find_outliers},     ColumnCheck{find_unit_slip, true}, ColumnCheck{find_unusual}};

}  // namespace

std::string three_digits(double value) {
    return fmt::format("{}", std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr));
}

double RecordedColumn::largest() const {
    double found = 0.0;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const double before = i > 0 ? std::abs(value[i - 1]) : 0.0;
        const double after = i + 1 < value.size() ? std::abs(value[i + 1]) : 0.0;
        found = std::max(found, std::min(std::abs(value[i]), 2.0 * std::max(before, after)));
    }
    return found;
}

const RecordedColumn::Statistics& RecordedColumn::statistics() const {
    return known.statistics.get([&] {
        double smallest = 0.0;
        for (std::size_t i = 1; i < value.size(); ++i) {
            const double step = std::abs(value[i] - value[i - 1]);
            smallest = step > 0.0 && (smallest == 0.0 || step < smallest) ? step : smallest;
        }
        const auto [first, last] = std::ranges::minmax(value);
        const auto place = [&](double share) {
            return static_cast<std::size_t>(share * static_cast<double>(value.size() - 1) + 0.5);
        };
        const std::vector<double> hundredths = solver::smallest_at(value, {place(0.01), place(0.99)});
        return Statistics{
            .least = first, .most = last, .low = hundredths[0], .high = hundredths[1], .resolution = smallest};
    });
}

std::string RecordedColumn::show(double si_amount) const {
    const bool bare = unit.empty() || unit == "-" || unit == "1";
    const std::string number = three_digits(conversion.from_si(si_amount));
    return bare ? number : fmt::format("{} {}", number, unit);
}

std::string RecordedColumn::show_difference(double si_amount) const {
    if (is_temperature()) {
        return fmt::format("{} K", three_digits(si_amount));
    }
    return show(si_amount + conversion.offset);
}

const RecordedColumn* Recording::find(std::string_view name) const {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const RecordedColumn& column) { return column.name == name; });
    return found == columns.end() ? nullptr : &*found;
}

std::vector<std::string> find_suspicious(const Recording& recording) {
    std::vector<std::string> sentences;
    if (const std::string jumps = find_time_jumps(recording); !jumps.empty()) {
        sentences.push_back("time " + jumps);
    }
    for (const RecordedColumn& column : recording.columns) {
        const std::string aside = column.heading == column.name ? "" : fmt::format(" (column {})", column.heading);
        for (const ColumnCheck& rule : rules) {
            solver::leave_reading_if_stopped();
            const std::string sentence = column.value.empty() ? "" : rule.look(recording, column);
            if (!sentence.empty()) {
                sentences.push_back(fmt::format("{}{} {}", column.name, aside, sentence));
                if (rule.ends) {
                    break;
                }
            }
        }
    }
    for (const std::string& sentence : {find_stuck_together(recording), find_switched(recording)}) {
        if (!sentence.empty()) {
            sentences.push_back(sentence);
        }
    }
    std::ranges::move(find_copies(recording), std::back_inserter(sentences));
    return sentences;
}

void leave_out_unusable(const Recording& recording, MeasuredRun& run) {
    if (recording.keep_suspicious) {
        return;
    }
    for (const RecordedColumn& column : recording.columns) {
        solver::leave_reading_if_stopped();
        if (column.is_input || column.value.empty()) {
            continue;
        }
        MeasuredSeries& series = run.series[column.series];
        series.frozen = !find_frozen(recording, column).empty() || !find_dead(recording, column).empty();
        std::vector<bool> kept(column.value.size(), true);
        for (const Stretch& stretch : unusable_stretches(recording, column)) {
            std::fill_n(kept.begin() + static_cast<std::ptrdiff_t>(stretch.first), stretch.length, false);
        }
        for (const Outlier& outlier : outliers_of(recording, column)) {
            if (outlier.is_sure) {
                std::fill_n(kept.begin() + static_cast<std::ptrdiff_t>(outlier.where.first), outlier.where.length,
                            false);
            }
        }
        const Resampling& resampling = resampling_of(column);
        for (std::size_t i = 0; i < kept.size(); ++i) {
            kept[i] = kept[i] && i % resampling.ratio == resampling.first;
        }
        if (std::ranges::none_of(kept, std::identity{})) {
            continue;  // a column without a value is no finding but a mistake; the sentences say what is wrong
        }
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (!kept[i]) {
                const auto at = std::ranges::lower_bound(run.time, column.time[i]);
                series.value[static_cast<std::size_t>(at - run.time.begin())] =
                    std::numeric_limits<double>::quiet_NaN();
            }
        }
    }
}

}  // namespace tiretherm::input
