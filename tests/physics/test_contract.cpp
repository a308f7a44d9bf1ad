// Every effect of the catalogue goes through the same identities, alone and beside the thesis's effects.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "physics/bench.hpp"
#include "solver/march.hpp"

namespace tiretherm::physics {

namespace {

/// Numbers that make an effect speak up whose standard ones change nothing.
Part loud(std::string_view id) {
    static const std::vector<Part> parts{{"uniform_source", {{"power_density", 1e5}}},
                                         {"road_temperature_drift", {{"rate", 20.0}}},
                                         {"air_temperature_drift", {{"rate", 20.0}}},
                                         {"slip_input_gain", {{"gain", 1.2}}},
                                         {"load_input_gain", {{"gain", 1.2}}},
                                         {"speed_input_gain", {{"gain", 1.2}}},
                                         {"laser_absorptivity", {{"factor", 0.9}, {"fall", 0.1}}},
                                         {"laser_spot_size", {{"scale", 1.2}}},
                                         {"initial_temperature", {{"offset", 5.0}}},
                                         {"layer_conductivity", {{"scale", 1.2}, {"slope", 0.002}}},
                                         {"layer_heat_capacity", {{"scale", 1.2}}},
                                         {"partition_speed", {{"slope", 0.05}}},
                                         {"loss_tangent_slope", {{"slope", 0.005}}},
                                         {"loss_frequency_shift", {{"per_decade", 5.0}}},
                                         {"load_exponent_of_loss", {{"exponent", 0.3}}},
                                         {"sidewall_convection", {{"h", 40.0}}},
                                         {"sensor_depth", {{"offset", 0.001}}},
                                         {"clock_delay", {{"delay", 0.5}}},
                                         {"sensor_offset", {{"kelvin", 1.0}}},
                                         {"sensor_gain", {{"excess", 0.05}}},
                                         {"own_source", {{"watts", -300.0}}},
                                         {"own_exchange", {{"conductance", 3.0}}}};
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.id == id; });
    return found == parts.end() ? Part{id} : *found;
}

/// The same with every candidate number where the effect is absent.
Part silent(const Effect& effect) {
    Part part = loud(effect.id);
    for (const Parameter& parameter : effect.parameters) {
        if (!std::isnan(parameter.absent)) {
            part.numbers.emplace_back(parameter.key, parameter.absent);
        }
    }
    return part;
}

bool has_absent(const Effect& effect) {
    return std::ranges::any_of(effect.parameters, [](const Parameter& p) { return !std::isnan(p.absent); });
}

bool can_act(const Effect& effect, const Bench& bench) {
    const bool has_place = effect.patches.empty() || !activate(effect, bench.mesh).patches.empty();
    const bool has_tire = !effect.needs_tire || bench.mesh.find_patch("top") < 0;
    const bool has_grid = !effect.needs_grid || bench.mesh.kind != "two_node";
    return has_place && has_tire && has_grid;
}

/// The thesis's effects that can act on a bench, the laser and still air on a specimen among them.
std::vector<Part> thesis(const Bench& bench) {
    std::vector<Part> parts;
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact",
                           "laser", "still_air"}) {
        if (can_act(*find_effect(id), bench)) {
            parts.push_back({id});
        }
    }
    return parts;
}

std::vector<Part> with(std::vector<Part> parts, const Part& part) {
    if (std::ranges::none_of(parts, [&](const Part& other) { return other.id == part.id; })) {
        parts.push_back(part);
    }
    return parts;
}

/// Half an hour into a run, fast, loaded, leaning, on a wet road: every law has something to say.
Inputs lively() {
    Inputs in = rolling();
    in.time = 1800.0;
    in.speed = 45.0;
    in.vertical_load = 6000.0;
    return in;
}

/// Each effect on every bench where it can act.
class EveryEffect : public testing::TestWithParam<const Effect*> {
protected:
    [[nodiscard]] static std::vector<Bench> benches() {
        std::vector<Bench> result{two_nodes(), specimen(), section()};
        std::erase_if(result, [](const Bench& bench) { return !can_act(*GetParam(), bench); });
        return result;
    }
    [[nodiscard]] static Part part() { return loud(GetParam()->id); }
};

