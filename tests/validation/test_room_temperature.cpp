// SPDX-License-Identifier: BSD-3-Clause
// How rolling resistance follows the temperature of the room, beside the corrections of ISO 28580.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/new_case/made.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::input {

namespace {

/// A warm tire.
struct Rolled {
    double watts = 0.0;  ///< of the loss; over the speed it is the rolling resistance
    double bulk = 0.0;   ///< degC
};

std::string with(std::string text, std::string_view what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, what.size(), by);
    }
    return text;
}

/// @param text with ROOM in degC and FILLED in K
Rolled roll(const std::string& text, double room) {
    const Written written;
    const std::string here =
        with(with(text, "ROOM", fmt::format("{:g}", room)), "FILLED", fmt::format("{:g}", room + 273.15));
    const Reading reading = read_case(written.add("room.toml", here));
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    if (!reading.problem) {
        return {};
    }
    const solver::Problem& problem = *reading.problem;
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    const auto loss =
        std::ranges::find_if(problem.effects, [](const auto& one) { return one.effect->id == "strain_energy_loss"; });
    const auto bulk = std::ranges::find(problem.channels, "bulk_temperature", &solver::Channel::name);
    return {report.watts[static_cast<std::size_t>(loss - problem.effects.begin())],
            report.channel_final[static_cast<std::size_t>(bulk - problem.channels.begin())] - 273.15};
}

/// Around 25 degC: K_t of ISO 28580, F25 = F (1 + K_t (t - 25 degC)), and how the bulk follows the room.
struct Followed {
    double correction = 0.0;  ///< 1/K
    double share = 0.0;       ///< K of the bulk per K of the room
};
Followed follow(const std::string& name, const std::string& text) {
    const Rolled cold = roll(text, 20.0);
    const Rolled warm = roll(text, 30.0);
    const Followed found{.correction = std::log(cold.watts / warm.watts) / 10.0,
                         .share = (warm.bulk - cold.bulk) / 10.0};
    ::testing::Test::RecordProperty(name + "_correction", fmt::format("{:.6f}", found.correction));
    ::testing::Test::RecordProperty(name + "_share", fmt::format("{:.4f}", found.share));
    ::testing::Test::RecordProperty(name + "_bulk", fmt::format("{:.3f}", 0.5 * (cold.bulk + warm.bulk)));
    return found;
}

/// Cases of the library at 4000 N and 80 km/h in a room, and on its drum.
std::string in_a_room(std::initializer_list<std::string_view> includes, const std::string& more = "") {
    std::string list;
    for (const std::string_view one : includes) {
        list += fmt::format("\"{}/cases/{}.toml\", ", source_folder().string(), one);
    }
    return fmt::format(
        "include = [{}]\n[drive]\nvertical_load = \"4000 N\"\nspeed = \"80 km/h\"\nair_temperature = \"ROOM degC\"\n"
        "road_temperature = \"ROOM degC\"\n[initial]\ntemperature = \"ROOM degC\"\n{}",
        list, more);
}
constexpr std::string_view drum =
    "[effects.drum_curvature]\ncurvature = \"1.172 1/m\"\n[effects.inflation_pressure_rise]\nreference = \"FILLED "
    "K\"\n";

/// What `tiretherm new` makes of a size, on the drum of the standard, until it is warm.
std::string new_case_on_drum(std::string_view size) {
    const Written written;
    std::string text = make(written, size).text;
    for (const auto& [what, by] :
         {std::pair{"\"23 degC\"", "\"ROOM degC\""}, std::pair{"reference = \"293.15 K\"", "reference = \"FILLED K\""},
          std::pair{"curvature = \"0 1/m\"", "curvature = \"1.172 1/m\""},
          std::pair{"end = \"3600 s\"", "end = \"10800 s\""}}) {
        EXPECT_NE(text.find(what), std::string::npos) << what;
        text = with(std::move(text), what, by);
    }
    return text;
}

}  // namespace

// The loss is that of a tire which is as warm as it makes itself: d ln F/dt = (d ln tan delta/dT) (dT/dt). The thesis's loss tangent
// falls by s = 2 (T_eq - b)/c^2; at 80 km/h f = 22.22/(2 pi 0.3233 m) = 10.94 Hz, which WLF makes 101.6 log10(10.94/52)/(-8.86 -
// log10(10.94/52)) = 8.4 K, so that s = 2 (T + 8.4 K + 4989 K)/(882 K)^2: 0.0137 1/K at 50 to 60 degC. Two nodes have one bulk.
TEST(RoomTemperature, ActsThroughTheLossTangentOfABulkThatFollowsTheRoomInPart) {
    const Followed two_nodes = follow("two_node", in_a_room({"two_node/common"}));
    EXPECT_NEAR(two_nodes.correction, 0.0137 * two_nodes.share, 2e-5);
    // From F = G (T - t): dT/dt = 1/(1 + (T - t)(s + d ln G/dT)). Without the exponential of (33), G rises more slowly.
    const Followed plain =
        follow("plain", in_a_room({"two_node/common"}, "[effects.air_convection]\nexponential = \"off\"\n"));
    EXPECT_NEAR(plain.correction, 0.0137 * plain.share, 4e-5);
    EXPECT_GT(plain.share, two_nodes.share + 0.1);
    // The section's probes are 2 % nearer to the room than the mean of its bulk, and rubber of constant conductivities has no other G'
    // than that of the films: 27 K above the room 1/(1 + 27 0.0137) = 0.73 would be without any.
    const Followed section = follow("section", in_a_room({"section/common"}));
    EXPECT_NEAR(section.correction, 0.0137 * section.share, 0.0137 * section.share * 0.03);
    const Followed literature = follow(
        "literature", in_a_room({"section/common", "section/all_heat_paths", "section/literature_conductivities"},
                                std::string(drum)));
    EXPECT_NEAR(literature.share, 0.73, 0.03);
}

// ISO 28580: 0.008 1/K of passenger tires, 0.006 1/K of trucks above a load index of 121. Nothing is fitted to them. They are means
// over tires, printed with one digit: a tenth.
TEST(RoomTemperature, OfATireWithAllHeatPathsIsThatOfTheStandard) {
    const Followed passenger =
        follow("all_paths", in_a_room({"section/common", "section/all_heat_paths"}, std::string(drum)));
    EXPECT_NEAR(passenger.correction, 0.008, 0.0008);
    const Followed truck = follow("truck", new_case_on_drum("315/80 R22.5 154L"));
    EXPECT_NEAR(truck.correction, 0.006, 0.0006);
}

}  // namespace tiretherm::input
