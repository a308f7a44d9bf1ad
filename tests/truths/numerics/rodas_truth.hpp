// SPDX-License-Identifier: BSD-3-Clause
// Rosenbrock integrator RODAS of order 4(3): Hairer and Wanner, Solving Ordinary Differential Equations II, IV.10.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "numerics/band_truth.hpp"

namespace hidden_effects {

/// A product u v^T beside the band of a Jacobian: a heat u that follows a mean temperature v.
struct Coupling {
    std::vector<double> u;
    std::vector<double> v;
};

/// Something that stores heat: M dT/dt = f(t, T), with df/dT = band + sum of u v^T.
class HeatSystem {
public:
    HeatSystem() = default;
    HeatSystem(const HeatSystem&) = default;
    HeatSystem& operator=(const HeatSystem&) = default;
    HeatSystem(HeatSystem&&) = default;
    HeatSystem& operator=(HeatSystem&&) = default;
    virtual ~HeatSystem() = default;

    /// M, whose size and reach are those of the Jacobian's band.
    [[nodiscard]] virtual BandMatrix capacity() const = 0;
    [[nodiscard]] virtual std::size_t n_couplings() const = 0;
    /// f(t, T) and, unless they are null, its derivatives; the band comes as zeros, the couplings with their sizes.
    virtual void heat(double t, std::span<const double> T, std::span<double> f, BandMatrix* band,
                      std::vector<Coupling>* couplings) const = 0;
};

/// RODAS, order 4(3), six stages, stiffly accurate (Hairer and Wanner, Solving Ordinary Differential Equations II, IV.10),
/// for right-hand sides that follow time too. The exact Jacobian is that of the band plus its couplings (Woodbury).
class Rodas {
public:
    /// @param tolerance K, local error of a step
    Rodas(const HeatSystem& system, std::vector<double> start, double time, double tolerance);

    [[nodiscard]] const std::vector<double>& temperature() const { return T_; }
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] int n_steps() const { return n_steps_; }
    /// dT/dt = M^-1 f(t, T) from here on.
    [[nodiscard]] std::vector<double> rate();
    /// One step of the length that the error asks for, at most to `end`, up to which f is smooth in time.
    void step(double end);

private:
    bool attempt(double dt, double end);
    void solve(std::vector<double>& x) const;
    void prepare_couplings();

    const HeatSystem& system_;
    double tolerance_;
    BandMatrix M_;
    BandMatrix M_factor_;
    BandMatrix J_;
    BandMatrix A_;
    std::vector<Coupling> couplings_;
    std::vector<std::vector<double>> solved_;  ///< A^-1 u of each coupling
    std::vector<double> small_;                ///< inverse of 1 - v^T A^-1 u, row by row
    std::vector<double> T_;
    std::vector<double> f_;
    std::vector<double> by_time_;  ///< df/dt
    double time_;
    double dt_ = 1e-3;
    int n_steps_ = 0;
};

/// The cubic through values and rates at both ends of a step, at a share s of it.
[[nodiscard]] double hermite(double s, double dt, double y0, double rate0, double y1, double rate1);

}  // namespace hidden_effects