class EveryPassiveEffect : public EveryEffect {};
class EveryLoss : public EveryEffect {};
class EveryCandidate : public EveryEffect {};

template <typename Predicate>
std::vector<const Effect*> effects_that(Predicate predicate) {
    std::vector<const Effect*> chosen;
    std::copy_if(catalogue().begin(), catalogue().end(), std::back_inserter(chosen), predicate);
    return chosen;
}

std::string id_of(const testing::TestParamInfo<const Effect*>& test) { return std::string(test.param->id); }

std::vector<double> random_field(std::size_t n, std::mt19937_64& random, double low = 270.0, double high = 420.0) {
    std::uniform_real_distribution<double> temperature(low, high);
    std::vector<double> T(n);
    for (double& t : T) {
        t = temperature(random);
    }
    return T;
}

std::size_t n_nodes(const Whole& whole) { return static_cast<std::size_t>(whole.problem().mesh.n_nodes); }

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
    EXPECT_EQ(effect.extend == nullptr, effect.capacity == nullptr);
    EXPECT_EQ(effect.on_channels, effect.kind == Kind::sensor);
    ASSERT_FALSE(benches().empty()) << "no bench lets this effect act";
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
                            .laser_power = 3.0 * unit(random)};
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
                if (active.effect->read != nullptr) {
                    ASSERT_TRUE(std::isfinite(active.effect->read(active, 0, 250.0 + 200.0 * unit(random), in)));
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
            double given = 0.0;
            double turnover = 0.0;
            for (const double q : whole.system().heat_flow()) {
                given += q;
                turnover += std::abs(q);
            }
            double booked = 0.0;
            for (const double watts : whole.system().terms().watts) {
                booked += watts;
            }
            EXPECT_NEAR(booked, given, 1e-13 * turnover);
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
        in.speed = 0.0;  // natural convection speaks only at rest
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
                terms.face_G[f] * (v[b] - v[a]) + terms.face_by_a[f] * v[a] + terms.face_by_b[f] * v[b];
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

namespace {

/// All that an effect can change, as numbers: inputs, initial state, capacities, heat flow, rolling and at rest, into the
/// nodes that are there without it, and readings.
std::vector<double> told(const Bench& bench, const std::vector<Part>& parts) {
    Whole whole(bench, parts);
    whole.ask(lively());
    const solver::System& system = whole.system();
    std::vector<double> numbers;
    const Inputs inputs = system.transformed(lively());
    for (const Signal& signal : signals()) {
        numbers.push_back(inputs.*signal.member);
    }
    const std::vector<double> initial = system.initial();
    for (std::size_t node = 0; node < bench.T.size(); ++node) {
        numbers.push_back(initial[node]);
        numbers.push_back(system.capacity(node, 310.0));
        numbers.push_back(system.heat_flow()[node]);
    }
    Inputs rest = lively();
    rest.speed = 0.0;
    whole.ask(rest);
    for (std::size_t node = 0; node < bench.T.size(); ++node) {
        numbers.push_back(system.heat_flow()[node]);
    }
    double value = 330.0;
    double lag = 0.0;
    double delay = 0.0;
    double deeper = 0.0;
    for (const ActiveEffect& active : system.effects()) {
        const Effect& effect = *active.effect;
        value = effect.read != nullptr ? effect.read(active, 0, value, lively()) : value;
        lag += effect.lag != nullptr ? effect.lag(active, 0) : 0.0;
        delay += effect.delay != nullptr ? effect.delay(active, 0) : 0.0;
        deeper += effect.deeper != nullptr ? effect.deeper(active, 0) : 0.0;
    }
    numbers.insert(numbers.end(), {value, lag, delay, deeper});
    return numbers;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
    double largest = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        largest = std::max(largest, std::abs(one[i] - other[i]) / (1.0 + std::abs(other[i])));
    }
    return largest;
}

solver::Report run_for_a_minute(const Bench& bench, const std::vector<Part>& parts) {
    solver::Problem problem = Whole::problem_of(bench, parts);
    for (const Signal& signal : signals()) {
        problem.drive.add(signal, lively().*signal.member);
    }
    problem.settings.end = 60.0;
    problem.settings.fixed_step = 5.0;
    problem.settings.tolerance = 1e-6;  // Newton's iteration ends below a twentieth of it
    return solver::run(problem, [](const solver::Snapshot&) { return true; });
}

}  // namespace

