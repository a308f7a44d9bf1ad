#include "laser_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "band_truth.hpp"
#include "laser_elements_truth.hpp"

namespace hidden_effects {

namespace {

// RODAS, order 4(3), six stages, stiffly accurate. With u = sum of stages as unknowns:
//     (M/(gamma dt) - J) u_i = f(y + sum_j a_ij u_j) + M sum_j (c_ij/dt) u_j
// The last stage is the estimate of the error.
constexpr int n_stages = 6;
constexpr double gamma_of_rodas = 0.25;
constexpr double a[n_stages][n_stages - 1] = {
    {0, 0, 0, 0, 0},
    {1.544, 0, 0, 0, 0},
    {0.9466785280815826, 0.2557011698983284, 0, 0, 0},
    {3.314825187068521, 2.896124015972201, 0.9986419139977817, 0, 0},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 0},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}};
constexpr double c[n_stages][n_stages - 1] = {
    {0, 0, 0, 0, 0},
    {-5.6688, 0, 0, 0, 0},
    {-2.430093356833875, -0.2063599157091915, 0, 0, 0},
    {-0.1073529058151375, -9.594562251023355, -20.47028614809616, 0, 0},
    {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160, 0},
    {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}};

using Vector = std::vector<double>;

double dot(const Vector& x, const Vector& y) { return std::inner_product(x.begin(), x.end(), y.begin(), 0.0); }

/// Advances M dT/dt = f(T) by one step at a time, of the length that the error asks for.
class Rodas {
public:
    Rodas(const LaserElements& elements, double start, double tolerance)
        : elements_(elements),
          tolerance_(tolerance),
          M_(elements.capacity()),
          M_factor_(M_),
          J_(elements.n_nodes(), elements.reach()),
          A_(J_),
          T_(elements.n_nodes(), start),
          f_(elements.n_nodes()) {
        M_factor_.factorise();
    }

    [[nodiscard]] const Vector& temperature() const { return T_; }
    [[nodiscard]] double time() const { return time_; }
    /// dT/dt = M^-1 f(T)
    [[nodiscard]] Vector rate() {
        elements_.heat(T_, f_, nullptr);
        Vector rate = f_;
        M_factor_.solve(rate);
        return rate;
    }
    void step() {
        J_.set_zero();
        elements_.heat(T_, f_, &J_);
        for (bool accepted = false; !accepted;) {
            accepted = attempt();
        }
    }

private:
    bool attempt() {
        A_.set_zero();
        A_.add(1.0 / (gamma_of_rodas * dt_), M_);
        A_.add(-1.0, J_);
        A_.factorise();
        const std::size_t n = T_.size();
        std::vector<Vector> u;
        Vector T = T_;
        Vector f = f_;
        Vector carried(n);
        for (int i = 0; i < n_stages; ++i) {
            if (i > 0) {
                T = T_;
                std::fill(carried.begin(), carried.end(), 0.0);
                for (int j = 0; j < i; ++j) {
                    for (std::size_t m = 0; m < n; ++m) {
                        T[m] += a[i][j] * u[static_cast<std::size_t>(j)][m];
                        carried[m] += c[i][j] / dt_ * u[static_cast<std::size_t>(j)][m];
                    }
                }
                elements_.heat(T, f, nullptr);
                Vector M_carried(n);
                M_.multiply(carried, M_carried);
                std::transform(f.begin(), f.end(), M_carried.begin(), f.begin(), std::plus<>{});
            }
            u.push_back(f);
            A_.solve(u.back());
        }
        // T now is the argument of the last stage; the step's end is that plus the last stage itself.
        double error = 0.0;
        for (std::size_t m = 0; m < n; ++m) {
            T[m] += u.back()[m];
            error = std::max(error, std::abs(u.back()[m]) / tolerance_);
        }
        const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-12), -0.25), 0.2, 5.0);
        const bool accepted = error <= 1.0;
        if (accepted) {
            time_ += dt_;
            T_ = std::move(T);
        }
        dt_ *= factor;
        return accepted;
    }

    const LaserElements& elements_;
    double tolerance_;
    BandMatrix M_;
    BandMatrix M_factor_;
    BandMatrix J_;
    BandMatrix A_;
    Vector T_;
    Vector f_;
    double time_ = 0.0;
    double dt_ = 1e-4;
};

/// The cubic through values and rates at both ends of a step, at a share s of it.
double hermite(double s, double dt, double y0, double rate0, double y1, double rate1) {
    const double rest = 1.0 - s;
    return rest * rest * (1.0 + 2.0 * s) * y0 + s * s * (3.0 - 2.0 * s) * y1 +
           s * rest * dt * (rest * rate0 - s * rate1);
}

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
    Rodas rodas(elements, specimen.start, resolution.tolerance);
    Vector T = rodas.temperature();
    Vector rate = rodas.rate();
    double from = 0.0;
    for (std::size_t next = 0; next < times.size();) {
        rodas.step();
        ++trace.n_steps;
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
    return trace;
}

}  // namespace hidden_effects
