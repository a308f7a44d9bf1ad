// SPDX-License-Identifier: BSD-3-Clause
// Words the figures of a compared channel: bias, scatter against the sensor's noise, factor of the rise, and the
// closest signal.

#include "post/comparison/comparison_sentences.hpp"

#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double plain = 2.0;          ///< standard deviations: 95 %
constexpr double beyond_sensor = 3.0;  ///< times the sensor's standard deviation: no noise of it

/// How much larger the error is than the sensor's noise; 0 where neither is known.
double times_the_sensor(const ComparedChannel& channel) {
    return channel.sensor > 0.0 && std::isfinite(channel.figures.rmse) ? channel.figures.rmse / channel.sensor : 0.0;
}

std::string bias_sentence(const ComparedChannel& channel) {
    const Figures& f = channel.figures;
    const std::string unit = difference_unit(channel.unit.name);
    if (f.samples == 1) {
        return fmt::format("a single sample, {} {} off", shown_signed(channel, f.bias), unit);
    }
    const std::string deviation = shown(channel, f.bias_deviation);
    if (std::abs(f.bias) < plain * f.bias_deviation && times_the_sensor(channel) > beyond_sensor) {
        return fmt::format(
            "bias {} +- {} {}: an effective sample size of {:.0f} is too small to tell it from zero, but the rms of {} "
            "{} is {} times the sensor's noise",
            shown_signed(channel, f.bias), deviation, unit, f.independent, shown(channel, f.rmse), unit,
            to_its_digits(times_the_sensor(channel), times_the_sensor(channel)));
    }
    if (std::abs(f.bias) < plain * f.bias_deviation) {
        return fmt::format("no significant bias: {} +- {} {} (effective sample size {:.0f})",
                           shown_signed(channel, f.bias), deviation, unit, f.independent);
    }
    return fmt::format("{} +- {} {} too {} on the whole (effective sample size {:.0f})",
                       shown(channel, std::abs(f.bias)), deviation, unit, too(channel.unit, f.bias > 0.0),
                       f.independent);
}

std::string sensor_text(const ComparedChannel& channel) {
    return fmt::format("{} {} ({})", shown(channel, channel.sensor), difference_unit(channel.unit.name),
                       channel.sensor_is_stated ? "stated" : "no standard deviation is stated: sample to sample");
}

std::string scatter_sentence(const ComparedChannel& channel) {
    const std::string unit = difference_unit(channel.unit.name);
    if (channel.model.below_sensor) {
        return fmt::format(
            "the differences scatter by {} {}, less than the sensor may by itself, {}: nothing but the bias is left to "
            "the model",
            shown(channel, channel.figures.scatter), unit, sensor_text(channel));
    }
    return fmt::format("without the sensor's {} the model scatters by {} {}, and its rms is {} {}",
                       sensor_text(channel), shown(channel, channel.model.scatter), unit,
                       shown(channel, channel.model.removable), unit);
}

std::string factor_sentence(const ComparedChannel& channel) {
    const bool is_temperature = std::string_view(channel.unit.name) == "degC";
    const std::string spread = channel.model.relative == 0.0 ? "and scatters no more than the sensor"
                                                             : fmt::format("with a standard deviation of {:.2g} %",
                                                                           100.0 * channel.model.relative);
    return fmt::format("{} is {:.3f} times the measured one, {} ({} of {} samples)",
                       is_temperature ? "the simulated rise over the air" : "the simulated value", channel.model.factor,
                       spread, channel.model.compared, channel.figures.samples);
}

std::string regressor_sentence(const ComparedChannel& channel) {
    const RegressorFigures& closest = channel.regressors.front();
    const Association& a = closest.association;
    const std::string strength =
        fmt::format("correlation {:+.2f}, effective sample size {:.0f}", a.correlation, a.independent);
    if (a.chance > channel.significant) {
        return fmt::format("the differences follow none of {} signals beyond chance; the closest is {} ({})",
                           channel.regressors.size(), closest.name, strength);
    }
    const Bin& low = closest.bins.front();
    const Bin& high = closest.bins.back();
    return fmt::format(
        "of {} signals the differences follow {} closest ({}, {:.1f} standard deviations): {} {} where it is below "
        "{:.4g} {}, {} {} where it is above {:.4g} {}",
        channel.regressors.size(), closest.name, strength, std::abs(a.sigmas), shown_signed(channel, low.mean),
        difference_unit(channel.unit.name), low.high, closest.unit, shown_signed(channel, high.mean),
        difference_unit(channel.unit.name), high.low, closest.unit);
}

}  // namespace