TEST_P(EveryCandidate, DoesNothingWhereItIsAbsent) {
    for (const Bench& bench : benches()) {
        const std::vector<double> without = told(bench, thesis(bench));
        EXPECT_LT(largest_difference(told(bench, with(thesis(bench), silent(*GetParam()))), without), 1e-13);
    }
}

TEST_P(EveryCandidate, DoesSomethingWhereItIsNot) {
    double largest = 0.0;
    for (const Bench& bench : benches()) {
        largest =
            std::max(largest, largest_difference(told(bench, with(thesis(bench), part())), told(bench, thesis(bench))));
    }
    EXPECT_GT(largest, 1e-4);
}

TEST_P(EveryCandidate, LeavesARunAsItIsWhereItIsAbsent) {
    // A minute in fixed steps: the same channels to the tolerance of Newton's iteration, the same joules of the others,
    // the balance closed with whatever was appended.
    for (const Bench& bench : benches()) {
        const solver::Report without = run_for_a_minute(bench, thesis(bench));
        const solver::Report silenced = run_for_a_minute(bench, with(thesis(bench), silent(*GetParam())));
        ASSERT_TRUE(without.status.ok() && silenced.status.ok()) << silenced.status.message;
        EXPECT_LT(silenced.energy_closure, 1e-9);
        for (std::size_t c = 0; c < without.channel_final.size(); ++c) {
            EXPECT_NEAR(silenced.channel_final[c], without.channel_final[c], 1e-6);
        }
        for (std::size_t e = 0; e < without.joules.size(); ++e) {
            EXPECT_NEAR(silenced.joules[e], without.joules[e], 1e-6 * (1.0 + std::abs(without.joules[e])));
        }
    }
}

