// Every effect of the catalogue goes through the same identities.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "physics/bench.hpp"

namespace tiretherm::physics {

namespace {

/// Each effect on every bench where it can act.
class EveryEffect : public testing::TestWithParam<const Effect*> {
protected:
    [[nodiscard]] std::vector<Bench> benches() const {
        std::vector<Bench> result;
        for (Bench bench : {two_nodes(), specimen()}) {
            const bool has_place = GetParam()->patches.empty() || !activate(*GetParam(), bench.mesh).patches.empty();
            const bool has_tire = !GetParam()->needs_tire || bench.mesh.kind == "two_node";
            if (has_place && has_tire) {
                result.push_back(std::move(bench));
            }
        }
        return result;
    }

    /// The effect with values that make it speak: standard ones, a source where the standard is none.
    [[nodiscard]] ActiveEffect loud(const Bench& bench) const {
        ActiveEffect effect = bench.active(GetParam()->id);
        if (GetParam()->id == "uniform_source") {
            effect.parameters[0] = 1e5;
        }
        return effect;
    }
};

class EveryPassiveEffect : public EveryEffect {};
class EveryLoss : public EveryEffect {};

template <typename Predicate>
std::vector<const Effect*> effects_that(Predicate predicate) {
    std::vector<const Effect*> chosen;
    std::copy_if(catalogue().begin(), catalogue().end(), std::back_inserter(chosen), predicate);
    return chosen;
}

std::string id_of(const testing::TestParamInfo<const Effect*>& test) { return std::string(test.param->id); }

std::vector<double> random_field(std::size_t n, std::mt19937_64& random) {
    // The link's straight k(T) through 0.29 W/mK at 20 C turns negative at -10.8 C, which the terms report: see
    // Terms, SayWhichEffectGaveANegativeConductance.
    std::uniform_real_distribution<double> temperature(270.0, 420.0);
    std::vector<double> T(n);
    for (double& t : T) {
        t = temperature(random);
    }
    return T;
}

/// Heat flow into every node, faces included.
std::vector<double> flow(const Bench& bench, const Terms& terms, const std::vector<double>& T) {
    std::vector<double> q = terms.node_q;
    for (std::size_t f = 0; f < bench.mesh.faces.size(); ++f) {
        const auto a = static_cast<std::size_t>(bench.mesh.faces[f].a);
        const auto b = static_cast<std::size_t>(bench.mesh.faces[f].b);
        q[a] += terms.face_G[f] * (T[b] - T[a]);
        q[b] -= terms.face_G[f] * (T[b] - T[a]);
    }
    return q;
}

}  // namespace

TEST_P(EveryEffect, SaysWhatItIs) {
    const Effect& effect = *GetParam();
    EXPECT_FALSE(effect.equation.empty());
    EXPECT_FALSE(effect.source.empty());
    EXPECT_GT(effect.meaning.size(), 30U);
    std::set<std::string_view> keys;
    for (const Parameter& parameter : effect.parameters) {
        EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key << " is there twice";
        EXPECT_FALSE(parameter.unit.empty()) << parameter.key;
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.key;
        EXPECT_LE(parameter.low, parameter.standard) << parameter.key;
        EXPECT_GE(parameter.high, parameter.standard) << parameter.key;
    }
    for (const std::string_view name : effect.reads) {
        EXPECT_NE(find_signal(name), nullptr) << name;
    }
    ASSERT_FALSE(benches().empty()) << "no bench lets this effect act";
}

TEST_P(EveryEffect, IsFiniteWithConductancesThatAreNotNegative) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (const Bench& bench : benches()) {
        const ActiveEffect effect = loud(bench);
        for (int i = 0; i < 200; ++i) {
            // The envelope, its corners at rest and without load included.
            const Inputs in{.speed = i % 5 == 0 ? 0.0 : -20.0 + 120.0 * unit(random),
                            .vertical_load = i % 7 == 0 ? 0.0 : 12000.0 * unit(random),
                            .slip_angle = 0.5 * (unit(random) - 0.5),
                            .slip_ratio = unit(random) - 0.5,
                            .lateral_force = 12000.0 * (unit(random) - 0.5),
                            .longitudinal_force = 12000.0 * (unit(random) - 0.5),
                            .air_temperature = 230.0 + 100.0 * unit(random),
                            .road_temperature = 230.0 + 120.0 * unit(random),
                            .laser_power = 3.0 * unit(random)};
            const std::vector<double> T = random_field(bench.T.size(), random);
            const Terms terms = bench.said(effect, in, T);
            for (const double q : terms.node_q) {
                ASSERT_TRUE(std::isfinite(q));
            }
            for (const double G : terms.node_G) {
                ASSERT_GE(G, 0.0);
            }
            for (const double G : terms.face_G) {
                ASSERT_GE(G, 0.0);
            }
            ASSERT_LT(terms.negative_effect, 0);
        }
    }
}

TEST_P(EveryEffect, BooksExactlyTheWattsItGives) {
    std::mt19937_64 random(12);
    for (const Bench& bench : benches()) {
        const std::vector<double> T = random_field(bench.T.size(), random);
        const Terms terms = bench.said(loud(bench), rolling(), T);
        double given = 0.0;
        double turnover = 0.0;
        for (const double q : flow(bench, terms, T)) {
            given += q;
            turnover += std::abs(q);
        }
        EXPECT_NEAR(terms.watts[0], given, 1e-13 * turnover);
    }
}

