// SPDX-License-Identifier: BSD-3-Clause
// Two peers in one program, for the comparison alone; it shares no source with tiretherm. A block of graded cells with
// k(T) by layers, by finite volumes, integrated in time by
//   cvode  SUNDIALS CVODE: BDF, GMRES, preconditioned by the tridiagonal systems through the thickness
//   sdirk  a compact solver: SDIRK of order 2 with growing steps, conjugate gradients with incomplete Cholesky of order 0
// Call: peer_blocks METHOD PROBLEM [accuracy [finer]]; prints one line per moment and probe.
// accuracy: of cvode the relative tolerance, of sdirk the number of steps; finer: slab's cells along each edge, as a factor.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>

namespace {

using Vector = std::vector<double>;

constexpr double air = 23.0;  // degC
constexpr double heat_per_volume = 1100.0 * 1800.0;
constexpr double spot_radius = 5.6419e-3;
constexpr double quarter_watt = 0.25;

/// Edges from `from` to `to`: the last cell `ratio` times as wide as the first.
void add_edges(Vector& edges, double to, int cells, double ratio) {
    const double growth = cells > 1 ? std::pow(ratio, 1.0 / (cells - 1)) : 1.0;
    double sum = 0.0;
    for (int i = 0; i < cells; ++i) {
        sum += std::pow(growth, i);
    }
    const double from = edges.back();
    double width = (to - from) / sum;
    for (int i = 0; i < cells; ++i, width *= growth) {
        edges.push_back(edges.back() + width);
    }
    edges.back() = to;
}

struct Problem {
    Vector x{0.0}, y{0.0}, z{0.0};
    double k_top[2] = {0.0, 0.0};  // k = k[0] + k[1] (T - 20 degC), above `interface`
    double k_bulk[2] = {0.0, 0.0};
    double interface = 0.0;
    double h_top = 0.0, h_bottom = 0.0, h_side = 0.0;  // side: both ends of x
    double source = 0.0;                               // W/m3
    bool laser = false;
    Vector moments;
};

Problem slab(bool nonlinear, double finer) {
    const auto cells = [&](int n) { return static_cast<int>(std::lround(finer * n)); };
    Problem p;
    for (Vector* side : {&p.x, &p.y}) {
        add_edges(*side, 7.5e-3, cells(5), 1.0);
        add_edges(*side, 30e-3, cells(11), 3.0);
    }
    add_edges(p.z, 3e-3, cells(8), 4.2);
    add_edges(p.z, 15e-3, cells(50), 0.8);
    p.interface = 3e-3;
    const double slope = nonlinear ? 1.0 : 0.0;
    p.k_top[0] = nonlinear ? 0.29 : 0.478;
    p.k_top[1] = 0.0094 * slope;
    p.k_bulk[0] = nonlinear ? 0.060 : 0.064;
    p.k_bulk[1] = 0.0002 * slope;
    p.h_top = p.h_bottom = 10.0;
    p.laser = true;
    p.moments = {10.0, 60.0, 300.0, 600.0};
    return p;
}

Problem section() {
    Problem p;
    add_edges(p.x, 0.225, 450, 1.0);
    add_edges(p.y, 1.0, 1, 1.0);
    add_edges(p.z, 0.015, 60, 1.0);
    p.interface = 1.0;
    p.k_top[0] = p.k_bulk[0] = 0.25;
    p.h_top = 60.0;
    p.h_bottom = 10.0;
    p.h_side = 20.0;
    p.source = 1e5;
    p.moments = {60.0, 300.0, 600.0, 1200.0};
    return p;
}

/// Finite volumes: z runs fastest, so that the strong coupling is next to the diagonal.
class Block {
public:
    explicit Block(const Problem& problem)
        : p(problem),
          nx(size(p.x)),
          ny(size(p.y)),
          nz(size(p.z)),
          n(nx * ny * nz),
          C(n),
          heat(n, 0.0),
          spot(nx * ny, 0.0),
          k(n),
          Gx(n),
          Gy(n),
          Gz(n),
          out(n) {
        for (int i = 0; i < nx; ++i) {
            for (int j = 0; j < ny; ++j) {
                for (int m = 0; m < nz; ++m) {
                    const double volume = width(p.x, i) * width(p.y, j) * width(p.z, m);
                    C[at(i, j, m)] = heat_per_volume * volume;
                    heat[at(i, j, m)] = p.source * volume;
                }
            }
        }
        if (p.laser) {
            light();
        }
    }

