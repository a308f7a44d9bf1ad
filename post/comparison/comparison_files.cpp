#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "post/pictures/camera_picture.hpp"
#include "post/comparison/comparison_report.hpp"
#include "post/report/file.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

/// A name as a cell: in quotes where a comma or a quote in it would end the cell.
std::string cell(const std::string& name) {
    if (name.find_first_of(",\"\n") == std::string::npos) {
        return name;
    }
    std::string quoted = "\"";
    for (const char letter : name) {
        quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    return quoted + "\"";
}

std::string samples_csv(const Comparison& comparison) {
    std::string text = "time [s],run,channel,unit,measured,simulated,difference\n";
    for (const ComparedChannel& channel : comparison.channels) {
        for (const ComparedSeries& series : channel.series) {
            const std::string names =
                fmt::format("{},{},{}", cell(comparison.runs[series.run]), cell(channel.name), channel.unit.name);
            for (std::size_t i = 0; i < series.time.size(); ++i) {
                fmt::format_to(std::back_inserter(text), "{:.10g},{},{:.8g},{:.8g},{:.6g}\n", series.time[i], names,
                               channel.unit.value(series.measured[i]), channel.unit.value(series.simulated[i]),
                               channel.unit.difference(series.simulated[i] - series.measured[i]));
            }
        }
    }
    return text;
}

std::string statistics_csv(const Comparison& comparison) {
    std::string text = "channel,unit,of,name,low,high,samples,bias,bias_deviation,rmse,scatter,independent_samples\n";
    for (const ComparedChannel& channel : comparison.channels) {
        const auto value = [&](double difference) {
            const double shown = channel.unit.difference(difference);
            return std::isfinite(shown) ? fmt::format("{:.6g}", shown) : std::string();
        };
        const auto add = [&](const char* of, std::string_view name, const Figures& f) {
            text += fmt::format("{},{},{},{},,,{},{},{},{},{},{:.6g}\n", cell(channel.name), channel.unit.name, of,
                                cell(std::string(name)), f.samples, value(f.bias), value(f.bias_deviation),
                                value(f.rmse), value(f.scatter), f.independent);
        };
        add("all", "", channel.figures);
        for (const RunFigures& run : channel.runs) {
            add("run", comparison.runs[run.run], run.figures);
        }
        for (const PhaseFigures& phase : channel.phases) {
            add("phase", name_of(phase.phase), phase.figures);
        }
        for (const RegressorFigures& regressor : channel.regressors) {
            for (const Bin& bin : regressor.bins) {
                text += fmt::format("{},{},signal,{},{:.6g},{:.6g},{},{},{},,,\n", cell(channel.name),
                                    channel.unit.name, cell(fmt::format("{} [{}]", regressor.name, regressor.unit)),
                                    bin.low, bin.high, bin.samples, value(bin.mean), value(bin.deviation));
            }
        }
    }
    return text;
}

}  // namespace

std::vector<std::filesystem::path> write_comparison(const Comparison& comparison,
                                                    const std::filesystem::path& directory) {
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (error) {
        throw FileError("create", directory, error.message());
    }
    std::vector<std::filesystem::path> files{directory / "compare.csv", directory / "compare_statistics.csv"};
    replace_file(files[0], samples_csv(comparison));
    replace_file(files[1], statistics_csv(comparison));
    if (!comparison.images.empty()) {
        files.push_back(directory / "compare_pixels.csv");
        replace_file(files.back(), pixels_csv(comparison.images, comparison.runs));
    }
    for (const ComparedImages& images : comparison.images) {
        const std::string& run = comparison.runs[images.run];
        files.push_back(directory / fmt::format("compare_{}_{}.png", images.camera, run));
        draw_images(files.back(), images, images.worst, fmt::format("{}, {}, worst frame", images.camera, run));
    }
    return files;
}

}  // namespace tiretherm::post