std::string grid_error_text(const std::string& channel, const solver::ShownUnit& unit, double error) {
    return fmt::format("at most {:.2g} {} of {}", unit.difference(error), difference_unit(unit.name), channel);
}

std::string too(const solver::ShownUnit& unit, bool large) {
    if (std::string_view(unit.name) == "degC") {
        return large ? "hot" : "cold";
    }
    return large ? "large" : "small";
}

std::string shown(const ComparedChannel& channel, double difference) {
    const double value = channel.unit.difference(difference);
    if (!std::isfinite(value)) {
        return "-";
    }
    return value == 0.0 || std::abs(value) >= 0.1 ? fmt::format("{:.2f}", value) : fmt::format("{:.2g}", value);
}

std::string shown_signed(const ComparedChannel& channel, double difference) {
    return (difference >= 0.0 ? "+" : "") + shown(channel, difference);
}

namespace {

/// "; at most -2.30 K, at 31 s of wet": the largest difference; empty where there is none.
std::string largest_text(const ComparedChannel& channel, const std::vector<std::string>& runs) {
    double most = 0.0;
    double when = 0.0;
    std::size_t run = 0;
    for (const ComparedSeries& series : channel.series) {
        const std::vector<double> differences = series.difference();
        for (std::size_t i = 0; i < differences.size(); ++i) {
            if (std::abs(differences[i]) > std::abs(most)) {
                most = differences[i];
                when = series.time[i];
                run = series.run;
            }
        }
    }
    return most == 0.0
               ? ""
               : fmt::format("; at most {} {}, at {:.4g} s{}", shown_signed(channel, most),
                             difference_unit(channel.unit.name), when, runs.size() > 1 ? " of " + runs[run] : "");
}

}  // namespace

std::string headline(const ComparedChannel& channel, const std::vector<std::string>& runs) {
    const Figures& f = channel.figures;
    const std::string unit = difference_unit(channel.unit.name);
    const std::string size =
        fmt::format("{} +- {} {}", shown(channel, std::abs(f.bias)), shown(channel, f.bias_deviation), unit);
    const bool is_plain = std::abs(f.bias) >= plain * f.bias_deviation;
    const std::string of_runs = runs.size() > 1 ? fmt::format(" of {} runs", runs.size()) : "";
    std::string text = is_plain ? fmt::format("{}: simulated {} too {} in the mean{}", channel.name, size,
                                              too(channel.unit, f.bias > 0.0), of_runs)
                                : fmt::format("{}: mean difference{} {}{}, not significant", channel.name, of_runs,
                                              f.bias < 0.0 ? "-" : "+", size);
    text += fmt::format("; rms {} {}", shown(channel, f.rmse), unit);
    if (const double times = times_the_sensor(channel); times > 0.0) {
        text += fmt::format(", {} times the {} of {} {}", to_its_digits(times, times),
                            channel.sensor_is_stated ? "sensor's standard deviation" : "noise",
                            shown(channel, channel.sensor), unit);
    }
    return text + largest_text(channel, runs) + ".";
}

std::string chance_text(double chance) { return chance < 1e-9 ? "< 1e-9" : fmt::format("{:.1g}", chance); }

std::string corner_sentence(const ComparedChannel& channel, const CommonBias& common) {
    const std::string who =
        common.group == "all" ? (common.corners.size() == 2 ? std::string("both tires are")
                                                            : fmt::format("all {} tires are", common.corners.size()))
        : !common.group.empty()
            ? fmt::format("only the {} ones ({}) are", common.group, fmt::join(common.corners, ", "))
        : common.corners.size() == 1 ? fmt::format("only {} is", common.corners.front())
                                     : fmt::format("{} are", fmt::join(common.corners, ", "));
    const std::string least = shown(channel, std::abs(common.least));
    const std::string most = shown(channel, std::abs(common.most));
    return fmt::format("{}, {}: {} too {}, by {} {}", channel.name, name_of(common.phase), who,
                       too(channel.unit, common.most > 0.0), least == most ? most : least + " to " + most,
                       difference_unit(channel.unit.name));
}

std::vector<std::string> sentences(const ComparedChannel& channel) {
    std::vector<std::string> said{bias_sentence(channel)};
    if (channel.figures.samples > 2) {
        said.push_back(scatter_sentence(channel));
    }
    if (channel.model.compared > 0) {
        said.push_back(factor_sentence(channel));
    }
    if (!channel.regressors.empty()) {
        said.push_back(regressor_sentence(channel));
    }
    return said;
}

}  // namespace tiretherm::post