    /// Conductances of the three faces beyond each cell, and to the air, W/K.
    void conduct(const double* T) {
        for (int i = 0; i < nx; ++i) {
            for (int j = 0; j < ny; ++j) {
                for (int m = 0; m < nz; ++m) {
                    const double* law = middle(p.z, m) < p.interface ? p.k_top : p.k_bulk;
                    k[at(i, j, m)] = law[0] + law[1] * (T[at(i, j, m)] - 20.0);
                }
            }
        }
        for (int i = 0; i < nx; ++i) {
            for (int j = 0; j < ny; ++j) {
                for (int m = 0; m < nz; ++m) {
                    const int c = at(i, j, m);
                    const double dx = width(p.x, i), dy = width(p.y, j), dz = width(p.z, m);
                    Gx[c] = i + 1 < nx ? 2.0 * dy * dz / (dx / k[c] + width(p.x, i + 1) / k[c + ny * nz]) : 0.0;
                    Gy[c] = j + 1 < ny ? 2.0 * dx * dz / (dy / k[c] + width(p.y, j + 1) / k[c + nz]) : 0.0;
                    Gz[c] = m + 1 < nz ? 2.0 * dx * dy / (dz / k[c] + width(p.z, m + 1) / k[c + 1]) : 0.0;
                    double G = 0.0;
                    if (m == 0) {
                        G += dx * dy / (1.0 / p.h_top + 0.5 * dz / k[c]);
                    }
                    if (m == nz - 1) {
                        G += dx * dy / (1.0 / p.h_bottom + 0.5 * dz / k[c]);
                    }
                    if (p.h_side > 0.0 && (i == 0 || i == nx - 1)) {
                        G += dy * dz / (1.0 / p.h_side + 0.5 * dx / k[c]);
                    }
                    out[c] = G;
                }
            }
        }
    }

    /// Heat into each cell at the last conductances, W.
    void flow(const double* T, double* q) const {
        for (int c = 0; c < n; ++c) {
            q[c] = heat[c] + out[c] * (air - T[c]);
        }
        for (int ij = 0; p.laser && ij < nx * ny;
             ++ij) {  // the film and the light stand for an air that is warmer by q/h
            q[ij * nz] += spot[ij] / p.h_top * out[ij * nz];
        }
        for (int c = 0; c < n; ++c) {
            pass(c, c + ny * nz, Gx[c], T, q);
            pass(c, c + nz, Gy[c], T, q);
            pass(c, c + 1, Gz[c], T, q);
        }
    }

    /// The temperature of the top (m = 0) or bottom surface over a column.
    [[nodiscard]] double surface(const double* T, int i, int j, bool top) const {
        const int c = at(i, j, top ? 0 : nz - 1);
        const double to_cell = 2.0 * k[c] / width(p.z, top ? 0 : nz - 1);
        const double h = top ? p.h_top : p.h_bottom;
        const double light = top && p.laser ? spot[i * ny + j] : 0.0;
        return (h * air + light + to_cell * T[c]) / (h + to_cell);
    }

    /// A field over the columns on the axis of symmetry: a parabola through the first two centres, both ways.
    [[nodiscard]] double on_axis(const std::function<double(int, int)>& value) const {
        const auto even = [](const Vector& edges, double a, double b) {
            const double s0 = middle(edges, 0), s1 = middle(edges, 1);
            return a + (a - b) * s0 * s0 / (s1 * s1 - s0 * s0);
        };
        return even(p.x, even(p.y, value(0, 0), value(0, 1)), even(p.y, value(1, 0), value(1, 1)));
    }

