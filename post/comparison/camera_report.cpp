// SPDX-License-Identifier: BSD-3-Clause
// What a camera's frames say beside the simulated ones: where in the image, when, and at which size.
#include <algorithm>

#include <fmt/format.h>

#include "post/comparison/camera_chart.hpp"
#include "post/comparison/comparison_report.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double milli = 1e3;

Cell kelvin(double value) { return shown("{:.3g}", value); }
Cell with_sign(double value) { return shown("{:+.3g}", value); }

/// @param range heading and text of where a part is
DataTable parts(const std::vector<PartFigures>& figures, const std::string& heading,
                std::string (*range)(double, double), bool count_pixels) {
    DataTable table;
    for (const PartFigures& part : figures) {
        table.add({page_only(heading, right(range(part.from, part.to))),
                   data_only("from", part.from),
                   data_only("to", part.to),
                   count_pixels ? Field("pixels", "pixels", count(part.pixels)) : data_only("pixels", part.pixels),
                   {"mean K", "bias", with_sign(part.bias)},
                   {"rms", "rmse", kelvin(part.rmse)}});
    }
    return table;
}

DataTable rings(const ComparedImages& one) {
    return parts(
        one.rings, "mm from the spot's centre",
        [](double from, double to) { return fmt::format("{:.1f} to {:.1f}", milli * from, milli * to); }, true);
}

DataTable stages(const ComparedImages& one) {
    return parts(
        one.stages, "s", [](double from, double to) { return fmt::format("{:.6g} to {:.6g}", from, to); }, false);
}

Value sizes(const ComparedImages& one) {
    Value::List list;
    for (const auto& [name, rms] : one.scales) {
        list.push_back({{"size", name}, {"rmse", rms}});
    }
    return list;
}

DataTable overview(const std::vector<ComparedImages>& all, const std::vector<std::string>& runs) {
    DataTable table;
    for (const ComparedImages& one : all) {
        const Figures& f = one.figures;
        const Cell sensor(one.sensor, kelvin(one.sensor).text + (one.sensor_is_stated ? "" : "*"));
        table.add({{"camera", "name", one.camera},
                   {"run", "run", runs[one.run]},
                   data_only("file", one.file),
                   {"frames", "frames", {one.time.size(), std::to_string(one.time.size())}},
                   {"pixels", "pixels", count(one.pixels())},
                   data_only("dead", one.dead),
                   data_only("beside", one.beside),
                   {"bias K", "bias", with_sign(f.bias)},
                   {"+-", "bias_deviation", kelvin(f.bias_deviation)},
                   {"rms", "rmse", kelvin(f.rmse)},
                   {"scatter", "scatter", kelvin(f.scatter)},
                   {"noise", "noise", kelvin(one.noise)},
                   {"sensor", "sensor", sensor},
                   data_only("sensor_is_stated", one.sensor_is_stated),
                   {"rms model", "removable_rmse", kelvin(one.removable)},
                   data_only("worst_frame_at", one.time[one.worst]),
                   data_only("by_distance", rings(one).data()),
                   data_only("by_time", stages(one).data()),
                   data_only("by_size", sizes(one))});
    }
    return table;
}

void add_sizes(ReportSection& section, const ComparedImages& one) {
    const double finest = one.scales.front().second;
    if (!(finest > 0.0)) {
        return;
    }
    std::string list;
    for (const auto& [name, rms] : one.scales) {
        list += fmt::format("{}{} {:.3g}", list.empty() ? "" : ", ", name, rms / finest);
    }
    section.item("by size, as multiples of what white noise of the pixels would make of the finest: " + list);
    constexpr double in_common = 2.0;
    const bool alone =
        std::ranges::all_of(one.scales, [&](const auto& scale) { return scale.second < in_common * finest; });
    section.item(alone ? "neighbouring pixels have nothing in common that is seen"
                       : "what is above 1 neighbouring pixels have in common: an error of the model, or a drift of the "
                         "camera");
}

ReportSection camera_part(const ComparedImages& one, const std::string& run) {
    ReportSection part(fmt::format("{}, {}{}", one.camera, run,
                                   one.bin > 1 ? fmt::format(", {0} by {0} detectors a pixel", one.bin) : ""));
    part.chart(fmt::format("{}, {}: measured, simulated, difference", one.camera, run), camera_caption(one),
               camera_chart(one));
    part.add(rings(one));
    part.gap();
    part.add(stages(one));
    add_sizes(part, one);
    part.item(fmt::format("worst frame: {:.6g} s", one.time[one.worst]));
    if (one.dead + one.beside > 0) {
        part.item(fmt::format("{} dead detectors and {} beside the specimen are left out", one.dead, one.beside));
    }
    return part;
}

}  // namespace

ReportSection cameras_section(const std::vector<ComparedImages>& images, const std::vector<std::string>& runs,
                              Value& data) {
    ReportSection section("Cameras");
    if (images.empty()) {
        return section;
    }
    DataTable table = overview(images, runs);
    data = table.data();
    section.add(std::move(table));
    section.say(
        "noise: what changes in a pixel from one frame to the next; +- of the bias follows from how the frames' mean "
        "goes along time, not from the number of pixels; rms model: rms without sensor noise.");
    if (!std::ranges::all_of(images, &ComparedImages::sensor_is_stated)) {
        section.say("* not stated, noise is taken; state standard_deviation with the [[camera]].");
    }
    for (const ComparedImages& one : images) {
        section.gap();
        section.add(camera_part(one, runs[one.run]));
    }
    return section;
}

}  // namespace tiretherm::post
