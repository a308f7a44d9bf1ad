// SPDX-License-Identifier: BSD-3-Clause
// Integrates the specimen under constant light and reads spot, mean and inner face at the wanted times.

#include "laser/laser_truth.hpp"

#include <numeric>
#include <span>

#include "laser/laser_elements_truth.hpp"
#include "numerics/rodas_truth.hpp"

namespace hidden_effects {

namespace {

using Vector = std::vector<double>;

double dot(const Vector& x, const Vector& y) { return std::inner_product(x.begin(), x.end(), y.begin(), 0.0); }

/// The specimen under a light that does not change.
class SteadyLight : public HeatSystem {
public:
    explicit SteadyLight(const LaserElements& elements) : elements_(elements) {}

    [[nodiscard]] BandMatrix capacity() const override { return elements_.capacity(); }
    [[nodiscard]] std::size_t n_couplings() const override { return 0; }
    void heat(double /*t*/, std::span<const double> T, std::span<double> f, BandMatrix* band,
              std::vector<Coupling>* /*couplings*/) const override {
        elements_.heat(T, f, band);
    }

private:
    const LaserElements& elements_;
};

}  // namespace

LaserTrace heat_with_laser(const LaserSpecimen& specimen, const std::vector<double>& times,
                           const LaserResolution& resolution) {
    const LaserElements elements(specimen, resolution.refinement);
    const auto at_node = [&](std::size_t node) {
        Vector weights(elements.n_nodes(), 0.0);
        weights[node] = 1.0;
        return weights;
    };
    const std::array<Vector, 4> readers{elements.mean_over(true, 0.0, specimen.seen_spot),
                                        at_node(elements.node_on_axis(true)), at_node(elements.node_on_axis(false)),
                                        elements.mean_over(false, specimen.ring_inside, specimen.ring_outside)};
    LaserTrace trace;
    const std::array<Vector*, 4> out{&trace.spot_mean, &trace.spot_centre, &trace.inner_centre, &trace.inner_ring};
    const SteadyLight light(elements);
    Rodas rodas(light, Vector(elements.n_nodes(), specimen.start), 0.0, resolution.tolerance);
    Vector T = rodas.temperature();
    Vector rate = rodas.rate();
    double from = 0.0;
    for (std::size_t next = 0; next < times.size();) {
        // A first moment at 0 is read within the first step.
        rodas.step(times.back() > 0.0 ? times.back() : 1e-3);
        const Vector new_rate = rodas.rate();
        const double dt = rodas.time() - from;
        for (; next < times.size() && times[next] <= rodas.time(); ++next) {
            const double s = (times[next] - from) / dt;
            for (std::size_t i = 0; i < readers.size(); ++i) {
                out[i]->push_back(hermite(s, dt, dot(readers[i], T), dot(readers[i], rate),
                                          dot(readers[i], rodas.temperature()), dot(readers[i], new_rate)));
            }
        }
        from = rodas.time();
        T = rodas.temperature();
        rate = new_rate;
    }
    trace.n_steps = rodas.n_steps();
    return trace;
}

}  // namespace hidden_effects
