// SPDX-License-Identifier: BSD-3-Clause
// The files of a comparison: samples, statistics and pixels as tables.
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "post/comparison/comparison_report.hpp"
#include "post/comparison/corner_sections.hpp"
#include "post/laps/heat_by_lap.hpp"
#include "post/page/html_page.hpp"
#include "post/report/csv.hpp"
#include "post/report/file.hpp"
#include "post/report/phase_text.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// Row by row, for a log of an hour has millions.
void write_samples(const Comparison& comparison, AppendFile file) {
    constexpr std::size_t block = 1U << 20U;  // bytes
    Csv csv({"time [s]", "run", "channel", "unit", "measured", "simulated", "difference"});
    for (const ComparedChannel& channel : comparison.channels) {
        const solver::ShownUnit& unit = channel.unit;
        for (const ComparedSeries& series : channel.series) {
            for (std::size_t i = 0; i < series.time.size(); ++i) {
                csv.row(Digits{series.time[i], 10}, comparison.runs[series.run], channel.name, unit.name,
                        Digits{unit.value(series.measured[i]), 8}, Digits{unit.value(series.simulated[i]), 8},
                        Digits{unit.difference(series.simulated[i] - series.measured[i]), 6});
                if (csv.text().size() > block) {
                    file.append(csv.take());
                }
            }
        }
    }
    file.append(csv.text());
}

std::string statistics_csv(const Comparison& comparison) {
    Csv csv({"channel", "unit", "of", "name", "low", "high", "samples", "bias", "bias_deviation", "rmse", "scatter",
             "independent_samples"});
    for (const ComparedChannel& channel : comparison.channels) {
        const auto value = [&](double difference) { return Digits{channel.unit.difference(difference), 6}; };
        const auto add = [&](const char* of, std::string_view name, const Figures& f) {
            csv.row(channel.name, channel.unit.name, of, name, "", "", f.samples, value(f.bias),
                    value(f.bias_deviation), value(f.rmse), value(f.scatter), Digits{f.independent, 6});
        };
        add("all", "", channel.figures);
        for (const RunFigures& run : channel.runs) {
            add("run", comparison.runs[run.run], run.figures);
        }
        for (const PhaseFigures& phase : channel.phases) {
            add("phase", name_of(phase.phase), phase.figures);
        }
        for (const RegressorFigures& regressor : channel.regressors) {
            const std::string name = fmt::format("{} [{}]", regressor.name, regressor.unit);
            for (const Bin& bin : regressor.bins) {
                csv.row(channel.name, channel.unit.name, "signal", name, Digits{bin.low, 6}, Digits{bin.high, 6},
                        bin.samples, value(bin.mean), value(bin.deviation), "", "", "");
            }
        }
    }
    return csv.text();
}

std::string pixels_csv(const Comparison& comparison) {
    Csv csv({"run", "camera", "row", "column", "x [m]", "y [m]", "frames", "mean difference [K]", "rms [K]",
             "difference at the end [K]"});
    for (const ComparedImages& one : comparison.images) {
        for (std::size_t p = 0; p < one.pixels(); ++p) {
            double sum = 0.0;
            double squares = 0.0;
            for (std::size_t f = 0; f < one.time.size(); ++f) {
                sum += one.difference(f, p);
                squares += one.difference(f, p) * one.difference(f, p);
            }
            const auto n = static_cast<double>(one.time.size());
            csv.row(comparison.runs[one.run], one.camera, one.place[p][0], one.place[p][1], Digits{one.where[p][0], 6},
                    Digits{one.where[p][1], 6}, one.time.size(), Digits{sum / n, 5}, Digits{std::sqrt(squares / n), 5},
                    Digits{one.difference(one.time.size() - 1, p), 5});
        }
    }
    return csv.text();
}

}  // namespace

std::vector<std::string> comparison_names() {
    std::vector<std::string> names = page_names();
    names.insert(names.end(),
                 {"compare.csv", "compare_statistics.csv", laps_name, heat_name, inputs_name, "compare_pixels.csv"});
    return names;
}

std::vector<std::filesystem::path> write_comparison(const Comparison& comparison, const std::vector<DrivenRun>& driven,
                                                    const std::filesystem::path& directory) {
    create_folder(directory);
    std::vector<std::filesystem::path> files{directory / "compare.csv", directory / "compare_statistics.csv"};
    write_samples(comparison, AppendFile(files[0]));
    replace_file(files[1], statistics_csv(comparison));
    const auto add = [&](const char* name, const std::string& text) {
        replace_file(files.emplace_back(directory / name), text);
    };
    if (const std::vector<LapRow> rows = lap_rows(comparison.channels, comparison.runs); have_laps_or_corners(rows)) {
        add(laps_name, laps_csv(rows));
    }
    if (have_laps_or_corners(comparison.heat)) {
        add(heat_name, heat_csv(comparison.heat));
    }
    if (const std::string inputs = computed_inputs_csv(driven); !inputs.empty()) {
        add(inputs_name, inputs);
    }
    if (!comparison.images.empty()) {
        files.push_back(directory / "compare_pixels.csv");
        replace_file(files.back(), pixels_csv(comparison));
    }
    return files;
}

}  // namespace tiretherm::post
