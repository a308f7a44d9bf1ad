// What a camera's frames say beside the simulated ones, as a page and as a table.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "post/comparison/comparison_report.hpp"
#include "post/report/table.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double milli = 1e3;

std::string kelvin(double value) { return fmt::format("{:.3g}", value); }
std::string with_sign(double value) { return fmt::format("{:+.3g}", value); }

std::string overview(const std::vector<ComparedImages>& all, const std::vector<std::string>& runs) {
    Table table({true, true, false, false, false, false, false, false, false, false, false});
    table.add({"camera", "run", "frames", "pixels", "bias K", "+-", "rms", "scatter", "noise", "sensor", "rms model"});
    for (const ComparedImages& one : all) {
        table.add({one.camera, runs[one.run], std::to_string(one.time.size()),
                   grouped(static_cast<double>(one.pixels())), with_sign(one.figures.bias),
                   kelvin(one.figures.bias_deviation), kelvin(one.figures.rmse), kelvin(one.figures.scatter),
                   kelvin(one.noise), kelvin(one.sensor) + (one.sensor_is_stated ? "" : "*"), kelvin(one.removable)});
    }
    std::string text = table.text(2);
    text += wrap(
        "noise: what changes in a pixel from one frame to the next; +- of the bias follows from how the frames' mean "
        "goes "
        "along time, not from the number of pixels; rms model: rms without sensor noise.",
        2);
    if (std::ranges::any_of(all, [](const auto& one) { return !one.sensor_is_stated; })) {
        text += wrap("* not stated, noise is taken; state standard_deviation with the [[camera]].", 2);
    }
    return text;
}

/// Where in the image, and when.
std::string parts(const ComparedImages& one) {
    Table where({false, false, false, false});
    where.add({"mm from the spot's centre", "pixels", "mean K", "rms"});
    for (const PartFigures& ring : one.rings) {
        where.add({fmt::format("{:.1f} to {:.1f}", milli * ring.from, milli * ring.to),
                   grouped(static_cast<double>(ring.pixels)), with_sign(ring.bias), kelvin(ring.rmse)});
    }
    Table when({false, false, false});
    when.add({"s", "mean K", "rms"});
    for (const PartFigures& stage : one.stages) {
        when.add({fmt::format("{:.6g} to {:.6g}", stage.from, stage.to), with_sign(stage.bias), kelvin(stage.rmse)});
    }
    return where.text(4) + "\n" + when.text(4);
}

std::string by_scale(const ComparedImages& one) {
    const double finest = one.scales.front().second;
    if (!(finest > 0.0)) {
        return "";
    }
    std::string list;
    for (const auto& [name, rms] : one.scales) {
        list += fmt::format("{}{} {:.3g}", list.empty() ? "" : ", ", name, rms / finest);
    }
    std::string text = wrap(
        fmt::format("- by size, as multiples of what white noise of the pixels would make of the finest: {}", list), 4);
    constexpr double in_common = 2.0;
    const bool alone =
        std::ranges::all_of(one.scales, [&](const auto& scale) { return scale.second < in_common * finest; });
    return text + wrap(alone
                                 ? "- neighbouring pixels have nothing in common that is seen"
                                 : "- what is above 1 neighbouring pixels have in common: an error of the model, or a "
                                   "drift of the camera",
                             4);
}

}  // namespace

std::string cameras_text(const std::vector<ComparedImages>& images, const std::vector<std::string>& runs) {
    if (images.empty()) {
        return "";
    }
    std::string text = overview(images, runs);
    for (const ComparedImages& one : images) {
        text += fmt::format("\n  {}, {}{}\n", one.camera, runs[one.run],
                            one.bin > 1 ? fmt::format(", {0} by {0} detectors a pixel", one.bin) : "");
        text += parts(one) + by_scale(one);
        text += wrap(fmt::format("- worst frame: {:.6g} s", one.time[one.worst]), 4);
        if (one.dead + one.beside > 0) {
            text += wrap(
                fmt::format("- {} dead detectors and {} beside the specimen are left out", one.dead, one.beside), 4);
        }
    }
    return text;
}

std::string pixels_csv(const std::vector<ComparedImages>& images, const std::vector<std::string>& runs) {
    std::string text =
        "run,camera,row,column,x [m],y [m],frames,mean difference [K],rms [K],difference at the end [K]\n";
    for (const ComparedImages& one : images) {
        for (std::size_t p = 0; p < one.pixels(); ++p) {
            double sum = 0.0;
            double squares = 0.0;
            for (std::size_t f = 0; f < one.time.size(); ++f) {
                sum += one.difference(f, p);
                squares += one.difference(f, p) * one.difference(f, p);
            }
            const auto n = static_cast<double>(one.time.size());
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{:.6g},{:.6g},{},{:.5g},{:.5g},{:.5g}\n",
                           runs[one.run], one.camera, one.place[p][0], one.place[p][1], one.where[p][0],
                           one.where[p][1], one.time.size(), sum / n, std::sqrt(squares / n),
                           one.difference(one.time.size() - 1, p));
        }
    }
    return text;
}

}  // namespace tiretherm::post
