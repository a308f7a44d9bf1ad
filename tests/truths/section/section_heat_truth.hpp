// SPDX-License-Identifier: BSD-3-Clause
// Right-hand side of the section bench: heat flow into the nodes of the finite elements and into the gas.
#pragma once

#include "numerics/rodas_truth.hpp"
#include "section/section_shape_truth.hpp"

namespace hidden_effects {

/// The inputs of the bench at one moment.
struct SectionInputs {
    double V = 0.0;
    double Fz = 0.0;
    double alpha = 0.0;
    double Fy = 0.0;
    double camber = 0.0;
    double T_air = 0.0;  ///< as it is, drift included
    double T_road = 0.0;
    double throttle = 0.0;
};

/// The bench's right-hand side. Bench, causes and programme must outlive it.
class SectionHeat : public HeatSystem {
public:
    SectionHeat(const SectionBench& bench, const SectionCauses& causes, const SectionProgramme& programme,
                int refinement, Strip strip)
        : bench_(bench), causes_(causes), programme_(programme), shape_(causes, refinement, strip) {}

    [[nodiscard]] const SectionShape& shape() const { return shape_; }
    /// From now on time lies between these two, within interval i of the programme.
    void move_to(std::size_t i, double from, double to);
    /// When an input passes a switch in interval i, with the interval's end as the last. s
    [[nodiscard]] std::vector<double> stops(std::size_t i) const;

    [[nodiscard]] BandMatrix capacity() const override { return shape_.capacity; }
    [[nodiscard]] std::size_t n_couplings() const override { return 3; }
    void heat(double t, std::span<const double> T, std::span<double> f, BandMatrix* band,
              std::vector<Coupling>* couplings) const override;

private:
    /// A power and its relative change with the bulk's and the gas's temperature. 1/K
    struct Loss {
        double watts = 0.0;
        double by_bulk = 0.0;
        double by_gas = 0.0;
    };
    [[nodiscard]] SectionInputs inputs(double t) const;
    [[nodiscard]] Loss loss(const SectionInputs& in, double T_bulk, double T_gas) const;
    void add_tread(const SectionInputs& in, std::span<const double> T, std::span<double> f, BandMatrix* band) const;

    const SectionBench& bench_;
    const SectionCauses& causes_;
    const SectionProgramme& programme_;
    SectionShape shape_;
    std::size_t interval_ = 0;
    bool rolls_ = false;
};

}  // namespace hidden_effects