TEST_P(EveryCandidate, ClosesTheBalanceOfARun) {
    for (const Bench& bench : benches()) {
        const solver::Report report = run_for_a_minute(bench, with(thesis(bench), part()));
        ASSERT_TRUE(report.status.ok()) << report.status.message;
        EXPECT_LT(report.energy_closure, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEffect, testing::ValuesIn(catalogue().begin(), catalogue().end()), id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPassiveEffect,
                         testing::ValuesIn(effects_that([](const Effect* e) { return e->kind != Kind::source; })),
                         id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLoss, testing::ValuesIn(effects_that([](const Effect* e) {
                             return e->kind == Kind::loss && e->speak != nullptr;
                         })),
                         id_of);
INSTANTIATE_TEST_SUITE_P(Catalogue, EveryCandidate,
                         testing::ValuesIn(effects_that([](const Effect* e) { return has_absent(*e); })), id_of);

TEST(Catalogue, HoldsTheseEffectsAndNoOther) {
    const std::set<std::string_view> thesis_model{
        "conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact", "laser", "still_air"};
    const std::set<std::string_view> extensions{"sidewall_convection",
                                                "inner_gas",
                                                "rim_conduction",
                                                "camber_asymmetry",
                                                "cornering_loss",
                                                "inflation_pressure_rise",
                                                "groove_convection",
                                                "radiation",
                                                "natural_convection",
                                                "road_temperature_drift",
                                                "air_temperature_drift",
                                                "wet_road",
                                                "resolved_contact",
                                                "contact_pressure_conductance",
                                                "convection_exponent",
                                                "partition_speed",
                                                "loss_tangent_slope",
                                                "loss_frequency_shift",
                                                "load_exponent_of_loss",
                                                "drum_curvature",
                                                "standing_wave",
                                                "tread_wear",
                                                "belt_anisotropy",
                                                "layer_conductivity",
                                                "layer_heat_capacity",
                                                "laser_absorptivity",
                                                "laser_spot_size",
                                                "initial_temperature",
                                                "sensor_lag",
                                                "sensor_offset",
                                                "sensor_gain",
                                                "sensor_depth",
                                                "camera_emissivity",
                                                "pressure_reading_speed",
                                                "clock_delay",
                                                "slip_input_gain",
                                                "load_input_gain",
                                                "speed_input_gain",
                                                "own_source",
                                                "own_exchange"};
    std::set<std::string_view> seen;
    for (const Effect* effect : catalogue()) {
        EXPECT_TRUE(seen.insert(effect->id).second) << effect->id << " is there twice";
        // For reference problems, beside the catalogue.
        EXPECT_TRUE(thesis_model.contains(effect->id) || extensions.contains(effect->id) ||
                    effect->id == "uniform_source")
            << effect->id;
        EXPECT_EQ(has_absent(*effect), extensions.contains(effect->id)) << effect->id;
    }
    EXPECT_EQ(seen.size(), thesis_model.size() + extensions.size() + 1);
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"}) {
        EXPECT_TRUE(find_effect(id)->on) << id;
    }
    EXPECT_EQ(std::ranges::count_if(catalogue(), [](const Effect* e) { return e->on; }), 5);
    EXPECT_EQ(find_effect("phlogiston"), nullptr);
}

TEST(Catalogue, ReadingsStandInTheirOrder) {
    std::vector<std::string_view> order;
    for (const Effect* effect : catalogue()) {
        if (effect->on_channels) {
            order.push_back(effect->id);
        }
    }
    EXPECT_EQ(order, (std::vector<std::string_view>{"camera_emissivity", "sensor_depth", "clock_delay", "sensor_lag",
                                                    "sensor_offset", "sensor_gain", "pressure_reading_speed"}));
}

TEST(Catalogue, OrderOfEffectsDoesNotMatter) {
    // Everything that can act, switched on from first to last and from last to first: the same sums but for the order of
    // additions. Appended nodes, whose numbers differ, are compared by name.
    for (const Bench& bench : {two_nodes(), specimen(), section()}) {
        std::vector<Part> parts;
        for (const Effect* effect : catalogue()) {
            if (!effect->on_channels && can_act(*effect, bench)) {
                parts.push_back(loud(effect->id));
            }
        }
        Whole forwards(bench, parts);
        std::reverse(parts.begin(), parts.end());
        Whole backwards(bench, parts);
        ASSERT_EQ(n_nodes(forwards), n_nodes(backwards));
        const auto field = [&](const Whole& whole) {
            std::vector<double> T = bench.T;
            T.resize(n_nodes(whole));
            for (const mesh::Appended& appended : whole.problem().mesh.appended) {
                T[static_cast<std::size_t>(appended.node)] = 300.0 + static_cast<double>(appended.name.size());
            }
            return T;
        };
        forwards.ask(lively(), field(forwards));
        backwards.ask(lively(), field(backwards));
        double turnover = 0.0;
        for (const double q : forwards.system().heat_flow()) {
            turnover += std::abs(q);
        }
        for (std::size_t node = 0; node < bench.T.size(); ++node) {
            const int same = static_cast<int>(node);
            EXPECT_NEAR(forwards.flow(same), backwards.flow(same), 1e-12 * turnover);
            EXPECT_NEAR(forwards.system().capacity(node, 310.0), backwards.system().capacity(node, 310.0), 1e-9);
        }
        for (const mesh::Appended& appended : forwards.problem().mesh.appended) {
            EXPECT_NEAR(forwards.flow(appended.node), backwards.flow(backwards.node(appended.name)), 1e-12 * turnover)
                << appended.name;
        }
    }
}

}  // namespace tiretherm::physics