    void print(double t, const double* T) {
        conduct(T);
        if (p.laser) {
            for (const bool top : {true, false}) {
                std::printf("%g %s %.6f\n", t, top ? "top" : "bottom",
                            on_axis([&](int i, int j) { return surface(T, i, j, top); }));
            }
            return;
        }
        const int i = nx / 2;  // 225 mm are an even number of cells: the middle lies between two
        std::printf("%g top %.6f\n", t, 0.5 * (surface(T, i, 0, true) + surface(T, i - 1, 0, true)));
        std::printf("%g bottom %.6f\n", t, 0.5 * (surface(T, i, 0, false) + surface(T, i - 1, 0, false)));
        double centre = 0.0;
        for (const int c : {at(i, 0, nz / 2), at(i - 1, 0, nz / 2), at(i, 0, nz / 2 - 1), at(i - 1, 0, nz / 2 - 1)}) {
            centre += 0.25 * T[c];
        }
        std::printf("%g centre %.6f\n", t, centre);
    }

    [[nodiscard]] int at(int i, int j, int m) const { return (i * ny + j) * nz + m; }
    static int size(const Vector& edges) { return static_cast<int>(edges.size()) - 1; }
    static double width(const Vector& edges, int i) { return edges[i + 1] - edges[i]; }
    static double middle(const Vector& edges, int i) { return 0.5 * (edges[i] + edges[i + 1]); }

    Problem p;
    int nx, ny, nz, n;
    Vector C, heat, spot;  // J/K, W, W/m2
    Vector k, Gx, Gy, Gz, out;

private:
    static void pass(int a, int b, double G, const double* T, double* q) {
        if (G != 0.0) {
            const double flux = G * (T[b] - T[a]);
            q[a] += flux;
            q[b] -= flux;
        }
    }

    /// The disc's share of each face of the top, by 64 x 64 points a face.
    void light() {
        double lit = 0.0;
        for (int i = 0; i < nx; ++i) {
            for (int j = 0; j < ny; ++j) {
                int inside = 0;
                for (int a = 0; a < 64; ++a) {
                    for (int b = 0; b < 64; ++b) {
                        const double x = p.x[i] + (a + 0.5) / 64 * width(p.x, i),
                                     y = p.y[j] + (b + 0.5) / 64 * width(p.y, j);
                        inside += x * x + y * y < spot_radius * spot_radius ? 1 : 0;
                    }
                }
                spot[i * ny + j] = inside / 4096.0;
                lit += spot[i * ny + j] * width(p.x, i) * width(p.y, j);
            }
        }
        for (double& share : spot) {
            share *= quarter_watt / lit;
        }
    }
};

// ---------------------------------------------------------------------------------------------------------- sdirk

/// (C + s K) x = b by conjugate gradients with incomplete Cholesky of order 0, which on such a mesh changes the diagonal alone.
class Solver {
public:
    explicit Solver(const Block& block)
        : b_(block), pivot_(block.n), diagonal_(block.n), r_(block.n), z_(block.n), p_(block.n), w_(block.n) {}

    void prepare(double s) {
        s_ = s;
        const int ox = b_.ny * b_.nz, oy = b_.nz;
        for (int c = 0; c < b_.n; ++c) {
            diagonal_[c] = b_.C[c] + s * (b_.out[c] + b_.Gx[c] + b_.Gy[c] + b_.Gz[c]);
            if (c >= ox) diagonal_[c] += s * b_.Gx[c - ox];
            if (c >= oy) diagonal_[c] += s * b_.Gy[c - oy];
            if (c >= 1) diagonal_[c] += s * b_.Gz[c - 1];
            double d = diagonal_[c];
            if (c >= ox) d -= square(s * b_.Gx[c - ox]) / pivot_[c - ox];
            if (c >= oy) d -= square(s * b_.Gy[c - oy]) / pivot_[c - oy];
            if (c >= 1) d -= square(s * b_.Gz[c - 1]) / pivot_[c - 1];
            pivot_[c] = d;
        }
    }

