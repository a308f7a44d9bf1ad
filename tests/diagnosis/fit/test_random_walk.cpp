// SPDX-License-Identifier: BSD-3-Clause
// Heat in many windows of time estimated together: exact where it is constant, with intervals that hold what was made up.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "diagnosis/fit/random_walk.hpp"

namespace tiretherm::diagnosis {

namespace {

/// A lump that loses its heat slowly, read after each of ten parts of a window in white noise of one unit.
struct SlowLump {
    static constexpr Eigen::Index windows = 40;
    static constexpr Eigen::Index parts = 10;
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(windows * parts, windows);

    /// @param kept of the temperature from one reading to the next  @param rise units per watt and reading
    SlowLump(double kept, double rise) {
        for (Eigen::Index w = 0; w < windows; ++w) {
            double T = 0.0;
            for (Eigen::Index i = 0; i < columns.rows(); ++i) {
                T = kept * T + (i / parts == w ? rise : 0.0);
                columns(i, w) = T;
            }
        }
    }
    [[nodiscard]] Eigen::MatrixXd normal() const { return columns.transpose() * columns; }
    [[nodiscard]] WalkEstimate estimate(const Eigen::VectorXd& watts, std::mt19937_64& engine) const {
        std::normal_distribution<double> normal_noise;
        Eigen::VectorXd read = columns * watts;
        for (double& one : read) {
            one += normal_noise(engine);
        }
        return estimate_walks(normal(), columns.transpose() * read, {{.first = 0, .count = windows, .interval = 60.0}});
    }
};

/// Of windows in sets of data with noise of their own: whose interval holds the truth; beyond three standard deviations.
struct Held {
    double within = 0.0;
    double far_off = 0.0;
};
template <typename Truth>
Held held(const SlowLump& lump, const Truth& truth, int sets) {
    Held shares;
    std::mt19937_64 engine(7);
    for (int set = 0; set < sets; ++set) {
        const Eigen::VectorXd watts = truth(engine);
        const WalkEstimate found = lump.estimate(watts, engine);
        const Eigen::ArrayXd off = ((found.value - watts).array() / found.deviation.array()).abs();
        shares.within += (off < 1.96).cast<double>().mean() / sets;
        shares.far_off += (off > 3.0).cast<double>().mean() / sets;
    }
    return shares;
}

Eigen::VectorXd constant(double watts) { return Eigen::VectorXd::Constant(SlowLump::windows, watts); }

}  // namespace

// Every number is read once in noise of one unit, all of a walk alike: no step pulls, so that each walk is its level. Its standard
// deviation is 1/sqrt(3) without steps and 1 where steps are free.
TEST(RandomWalk, OfEqualReadingsIsTheirLevel) {
    Eigen::VectorXd read(6);
    read << 5.0, 5.0, 5.0, -2.0, -2.0, -2.0;
    const WalkEstimate found =
        estimate_walks(Eigen::MatrixXd::Identity(6, 6), read, {{.first = 0, .count = 3}, {.first = 3, .count = 3}});
    for (Eigen::Index i = 0; i < 6; ++i) {
        EXPECT_NEAR(found.value[i], read[i], 1e-7);
        EXPECT_GT(found.deviation[i], 1.0 / std::sqrt(3.0) - 1e-9);
        EXPECT_LT(found.deviation[i], 1.0);
    }
}

// A walk of one number is that number: 12 of 4 readings' worth is 3 +- 1/2.
TEST(RandomWalk, OfOneNumberIsLeastSquares) {
    const WalkEstimate found = estimate_walks(Eigen::MatrixXd::Constant(1, 1, 4.0), Eigen::VectorXd::Constant(1, 12.0),
                                              {{.first = 0, .count = 1}});
    EXPECT_NEAR(found.value[0], 3.0, 1e-6);
    EXPECT_NEAR(found.deviation[0], 0.5, 1e-6);
}

// 78 W throughout into a lump that keeps everything. A window fitted alone has to make up all others: heat in window w raises every
// reading after it by as much as a window's, while the truth has raised them by that of all windows before, of which there are
// (w + 41)/2 in the mean over these readings: 78 W are more than 20 times as many. Together they are 78 W each.
TEST(RandomWalk, ASlowStateDoesNotAddUpIntoEachWindow) {
    const SlowLump lump(1.0, 0.02);
    std::mt19937_64 engine(1);
    const WalkEstimate found = lump.estimate(constant(78.0), engine);
    const Eigen::MatrixXd normal = lump.normal();
    const Eigen::VectorXd right = normal * constant(78.0);
    for (Eigen::Index w = 0; w < SlowLump::windows; ++w) {
        EXPECT_GT(right[w] / normal(w, w), 20.0 * 78.0) << w;
        EXPECT_NEAR(found.value[w], 78.0, 1.96 * found.deviation[w]) << w;
        EXPECT_LT(found.deviation[w], 4.0) << w;
    }
}

// 95 of 100 is what the intervals promise. Of 40 windows in 60 sets the share is known to 1 % as neighbours go together; a truth that
// is no random walk may cost some per cent more.
TEST(RandomWalk, IntervalsHoldWhatWasMadeUp) {
    const SlowLump lump(0.98, 0.05);
    const auto walk = [](std::mt19937_64& engine) {
        std::normal_distribution<double> step(0.0, 20.0);
        Eigen::VectorXd watts(SlowLump::windows);
        double sum = 0.0;
        for (double& one : watts) {
            one = sum += step(engine);
        }
        return watts;
    };
    const auto pulse = [](std::mt19937_64&) {
        Eigen::VectorXd watts = constant(0.0);
        watts.segment(20, 4).setConstant(200.0);
        return watts;
    };
    const auto step = [](std::mt19937_64&) {
        Eigen::VectorXd watts = constant(0.0);
        watts.tail(24).setConstant(100.0);
        return watts;
    };
    const Held of_walk = held(lump, walk, 60);
    EXPECT_GT(of_walk.within, 0.93);
    EXPECT_LT(of_walk.within, 0.99);  // not wider than they must be
    EXPECT_LT(of_walk.far_off, 0.01);
    EXPECT_GT(held(lump, pulse, 60).within, 0.91);
    EXPECT_GT(held(lump, step, 60).within, 0.91);
}

// Without heat every interval should hold none: 95 % and more, as an unknown step widens them; three standard deviations never.
TEST(RandomWalk, WhereNothingIsMissingIntervalsHoldNone) {
    const Held nothing = held(
        SlowLump(0.98, 0.05), [](std::mt19937_64&) { return constant(0.0); }, 100);
    EXPECT_GT(nothing.within, 0.97);
    EXPECT_LT(nothing.far_off, 1e-3);
}

}  // namespace tiretherm::diagnosis
