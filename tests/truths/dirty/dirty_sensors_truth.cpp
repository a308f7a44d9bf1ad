// SPDX-License-Identifier: BSD-3-Clause
// Emissivity by Stefan and Boltzmann's law, lag by its exact response to straight lines, delay, offset; then sampling.

#include "dirty/dirty_sensors_truth.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/random_truth.hpp"

namespace hidden_effects {

namespace {

const std::vector<double>& place_of(const DirtySensor& sensor, const DirtyTrace& trace) {
    switch (sensor.place) {
        case DirtySensor::Place::inside_shoulder:
            return trace.surface[0];
        case DirtySensor::Place::crown:
            return trace.surface[1];
        case DirtySensor::Place::outside_shoulder:
            return trace.surface[2];
        case DirtySensor::Place::bulk:
            return trace.bulk;
        case DirtySensor::Place::probe:
            return trace.probe;
        case DirtySensor::Place::liner:
            return trace.liner;
        case DirtySensor::Place::gas:
            break;
    }
    return trace.gas;
}

}  // namespace

std::vector<double> dirty_course(const DirtySensor& sensor, const DirtyTrace& trace, const DirtyDrive& drive) {
    std::vector<double> course = place_of(sensor, trace);
    if (sensor.emissivity != 1.0) {
        for (std::size_t i = 0; i < course.size(); ++i) {
            const double air = std::pow(drive.air_temperature[i], 4);
            course[i] = std::pow(sensor.emissivity * std::pow(course[i], 4) + (1.0 - sensor.emissivity) * air, 0.25);
        }
    }
    if (sensor.tau > 0.0) {
        // tau y' = x - y, x straight over a step: y = x - tau x' + (y0 - x0 + tau x') exp(-dt/tau).
        const double kept = std::exp(-dirty_step / sensor.tau);
        double shown = course.front();
        double before = course.front();
        for (double& value : course) {
            const double rate = (value - before) / dirty_step;
            shown = value - sensor.tau * rate + (shown - before + sensor.tau * rate) * kept;
            before = value;
            value = shown;
        }
    }
    if (sensor.delay != 0.0) {
        const std::vector<double> early = course;
        for (std::size_t i = 0; i < course.size(); ++i) {
            course[i] = dirty_value(early, static_cast<double>(i) * dirty_step - sensor.delay);
        }
    }
    for (double& value : course) {
        value += sensor.offset;
    }
    return course;
}

std::vector<double> dirty_log(const DirtySensor& sensor, const std::vector<double>& course, double interval,
                              std::uint64_t seed) {
    const double end = static_cast<double>(course.size() - 1) * dirty_step;
    const double own = sensor.interval > 0.0 ? sensor.interval : interval;
    std::vector<double> times;
    std::vector<double> samples;
    for (std::size_t i = 0; static_cast<double>(i) * own <= end + 1e-9; ++i) {
        times.push_back(static_cast<double>(i) * own);
        samples.push_back(dirty_value(course, times.back()));
    }
    if (seed > 0) {
        Random random(seed);
        const std::vector<double> noise = draw_noise(
            {.standard_deviation = sensor.sigma, .correlated_share = sensor.correlated_share, .correlation = 0.7},
            times, random);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i] += noise[i];
        }
    }
    double last = samples.front();
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (sensor.resolution > 0.0) {
            // Steps are those of the scale in degrees Celsius.
            samples[i] = std::round((samples[i] - 273.15) / sensor.resolution) * sensor.resolution + 273.15;
        }
        samples[i] = std::min(samples[i], sensor.clip);
        samples[i] = times[i] >= sensor.stuck_from ? last : samples[i];
        last = samples[i];
    }
    std::vector<double> log;
    for (std::size_t i = 0; static_cast<double>(i) * interval <= end + 1e-9; ++i) {
        const double place = std::min(static_cast<double>(i) * interval / own, static_cast<double>(samples.size() - 1));
        const auto k = std::min(static_cast<std::size_t>(place), samples.size() - 2);
        log.push_back(samples[k] + (place - static_cast<double>(k)) * (samples[k + 1] - samples[k]));
    }
    return log;
}

}  // namespace hidden_effects