    /// Until the largest residual over its diagonal is below the tolerance. K
    void solve(const Vector& right, Vector& x, double tolerance) {
        std::fill(x.begin(), x.end(), 0.0);
        r_ = right;
        precondition();
        p_ = z_;
        double rz = dot(r_, z_);
        for (int iteration = 0; iteration < 500; ++iteration) {
            double worst = 0.0;
            for (int c = 0; c < b_.n; ++c) {
                worst = std::max(worst, std::abs(r_[c]) / diagonal_[c]);
            }
            if (worst < tolerance) {
                return;
            }
            multiply();
            const double step = rz / dot(p_, w_);
            for (int c = 0; c < b_.n; ++c) {
                x[c] += step * p_[c];
                r_[c] -= step * w_[c];
            }
            precondition();
            const double next = dot(r_, z_), share = next / rz;
            rz = next;
            for (int c = 0; c < b_.n; ++c) {
                p_[c] = z_[c] + share * p_[c];
            }
        }
    }

private:
    static double square(double v) { return v * v; }
    static double dot(const Vector& a, const Vector& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            sum += a[i] * b[i];
        }
        return sum;
    }
    void multiply() {
        const int ox = b_.ny * b_.nz, oy = b_.nz;
        for (int c = 0; c < b_.n; ++c) {
            double sum = diagonal_[c] * p_[c];
            if (c >= ox) sum -= s_ * b_.Gx[c - ox] * p_[c - ox];
            if (c >= oy) sum -= s_ * b_.Gy[c - oy] * p_[c - oy];
            if (c >= 1) sum -= s_ * b_.Gz[c - 1] * p_[c - 1];
            if (c + ox < b_.n) sum -= s_ * b_.Gx[c] * p_[c + ox];
            if (c + oy < b_.n) sum -= s_ * b_.Gy[c] * p_[c + oy];
            if (c + 1 < b_.n) sum -= s_ * b_.Gz[c] * p_[c + 1];
            w_[c] = sum;
        }
    }
    void precondition() {
        const int ox = b_.ny * b_.nz, oy = b_.nz;
        for (int c = 0; c < b_.n; ++c) {
            double sum = r_[c];
            if (c >= ox) sum += s_ * b_.Gx[c - ox] * z_[c - ox];
            if (c >= oy) sum += s_ * b_.Gy[c - oy] * z_[c - oy];
            if (c >= 1) sum += s_ * b_.Gz[c - 1] * z_[c - 1];
            z_[c] = sum / pivot_[c];
        }
        for (int c = b_.n - 1; c >= 0; --c) {
            double sum = 0.0;
            if (c + ox < b_.n) sum += s_ * b_.Gx[c] * z_[c + ox];
            if (c + oy < b_.n) sum += s_ * b_.Gy[c] * z_[c + oy];
            if (c + 1 < b_.n) sum += s_ * b_.Gz[c] * z_[c + 1];
            z_[c] += sum / pivot_[c];
        }
    }

    const Block& b_;
    double s_ = 0.0;
    Vector pivot_, diagonal_, r_, z_, p_, w_;
};

/// SDIRK of order 2 (Alexander 1977), gamma = 1 - 1/sqrt(2), L-stable; steps that grow by a factor between two moments.
void sdirk(Block& block, int steps) {
    const double gamma = 1.0 - std::sqrt(0.5), newton = 2e-3;
    const bool nonlinear = block.p.k_top[1] != 0.0;
    const double end = block.p.moments.back(), growth = std::pow(300.0, 1.0 / steps);
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        sum += std::pow(growth, i);
    }
    double dt = end / sum, t = 0.0;
    Vector T(block.n, air), stage(block.n), q1(block.n), q(block.n), right(block.n), change(block.n);
    Solver solver(block);
    for (double moment : block.p.moments) {
        while (t < moment - 1e-9) {
            const double left = moment - t;
            const double h = left < 1.5 * dt ? left : left < 3.0 * dt ? 0.5 * left : dt;
            for (int s = 0; s < 2; ++s) {
                stage = s == 0 ? T : stage;
                const double from_first = s == 0 ? 0.0 : (1.0 - gamma) * h;
                for (int iteration = 0; iteration < 8; ++iteration) {
                    block.conduct(stage.data());
                    block.flow(stage.data(), q.data());
                    for (int c = 0; c < block.n; ++c) {
                        right[c] = block.C[c] * (T[c] - stage[c]) + from_first * q1[c] + gamma * h * q[c];
                    }
                    solver.prepare(gamma * h);
                    solver.solve(right, change, 0.1 * newton);
                    double largest = 0.0;
                    for (int c = 0; c < block.n; ++c) {
                        stage[c] += change[c];
                        largest = std::max(largest, std::abs(change[c]));
                    }
                    if (!nonlinear || largest < 10.0 * newton) {
                        break;
                    }
                }
                if (s == 0) {
                    block.conduct(stage.data());
                    block.flow(stage.data(), q1.data());
                }
            }
            T = stage;
            t += h;
            dt *= growth;
        }
        t = moment;
        block.print(t, T.data());
    }
}

