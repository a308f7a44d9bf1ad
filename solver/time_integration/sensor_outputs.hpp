// SPDX-License-Identifier: BSD-3-Clause
// Channels as the sensors give them: the quantity at its place, then the sensor models in the order of the catalogue;
// also as linear forms for the adjoint.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/time_integration/checkpoint.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

/// The channels of a run as its sensors give them: the quantity at its place, then the sensor models in the order of
/// the catalogue. Between the stages of a step a channel follows the parabola through them, along which a sensor's lag
/// is integrated exactly and into whose past a delay looks.
class SensorOutputs {
public:
    /// @param system placed effects and laws; lives as long as this
    SensorOutputs(const Problem& problem, const System& system);

    /// The state at the start, before any step. @param inputs logged
    void begin(double t, std::span<const double> T, std::span<const double> watts, const physics::Inputs& inputs);
    /// After an accepted step. @param stages its begin and its end among them  @param inputs logged ones at its stages
    void take_step(std::span<const StepMoment> stages, std::span<const physics::Inputs> inputs);
    /// The last step as it would have been through other stages.
    /// @param as with the same channels, of a neighbouring problem, after the step
    void retake_step(const SensorOutputs& as, std::span<const StepMoment> stages,
                     std::span<const physics::Inputs> inputs);
    /// A moment of the last step, or the start. @param t s  @param logged inputs of that moment
    /// @param out [n_channels] SI
    void at(double t, const physics::Inputs& logged, std::span<double> out) const;

    /// What a channel follows at a moment, as a linear form of small changes: of the temperature at its place at the
    /// stages of a step, and of what a lagging sensor gave at its begin. All zero for what follows no temperature.
    struct Form {
        std::array<double, 3> stage{};
        double lagged = 0.0;
    };
    /// @param stages of the step, in which the moment lies or after which it comes  @param t s, on the sensor's clock
    [[nodiscard]] Form form(std::size_t channel, std::span<const StepMoment> stages,
                            std::span<const physics::Inputs> inputs, double t) const;
    /// Slope of what a channel shows with what it follows; of a force that follows the surface as well, at a given surface. @param t s, @param logged inputs of that moment
    [[nodiscard]] double slope(std::size_t channel, double t, const physics::Inputs& logged) const;
    /// The moment that a channel shows at t, by its clock. s
    [[nodiscard]] double moment(std::size_t channel, double t) const { return chains_[channel].moment(t); }
    [[nodiscard]] const mesh::Functional& place(std::size_t channel) const { return chains_[channel].where; }
    /// Whether another one gives the same of the same temperatures, and all of it is linear in them: given the derivatives of the
    /// temperatures, each gives those of its channels.
    [[nodiscard]] bool is_linear_and_as(const SensorOutputs& other) const;

    void visit(Archive& archive);

private:
    /// A channel's value over one step: a + b u + c u^2 with u seconds since its begin.
    struct Piece {
        double begin = 0.0;
        double end = 0.0;
        double a = 0.0;
        double b = 0.0;
        double c = 0.0;
        double lagged = 0.0;  ///< what a lagging sensor gave at the begin

        [[nodiscard]] double value(double t) const { return a + (t - begin) * (b + c * (t - begin)); }
        [[nodiscard]] double slope(double t) const { return b + 2.0 * c * (t - begin); }
    };
    /// One sensor model on one channel.
    struct AppliedModel {
        const physics::ActiveEffect* active = nullptr;
        std::size_t position = 0;  ///< of the channel in the effect's list
        double (*read)(const physics::ActiveEffect& active, std::size_t position, double value,
                       const physics::Inputs& logged) = nullptr;
    };
    struct Chain {
        mesh::Functional where;
        std::vector<AppliedModel> before;  ///< the lag
        std::vector<AppliedModel> after;
        double lag = 0.0;         ///< s
        double delay = 0.0;       ///< s
        double rate = 0.0;        ///< of the clock, s for each s
        std::vector<Piece> past;  ///< as far back as the delay looks

        [[nodiscard]] double moment(double t) const { return t - delay - rate * t; }
    };

    [[nodiscard]] Piece piece_over(std::size_t channel, std::span<const StepMoment> stages,
                                   std::span<const physics::Inputs> inputs, double lagged) const;
    [[nodiscard]] double followed_quantity(std::size_t channel, std::span<const double> T,
                                           std::span<const double> watts) const;
    [[nodiscard]] double quantity(std::size_t channel, double t, double followed, const physics::Inputs& logged) const;
    [[nodiscard]] static double followed(const Chain& chain, const Piece& piece, double t);
    /// After the end of the last piece, as it is changing there.
    [[nodiscard]] static double ahead(const Chain& chain, const Piece& piece, double t);
    [[nodiscard]] double shown(std::size_t channel, double t, double followed, const physics::Inputs& logged) const;
    [[nodiscard]] static double delayed(const Chain& chain, double t);

    const Problem* problem_;
    const System* system_;
    std::vector<Chain> chains_;  ///< [n_channels]; behind them the mean of the surface, where friction follows it
    double gas_start_ = 0.0;     ///< K
    mutable std::vector<double> coefficients_;  ///< of all effects at the inputs of a moment
    mutable std::vector<double> flow_;          ///< [n_nodes] and
    mutable std::vector<double> means_;         ///< [n_regions] for quantities to work in
};

}  // namespace tiretherm::solver
