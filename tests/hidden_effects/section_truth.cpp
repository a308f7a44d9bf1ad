#include "section_truth.hpp"

#include <cmath>
#include <numeric>

#include "section_heat_truth.hpp"

namespace hidden_effects {

namespace {

constexpr double celsius = 273.15;

double dot(const std::vector<double>& weights, const std::vector<double>& T) {
    return std::inner_product(weights.begin(), weights.end(), T.begin(), 0.0);
}

/// A value and how fast it changes.
struct Course {
    double value = 0.0;
    double rate = 0.0;
};

/// What a camera of wrong emissivity makes of a temperature, with T_air at rest.
Course seen(double emissivity, double T_air, const Course& of) {
    if (emissivity == 1.0) {
        return of;
    }
    const double fourth = emissivity * std::pow(of.value, 4) + (1.0 - emissivity) * std::pow(T_air, 4);
    const double value = std::pow(fourth, 0.25);
    return {value, emissivity * std::pow(of.value / value, 3) * of.rate};
}

/// tau y' = p - y over a step, p the cubic through its ends: y = p - tau p' + tau^2 p'' - tau^3 p''' + C exp(-t/tau).
double lagged(double before, double tau, double dt, const Course& begin, const Course& end) {
    const double chord = (end.value - begin.value) / dt;
    const double c = (3.0 * chord - 2.0 * begin.rate - end.rate) / dt;
    const double d = (begin.rate + end.rate - 2.0 * chord) / (dt * dt);
    const auto particular = [&](double t) {
        const double p = begin.value + t * (begin.rate + t * (c + t * d));
        const double first = begin.rate + t * (2.0 * c + 3.0 * d * t);
        const double second = 2.0 * c + 6.0 * d * t;
        return p - tau * (first - tau * (second - tau * 6.0 * d));
    };
    return particular(dt) + (before - particular(0.0)) * std::exp(-dt / tau);
}

class Sensors {
public:
    Sensors(const SectionCauses& causes, const SectionShape& shape) : causes_(causes) {
        std::vector<double> gas(shape.n_nodes(), 0.0);
        gas[shape.gas()] = 1.0;
        place_ = {shape.crown_surface, shape.at(-shoulder_middle, 0.010), shape.at(shoulder_middle, 0.010),
                  shape.at(0.0, section_depth), gas};
        for (const Reading& reading : causes.reading) {
            lags_ = lags_ || reading.tau > 0.0;
        }
    }
    [[nodiscard]] bool lags() const { return lags_; }
    /// What the elements of the sensors are at.
    [[nodiscard]] std::array<Course, 5> now(const std::vector<double>& T, const std::vector<double>& rate,
                                            double T_air) const {
        std::array<Course, 5> out;
        for (std::size_t c = 0; c < 5; ++c) {
            out[c] = seen(causes_.reading[c].emissivity, T_air,
                          {dot(place_[c], T), rate.empty() ? 0.0 : dot(place_[c], rate)});
        }
        return out;
    }
    void start(const std::array<Course, 5>& at) {
        for (std::size_t c = 0; c < 5; ++c) {
            state_[c] = at[c].value;
        }
    }
    void follow(double dt, const std::array<Course, 5>& from, const std::array<Course, 5>& to) {
        for (std::size_t c = 0; c < 5; ++c) {
            const double tau = causes_.reading[c].tau;
            state_[c] = tau > 0.0 ? lagged(state_[c], tau, dt, from[c], to[c]) : to[c].value;
        }
    }
    void read(SectionTrace& trace) const {
        for (std::size_t c = 0; c < 5; ++c) {
            const double shifted = state_[c] + causes_.reading[c].kelvin;
            trace.channel[c].push_back(shifted + causes_.reading[c].excess * (shifted - celsius - 25.0));
        }
    }

private:
    const SectionCauses& causes_;
    std::array<std::vector<double>, 5> place_;
    std::array<double, 5> state_{};
    bool lags_ = false;
};

}  // namespace

SectionTrace drive_section(const SectionBench& bench, const SectionProgramme& programme,
                           const SectionResolution& resolution) {
    const SectionCauses causes = gather_section(bench.causes);
    SectionHeat heat(bench, causes, programme, resolution.refinement);
    std::vector<double> T(heat.shape().n_nodes(), bench.start);
    T.back() = bench.gas_start > 0.0 ? bench.gas_start : programme.air_temperature.front();
    Rodas rodas(heat, T, programme.time.front(), resolution.tolerance);
    Sensors sensors(causes, heat.shape());
    sensors.start(sensors.now(T, {}, programme.air_temperature.front()));
    SectionTrace trace;
    sensors.read(trace);
    for (std::size_t i = 0; i + 1 < programme.time.size(); ++i) {
        const auto air = [&](double t) {
            const double share = (t - programme.time[i]) / (programme.time[i + 1] - programme.time[i]);
            return programme.air_temperature[i] +
                   share * (programme.air_temperature[i + 1] - programme.air_temperature[i]);
        };
        for (const double stop : heat.stops(i)) {
            heat.move_to(i, rodas.time(), stop);
            while (rodas.time() < stop) {
                const double from = rodas.time();
                std::array<Course, 5> begin;
                if (sensors.lags()) {
                    begin = sensors.now(rodas.temperature(), rodas.rate(), air(from));
                }
                rodas.step(stop);
                const std::vector<double> rate = sensors.lags() ? rodas.rate() : std::vector<double>{};
                sensors.follow(rodas.time() - from, begin, sensors.now(rodas.temperature(), rate, air(rodas.time())));
            }
        }
        sensors.read(trace);
    }
    trace.n_steps = rodas.n_steps();
    return trace;
}

}  // namespace hidden_effects