// ---------------------------------------------------------------------------------------------------------- cvode

/// The tridiagonal systems through the thickness: (1 - gamma dq_z/dT / C).
struct Lines {
    Block* block;
    Vector lower, pivot;
};

int rate(double, N_Vector y, N_Vector dy, void* data) {
    Block& block = *static_cast<Lines*>(data)->block;
    block.conduct(N_VGetArrayPointer(y));
    double* q = N_VGetArrayPointer(dy);
    block.flow(N_VGetArrayPointer(y), q);
    for (int c = 0; c < block.n; ++c) {
        q[c] /= block.C[c];
    }
    return 0;
}

int factor_lines(double, N_Vector y, N_Vector, int, int* fresh, double gamma, void* data) {
    Lines& lines = *static_cast<Lines*>(data);
    Block& b = *lines.block;
    b.conduct(N_VGetArrayPointer(y));
    const int ox = b.ny * b.nz, oy = b.nz;
    for (int c = 0; c < b.n; ++c) {
        double sum = b.out[c] + b.Gx[c] + b.Gy[c] + b.Gz[c];
        sum += (c >= ox ? b.Gx[c - ox] : 0.0) + (c >= oy ? b.Gy[c - oy] : 0.0) + (c >= 1 ? b.Gz[c - 1] : 0.0);
        double pivot = b.C[c] + gamma * sum;
        lines.lower[c] = 0.0;
        if (c >= 1 && b.Gz[c - 1] != 0.0) {
            lines.lower[c] = gamma * b.Gz[c - 1] / lines.pivot[c - 1];
            pivot -= lines.lower[c] * gamma * b.Gz[c - 1];
        }
        lines.pivot[c] = pivot;
    }
    *fresh = 1;
    return 0;
}

int solve_lines(double, N_Vector, N_Vector, N_Vector right, N_Vector result, double gamma, double, int, void* data) {
    const Lines& lines = *static_cast<Lines*>(data);
    const Block& b = *lines.block;
    const double* r = N_VGetArrayPointer(right);
    double* z = N_VGetArrayPointer(result);
    for (int c = 0; c < b.n; ++c) {
        z[c] = b.C[c] * r[c] + (c >= 1 ? lines.lower[c] * z[c - 1] : 0.0);
    }
    for (int c = b.n - 1; c >= 0; --c) {
        z[c] = (z[c] + (c + 1 < b.n ? gamma * b.Gz[c] * z[c + 1] : 0.0)) / lines.pivot[c];
    }
    return 0;
}

int cvode(Block& block, double relative) {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    N_Vector y = N_VNew_Serial(block.n, context);
    N_VConst(air, y);
    Lines lines{&block, Vector(block.n), Vector(block.n)};
    void* memory = CVodeCreate(CV_BDF, context);
    CVodeInit(memory, rate, 0.0, y);
    CVodeSStolerances(memory, relative, 50.0 * relative);
    CVodeSetUserData(memory, &lines);
    CVodeSetMaxNumSteps(memory, 100000);
    SUNLinearSolver gmres = SUNLinSol_SPGMR(y, SUN_PREC_LEFT, 20, context);
    CVodeSetLinearSolver(memory, gmres, nullptr);
    CVodeSetPreconditioner(memory, factor_lines, solve_lines);
    double t = 0.0;
    for (const double moment : block.p.moments) {
        if (CVode(memory, moment, y, &t, CV_NORMAL) < 0) {
            return 1;
        }
        block.print(t, N_VGetArrayPointer(y));
    }
    CVodeFree(&memory);
    SUNLinSolFree(gmres);
    N_VDestroy(y);
    SUNContext_Free(&context);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "peer_blocks cvode|sdirk slab_linear|slab_nonlinear|section [accuracy [finer]]\n");
        return 1;
    }
    const std::string method = argv[1], which = argv[2];
    Block block(which == "section" ? section() : slab(which == "slab_nonlinear", argc > 4 ? std::atof(argv[4]) : 1.0));
    if (method == "cvode") {
        return cvode(block, argc > 3 ? std::atof(argv[3]) : 5e-4);
    }
    sdirk(block, argc > 3 ? std::atoi(argv[3]) : 34);
    return 0;
}