TEST_P(EveryPassiveEffect, MovesNoHeatAtEquilibrium) {
    // Everything at the temperature of air and road.
    for (const Bench& bench : benches()) {
        const std::vector<double> T(bench.T.size(), 296.15);
        const Terms terms = bench.said(loud(bench), rolling(), T);
        for (const double q : flow(bench, terms, T)) {
            EXPECT_NEAR(q, 0.0, 1e-9);
        }
    }
}

TEST_P(EveryLoss, HeatsTowardsWarmerSurroundings) {
    for (const Bench& bench : benches()) {
        Inputs in = rolling();
        in.speed = 0.0;  // natural convection speaks only at rest
        in.air_temperature = in.road_temperature = 350.0;
        const std::vector<double> T(bench.T.size(), 300.0);
        EXPECT_GT(bench.said(loud(bench), in, T).watts[0], 0.0);
    }
}

TEST_P(EveryEffect, GivesTheDerivativesOfItsHeat) {
    // J v from the terms against a central difference of the flow in a random direction: second order in the step, so
    // 1e-3 K leaves 1e-6 relative of the curvature and 1e-9 of round-off.
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const Bench& bench : benches()) {
        const ActiveEffect effect = loud(bench);
        const std::vector<double> T = random_field(bench.T.size(), random);
        std::vector<double> v(T.size());
        for (double& component : v) {
            component = unit(random);
        }
        constexpr double step = 1e-3;
        std::vector<double> up = T;
        std::vector<double> down = T;
        for (std::size_t i = 0; i < T.size(); ++i) {
            up[i] += step * v[i];
            down[i] -= step * v[i];
        }
        const std::vector<double> q_up = flow(bench, bench.said(effect, rolling(), up), up);
        const std::vector<double> q_down = flow(bench, bench.said(effect, rolling(), down), down);
        const Terms terms = bench.said(effect, rolling(), T);
        std::vector<double> product(T.size());
        for (std::size_t i = 0; i < T.size(); ++i) {
            product[i] = (terms.node_slope[i] - terms.node_G[i]) * v[i];
        }
        for (std::size_t f = 0; f < bench.mesh.faces.size(); ++f) {
            const auto a = static_cast<std::size_t>(bench.mesh.faces[f].a);
            const auto b = static_cast<std::size_t>(bench.mesh.faces[f].b);
            const double change =
                terms.face_G[f] * (v[b] - v[a]) + terms.face_by_a[f] * v[a] + terms.face_by_b[f] * v[b];
            product[a] += change;
            product[b] -= change;
        }
        const std::vector<double> mean_v = bench.means(v);
        for (std::size_t r = 0; r < mean_v.size(); ++r) {
            for (std::size_t i = 0; i < T.size(); ++i) {
                product[i] += terms.region_slope[r * T.size() + i] * mean_v[r];
            }
        }
        double scale = 0.0;
        for (const double p : product) {
            scale = std::max(scale, std::abs(p));
        }
        for (std::size_t i = 0; i < T.size(); ++i) {
            EXPECT_NEAR(product[i], (q_up[i] - q_down[i]) / (2.0 * step), 2e-6 * scale + 1e-9) << "node " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEffect, testing::ValuesIn(catalogue().begin(), catalogue().end()), id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPassiveEffect,
                         testing::ValuesIn(effects_that([](const Effect* e) { return e->kind != Kind::source; })),
                         id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLoss,
                         testing::ValuesIn(effects_that([](const Effect* e) { return e->kind == Kind::loss; })), id_of);

TEST(Catalogue, HoldsTheThesisModelAsStandard) {
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"}) {
        ASSERT_NE(find_effect(id), nullptr) << id;
        EXPECT_TRUE(find_effect(id)->on) << id;
    }
    for (const char* id : {"laser", "still_air", "radiation", "natural_convection", "uniform_source"}) {
        ASSERT_NE(find_effect(id), nullptr) << id;
        EXPECT_FALSE(find_effect(id)->on) << id;
    }
    EXPECT_EQ(find_effect("phlogiston"), nullptr);
}

TEST(Catalogue, OrderOfEffectsDoesNotMatter) {
    // Two orders of the thesis's effects on one set of terms: the same sums but for the order of additions.
    const Bench bench = two_nodes();
    const std::vector<double> means = bench.means(bench.T);
    const Stock stock = bench.stock();
    const auto total = [&](std::vector<const char*> ids) {
        Terms terms(bench.mesh, ids.size());
        terms.begin(bench.T);
        for (std::size_t e = 0; e < ids.size(); ++e) {
            const ActiveEffect effect = bench.active(ids[e]);
            std::vector<double> intensities(static_cast<std::size_t>(effect.effect->n_intensities));
            if (effect.effect->drive != nullptr) {
                effect.effect->drive(effect, {.tire = bench.tire, .inputs = rolling(), .laws = {}}, intensities);
            }
            terms.book_to(e);
            effect.effect->speak({.mesh = bench.mesh,
                                  .stock = stock,
                                  .temperature = bench.T,
                                  .region_mean = means,
                                  .active = effect,
                                  .intensities = intensities},
                                 terms);
        }
        return flow(bench, terms, bench.T);
    };
    const std::vector<double> one =
        total({"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"});
    const std::vector<double> other =
        total({"road_contact", "air_convection", "conduction", "sliding_friction", "strain_energy_loss"});
    EXPECT_NEAR(one[0], other[0], 1e-10);
    EXPECT_NEAR(one[1], other[1], 1e-10);
}

}  // namespace tiretherm::physics
