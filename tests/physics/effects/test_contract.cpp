// SPDX-License-Identifier: BSD-3-Clause
// Every effect of the catalogue goes through the same identities, alone and beside the thesis's effects.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "physics/effects/effect_contract.hpp"

namespace tiretherm::physics {

TEST_P(EveryEffect, SaysWhatItIs) {
    const Effect& effect = *GetParam();
    // What a diagnosis may find is in the equation under its own name, so that a reader of a result finds its place there,
    // or by a usual symbol.
    static const std::map<std::string_view, std::string_view> symbols{
        {"radiation", "eps"}, {"camera_emissivity", "e"}, {"wet_road", "d"}};
    for (const ParameterSpec& parameter : effect.parameters) {
        if (!std::isnan(parameter.absent)) {
            const auto usual = symbols.find(effect.id);
            const std::string symbol(usual == symbols.end() ? parameter.key : usual->second);
            EXPECT_TRUE(std::regex_search(std::string(effect.equation), std::regex("\\b" + symbol + "\\b")))
                << symbol << " is not in: " << effect.equation;
        }
    }
    // The thesis's model says which of its equations (31) to (49) it is.
    if (effect.on) {
        EXPECT_TRUE(std::regex_search(std::string(effect.source), std::regex("thesis \\((3[1-9]|4[0-9])\\)")))
            << effect.source;
    }
    EXPECT_FALSE(effect.source.empty());
    EXPECT_GE(effect.valid.size(), 10U) << "the range in which it holds";
    std::set<std::string_view> keys;
    for (const ParameterSpec& parameter : effect.parameters) {
        EXPECT_TRUE(keys.insert(parameter.key).second) << parameter.key << " is there twice";
        EXPECT_FALSE(parameter.unit.empty()) << parameter.key;
        EXPECT_FALSE(parameter.meaning.empty()) << parameter.key;
        EXPECT_LE(parameter.low, parameter.standard) << parameter.key;
        EXPECT_GE(parameter.high, parameter.standard) << parameter.key;
        if (!std::isnan(parameter.absent)) {
            EXPECT_LE(parameter.low, parameter.absent) << parameter.key;
            EXPECT_GE(parameter.high, parameter.absent) << parameter.key;
        }
    }
    for (const auto& names : {effect.reads, effect.may_read}) {
        for (const std::string_view name : names) {
            EXPECT_NE(find_signal(name), nullptr) << name;
        }
    }
    EXPECT_EQ(effect.sensor_model() != nullptr, effect.kind == EffectKind::sensor);
    ASSERT_FALSE(benches().empty()) << "no bench lets this effect act";
}

TEST_P(EveryEffect, HasTheFunctionsOfItsClass) {
    const Effect& effect = *GetParam();
    if (const HeatEffect* heat = effect.heat_effect()) {
        EXPECT_NE(heat->add_terms, nullptr);
        EXPECT_EQ(heat->n_coefficients > 0, heat->evaluate_coefficients != nullptr);
        EXPECT_EQ(heat->extend == nullptr, heat->capacity == nullptr);
        EXPECT_TRUE(heat->scale_loss == nullptr || heat->extend != nullptr) << "a law without a node of its own";
    } else if (const PropertyModifier* modifier = effect.property_modifier()) {
        EXPECT_TRUE(modifier->modify_properties != nullptr || modifier->modify_laws != nullptr ||
                    modifier->scale_loss != nullptr);
    } else if (const InputCorrection* correction = effect.input_correction()) {
        EXPECT_TRUE(correction->transform != nullptr || correction->start != nullptr || correction->delay != nullptr);
    } else {
        const SensorModel& model = *effect.sensor_model();
        EXPECT_TRUE(model.read != nullptr || model.lag != nullptr || model.delay != nullptr ||
                    model.clock_rate != nullptr || model.depth_offset != nullptr);
    }
}

TEST_P(EveryEffect, IsFiniteWithConductancesThatAreNotNegative) {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (Bench bench : benches()) {
        if (!bench.link_laws.empty()) {
            // The straight k(T) through 0.29 W/mK at 20 C turns negative at -10.8 C, which the terms report: see
            // Terms, SayWhichEffectGaveANegativeConductance.
            bench.link_laws = {Curve::constant(0.29)};
        }
        Whole whole(bench, with(thesis(bench), part()));
        for (int i = 0; i < 200; ++i) {
            // The envelope, its corners at rest and without load included.
            const Inputs in{.time = 3600.0 * unit(random),
                            .speed = i % 5 == 0 ? 0.0 : -20.0 + 120.0 * unit(random),
                            .vertical_load = i % 7 == 0 ? 0.0 : 12000.0 * unit(random),
                            .slip_angle = 0.5 * (unit(random) - 0.5),
                            .slip_ratio = unit(random) - 0.5,
                            .lateral_force = 12000.0 * (unit(random) - 0.5),
                            .longitudinal_force = 12000.0 * (unit(random) - 0.5),
                            .camber = 0.3 * (unit(random) - 0.5),
                            .inflation_pressure = 5e5 * unit(random),
                            .air_temperature = 230.0 + 100.0 * unit(random),
                            .road_temperature = 230.0 + 120.0 * unit(random),
                            .wet = i % 2 == 0 ? 1.0 : 0.0,
                            .laser_power = 3.0 * unit(random),
                            .wheel_angle = 1e3 * (unit(random) - 0.5)};
            whole.ask(in, random_field(n_nodes(whole), random, 250.0, 450.0));
            const Terms& terms = whole.system().terms();
            for (const double q : whole.system().heat_flow()) {
                ASSERT_TRUE(std::isfinite(q));
            }
            for (const std::vector<double>* G : {&terms.node_G, &terms.face_G}) {
                ASSERT_GE(*std::min_element(G->begin(), G->end()), 0.0);
            }
            ASSERT_LT(terms.negative_effect, 0);
            for (const ActiveEffect& active : whole.system().effects()) {
                if (const SensorModel* model = active.effect->sensor_model();
                    model != nullptr && model->read != nullptr) {
                    ASSERT_TRUE(std::isfinite(model->read(active, 0, 250.0 + 200.0 * unit(random), in)));
                }
            }
        }
    }
}

TEST_P(EveryEffect, BooksExactlyTheWattsItGives) {
    std::mt19937_64 random(12);
    for (const Bench& bench : benches()) {
        for (const std::vector<Part>& parts : {std::vector{part()}, with(thesis(bench), part())}) {
            Whole whole(bench, parts);
            whole.ask(lively(), random_field(n_nodes(whole), random));
            const double given = whole.system().of_budget(whole.system().heat_flow());
            double turnover = 0.0;
            for (const double q : whole.system().heat_flow()) {
                turnover += std::abs(q);
            }
            double attributed = 0.0;
            for (const double watts : whole.system().terms().watts) {
                attributed += watts;
            }
            EXPECT_NEAR(attributed, given, 1e-13 * turnover);
        }
    }
}

TEST_P(EveryPassiveEffect, MovesNoHeatAtEquilibrium) {
    // Everything at the temperature of air and road.
    for (const Bench& bench : benches()) {
        Whole whole(bench, {part()});
        Inputs in = lively();
        in.time = 0.0;
        in.laser_power = 0.0;
        whole.ask(in, std::vector<double>(n_nodes(whole), 296.15));
        for (const double q : whole.system().heat_flow()) {
            EXPECT_NEAR(q, 0.0, 1e-9);
        }
    }
}

TEST_P(EveryLoss, HeatsTowardsWarmerSurroundings) {
    for (const Bench& bench : benches()) {
        Whole whole(bench, with(thesis(bench), part()));
        const std::vector<double> T(n_nodes(whole), 300.0);
        Inputs in = lively();
        in.air_temperature = in.road_temperature = 350.0;
        double watts = whole.ask(in, T).watts(GetParam()->id);
        in.speed = 0.0;  // natural convection acts only at rest
        watts = std::max(watts, whole.ask(in, T).watts(GetParam()->id));
        EXPECT_GT(watts, 0.0);
    }
}

TEST_P(EveryEffect, GivesTheDerivativesOfItsHeat) {
    // J v from the terms against a central difference of the flow in a random direction: second order in the step, so
    // 1e-3 K leaves 1e-6 relative of the curvature and 1e-9 of round-off.
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (const Bench& bench : benches()) {
        Whole whole(bench, with(thesis(bench), part()));
        const mesh::Mesh& mesh = whole.problem().mesh;
        const std::vector<double> T = random_field(n_nodes(whole), random);
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
        const auto flow = [&](const std::vector<double>& at) {
            const std::span<const double> q = whole.ask(lively(), at).system().heat_flow();
            return std::vector<double>(q.begin(), q.end());
        };
        const std::vector<double> q_up = flow(up);
        const std::vector<double> q_down = flow(down);
        const Terms& terms = whole.ask(lively(), T).system().terms();
        std::vector<double> product(T.size());
        for (std::size_t i = 0; i < T.size(); ++i) {
            product[i] = (terms.node_slope[i] - terms.node_G[i]) * v[i];
        }
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            const auto a = static_cast<std::size_t>(mesh.faces[f].a);
            const auto b = static_cast<std::size_t>(mesh.faces[f].b);
            const double change =
                terms.face_G[f] * (v[b] - v[a]) + terms.face_dq_dTa[f] * v[a] + terms.face_dq_dTb[f] * v[b];
            product[a] += change;
            product[b] -= change;
        }
        for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
            const double mean_v = mesh.regions[r].mean(v);
            for (std::size_t i = 0; i < T.size(); ++i) {
                product[i] += terms.region_slope[r * T.size() + i] * mean_v;
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
                         testing::ValuesIn(effects_that([](const Effect* e) { return e->kind != EffectKind::source; })),
                         id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLoss, testing::ValuesIn(effects_that([](const Effect* e) {
                             return e->kind == EffectKind::loss && e->heat_effect() != nullptr;
                         })),
                         id_of);

}  // namespace tiretherm::physics
