// SPDX-License-Identifier: BSD-3-Clause
// Logs of tire test machines and of specimens under a laser; sizes with load index and speed symbol.
#include <cmath>

#include <fmt/format.h>

#include "input/new_case/made.hpp"
#include "input/runs/read_experiment.hpp"

namespace tiretherm::input {
namespace {

constexpr double pound = 4.4482216152605;  // N
constexpr double zero_of_rig = 273.15;     // K

/// Ten seconds of a machine in one system of units, made up: a title, names, units. The inclination heats the side of TSTI where
/// `lean` is positive, and that of TSTO where it is negative.
std::string rig_file(bool si, double lean = -1.0, bool with_sl = true) {
    std::string text = "B1 made up\nET\tV\tN\tSA\tIA\tP\tFX\tFY\tFZ\tMX\tRST\tTSTI\tTSTC\tTSTO\tAMBTMP\tSR";
    text += with_sl ? "\tSL\n" : "\n";
    text += si ? "sec\tkph\trpm\tdeg\tdeg\tkPa\tN\tN\tN\tN-m\tdeg-C\tdeg-C\tdeg-C\tdeg-C\tdeg-C\tnone"
               : "sec\tmph\trpm\tdeg\tdeg\tpsi\tlb\tlb\tlb\tlb-ft\tdeg-F\tdeg-F\tdeg-F\tdeg-F\tdeg-F\tnone";
    text += with_sl ? "\tnone" : "";
    const double force = si ? 1.0 : 1.0 / pound;
    const auto degrees = [&](double celsius) { return si ? celsius : 1.8 * celsius + 32.0; };
    for (int i = 0; i <= 100; ++i) {
        const double inclination = i < 50 ? 0.0 : 4.0;
        const double side = 0.5 * lean * inclination;
        text +=
            fmt::format("\n{:.2f}\t{:.4f}\t470\t{:.3f}\t{:.3f}\t{:.4f}\t0.5\t{:.4f}\t{:.4f}\t0.1", 0.1 * i,
                        si ? 40.0 : 40.0 / 1.609344, 6.0 * std::sin(0.1 * i), inclination, si ? 83.0 : 83.0 / 6.894757,
                        -900.0 * force * std::sin(0.1 * i), (i == 0 ? 2.0 : -667.0) * force);
        text += fmt::format("\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t{:.4f}\t0.03", degrees(25.0), degrees(41.0 + side),
                            degrees(42.0), degrees(40.0 - side), degrees(22.0));
        text += with_sl ? "\t0.01" : "";
    }
    return text + "\n";
}

solver::Problem problem_of(const NewCase& made, const Written& written) {
    EXPECT_TRUE(made.errors.empty()) << errors_of(made, written);
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    EXPECT_TRUE(reading.experiment.has_value()) << (reading.errors.empty() ? "" : render(reading.errors.front()));
    return reading.experiment ? reading.experiment->runs.front().problem : solver::Problem{};
}

}  // namespace

// The machine's numbers in SI and in US units are the same tire: 40 km/h, 667 N with the sign of SAE J670 turned, 83 kPa, 25 degC of
// the belt, 22 degC of the air. The load of +2 N at the start is the load cell's zero_of_rig: no load.
TEST(NewCaseRig, ReadsAMachinesColumnsInBothSystemsOfUnits) {
    for (const bool si : {true, false}) {
        const Written written;
        written.add("run.dat", rig_file(si));
        const NewCase made = make(written, "16.0x7.5-10", "", "run.dat");
        const solver::Problem problem = problem_of(made, written);
        const physics::Inputs in = problem.input_signals.at(5.0, solver::JumpSide::after);
        EXPECT_NEAR(in.speed, 40.0 / 3.6, 1e-4);
        EXPECT_NEAR(in.vertical_load, 667.0, 1e-3);
        EXPECT_EQ(problem.input_signals.at(0.0, solver::JumpSide::after).vertical_load, 0.0);
        EXPECT_NEAR(in.slip_angle, 6.0 * std::sin(5.0) * M_PI / 180.0, 1e-5);
        EXPECT_NEAR(in.lateral_force, -900.0 * std::sin(5.0), 1e-3);
        EXPECT_NEAR(in.inflation_pressure, 83e3, 1.0);
        EXPECT_NEAR(in.road_temperature, zero_of_rig + 25.0, 1e-3);
        EXPECT_NEAR(in.air_temperature, zero_of_rig + 22.0, 1e-3);
        EXPECT_NEAR(in.slip_ratio, 0.01, 1e-12);  // SL, which is 0 without a force; SR counts from another radius
        EXPECT_EQ(column_of(made, "FZ").unit, si ? "-1 N" : "-1 lbf");
        EXPECT_EQ(column_of(made, "TSTI").name, "inside_shoulder_surface_temperature");
        EXPECT_EQ(column_of(made, "TSTC").name, "crown_surface_temperature");
        EXPECT_EQ(column_of(made, "TSTO").name, "outside_shoulder_surface_temperature");
        EXPECT_TRUE(column_of(made, "MX").is_foreign);
    }
}

// The machine inflates to 83 kPa: the laws of the load are scaled there and not at a car's 220 kPa, unless somebody says otherwise.
TEST(NewCaseRig, TheLogsPressureIsThatOfTheTiresLaws) {
    for (const bool si : {true, false}) {
        const Written written;
        written.add("run.dat", rig_file(si));
        const NewCase made = make(written, "16.0x7.5-10", "", "run.dat");
        EXPECT_NEAR(problem_of(made, written).tire.reference_pressure, 83e3, 1.0);
        EXPECT_NE(made.text.find("scaled at 83 kPa"), std::string::npos) << made.text;
        const NewCase given = make_new_case({.size = std::get<TireSize>(read_tire_size("16.0x7.5-10")),
                                             .inflation_pressure = 97e3,
                                             .log = written.folder() / "run.dat",
                                             .target = written.folder() / "case.toml"});
        EXPECT_NEAR(problem_of(given, written).tire.reference_pressure, 97e3, 1.0);
    }
}

// 26.7 psi of absolute pressure are 12 psi above the atmosphere: taken for psi they would be twice as much. The column is left out,
// and the remedy does not make numbers of another meaning of it.
TEST(NewCaseRig, AnAbsolutePressureIsCalledOne) {
    for (const char* unit : {"psia", "PSIA", "psi abs", "psi(a)"}) {
        const Written written;
        std::string log = fmt::format(
            "time [s],speed [km/h],vertical_load [N],inflation_pressure [{}],surface_temperature [degC]\n", unit);
        for (int i = 0; i < 20; ++i) {
            log += fmt::format("{},100,4000,26.7,{}\n", 10 * i, 20 + i);
        }
        written.add("run.csv", log);
        const NewCase made = make(written, "225/50 R17", "two_node", "run.csv");
        EXPECT_TRUE(made.errors.empty()) << errors_of(made, written);
        ASSERT_FALSE(made.missing.empty()) << unit;
        EXPECT_NE(made.missing.front().what.find("is an absolute pressure"), std::string::npos)
            << made.missing.front().what;
        EXPECT_EQ(made.missing.front().remedy,
                  "take the atmosphere's 14.7 psi (at sea level) away from the numbers and write psi");
    }
}

// The gas starts at what the log's sensor reads first, the rubber at what its own does.
TEST(NewCaseRig, TheGasStartsWhereItsSensorDoes) {
    const Written written;
    std::string log = "time [s],speed [km/h],vertical_load [N],gas_temperature [degC],surface_temperature [degC]\n";
    for (int i = 0; i < 20; ++i) {
        log += fmt::format("{},100,4000,{:.1f},{:.1f}\n", 10 * i, 31.5 + 0.1 * i, 40.0 + i);
    }
    written.add("run.csv", log);
    const NewCase made = make(written, "225/50 R17", "section", "run.csv");
    const solver::Problem problem = problem_of(made, written);
    const auto gas = std::ranges::find(problem.mesh.lumped_nodes, "gas", &mesh::LumpedNode::name);
    ASSERT_NE(gas, problem.mesh.lumped_nodes.end());
    EXPECT_NEAR(problem.initial[static_cast<std::size_t>(gas->node)], zero_of_rig + 31.5, 1e-9);
    EXPECT_NEAR(problem.initial.front(), zero_of_rig + 40.0, 1e-9);
}

// Camber is negative where the top leans inboard and heats the inside shoulder. A machine that counts it the other way is turned.
TEST(NewCaseRig, TurnsAnInclinationByTheHotterShoulder) {
    for (const auto& [lean, camber] : {std::pair{-1.0, 4.0}, std::pair{1.0, -4.0}}) {
        const Written written;
        written.add("run.dat", rig_file(true, lean, false));
        const NewCase made = make(written, "225/50 R17", "", "run.dat");
        const solver::Problem problem = problem_of(made, written);
        const physics::Inputs in = problem.input_signals.at(9.0, solver::JumpSide::after);
        EXPECT_NEAR(in.camber, camber * M_PI / 180.0, 1e-9);
        EXPECT_NEAR(in.slip_ratio, 0.03, 1e-12);
    }
}

// 2 W from the log on the spot of the library's case; what the sensors are is asked, as nothing but their names tells.
TEST(NewCaseSpecimen, IsMadeOfALogWithALaser) {
    const Written written;
    written.add("laser.csv",
                "t [s],P laser [W],T front [degC],inner_liner_temperature [degC]\n0,0,23,24\n10,2,23,24\n"
                "20,2,40,25\n30,2,50,26\n");
    const NewCase made = make(written, "225/50 R17", "", "laser.csv");
    const solver::Problem problem = problem_of(made, written);
    EXPECT_EQ(made.mesh_name, "specimen");
    EXPECT_EQ(problem.mesh.kind, "patch");
    EXPECT_NEAR(problem.input_signals.at(20.0, solver::JumpSide::after).laser_power, 2.0, 1e-12);
    EXPECT_EQ(column_of(made, "T front").suggestion, "spot_mean_temperature");
    EXPECT_NEAR(problem.initial.front(), zero_of_rig + 24.0, 1e-9);
    EXPECT_EQ(made.text.find("[tire]"), std::string::npos);
    EXPECT_EQ(made.text.find("vertical_load"), std::string::npos);
    // Micrometers and ride heights by laser are none, and whoever says so gets a tire.
    written.add("height.csv",
                "time [s],speed [km/h],vertical_load [N],Laser height [mm]\n0,80,4000,30\n1,80,4000,31\n");
    EXPECT_EQ(make(written, "225/50 R17", "", "height.csv").mesh_name, "section");
}

// Load index 94 is 670 kg: 0.8 670 9.80665 (220/250)^0.8 = 4745 N. F is for 80 km/h, of which 80 % are 64.
TEST(NewCaseService, LoadIndexAndSymbolGiveLoadAndSpeed) {
    const Written written;
    const NewCase made = make(written, "225/50 R17 94W", "two_node");
    EXPECT_NE(made.text.find("vertical_load = \"4750 N\""), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("80 % of what load index 94 carries at 220 kPa"), std::string::npos);
    EXPECT_NE(made.text.find("speed = \"100 km/h\""), std::string::npos);
    EXPECT_NE(make(written, "315/80 R22.5 154F", "two_node").text.find("speed = \"64 km/h\""), std::string::npos);
    EXPECT_NE(make(written, "225/50 R17", "two_node").text.find("vertical_load = \"4000 N\""), std::string::npos);
}

// Without a load index a kart's tire carries no 4 kN: 4000 N (100/220)^0.8 (180.34/225) sqrt(139.7 76.2/(328.4 112.5)) = 916 N at a
// kart's 100 kPa; R = 63.5 + 76.2 mm. A truck's 11 R22.5 carries 27 kN by the tables of ETRTO, of which these are nearly all.
TEST(NewCaseService, ASizeWithoutALoadIndexCarriesWhatItsSizeLetsExpect) {
    const Written written;
    const NewCase kart = make(written, "11x7.1-5", "two_node");
    EXPECT_NE(kart.text.find("vertical_load = \"920 N\""), std::string::npos) << kart.text;
    EXPECT_NE(kart.text.find("assumed: the size has no load index"), std::string::npos) << kart.text;
    EXPECT_NE(kart.text.find("scaled at 100 kPa"), std::string::npos) << kart.text;
    EXPECT_NE(make(written, "11 R22.5", "two_node").text.find("vertical_load = \"25810 N\""), std::string::npos);
}

// UN R30 of a V tire on a drum of 1.7 m: 240 - 40 = 200 km/h after a ramp of 10 min, 10 km/h more every 10 min, 230 km/h for 20 min.
// 73 % of 615 kg are 4403 N, at 300 kPa; of an H tire 80 %, 4825 N, at 280 kPa, up to 200 km/h.
TEST(NewCaseDrum, StepsLoadAndPressureFollowTheSpeedSymbol) {
    for (const auto& [symbol, load, pressure, last] :
         {std::tuple{'V', 4403.0, 300e3, 230.0}, std::tuple{'H', 4825.0, 280e3, 200.0},
          std::tuple{'W', 4101.0, 320e3, 260.0}}) {
        const Written written;
        const TireSize size = std::get<TireSize>(read_tire_size(fmt::format("205/55 R16 91{}", symbol)));
        NewCaseRequest request{.size = size, .target = written.folder() / "case.toml"};
        request.test = std::get<DrumTest>(drum_test("un_r30", size));
        const NewCase made = make_new_case(request);
        ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
        const Reading reading = read_case(written.add("case.toml", made.text));
        ASSERT_TRUE(reading.problem) << render(reading);
        const physics::Inputs in = reading.problem->input_signals.at(3500.0, solver::JumpSide::after);
        EXPECT_NEAR(in.vertical_load, load, 0.6);
        EXPECT_NEAR(in.inflation_pressure, pressure, 1e-6);
        EXPECT_NEAR(in.speed, last / 3.6, 1e-9);
        EXPECT_NEAR(reading.problem->input_signals.at(900.0, solver::JumpSide::after).speed, (last - 30.0) / 3.6, 1e-9);
        EXPECT_EQ(reading.problem->settings.end, 3600.0);
    }
}

TEST(NewCaseDrum, EveryTestMakesACaseThatIsAccepted) {
    const TireSize size = std::get<TireSize>(read_tire_size("205/55 R16 91V"));
    for (const std::string_view name : drum_test_names()) {
        const Written written;
        NewCaseRequest request{.size = size, .target = written.folder() / "case.toml"};
        request.test = std::get<DrumTest>(drum_test(name, size));
        const NewCase made = make_new_case(request);
        ASSERT_TRUE(made.errors.empty()) << name << errors_of(made, written);
    }
    // 24 h of 34 h at the full load of 615 kg: 6031 N.
    const DrumTest endurance = std::get<DrumTest>(drum_test("fmvss_139_endurance", size));
    EXPECT_EQ(endurance.rows.back().minutes, 34.0 * 60.0);
    EXPECT_NEAR(endurance.rows.back().load_share * endurance.load, 6031.1, 0.1);
    for (const char* wrong : {"205/55 R16", "205/55 R16 91", "265/65 R16C 112/110R"}) {
        EXPECT_TRUE(std::holds_alternative<ErrorText>(drum_test("un_r30", std::get<TireSize>(read_tire_size(wrong)))))
            << wrong;
    }
}

}  // namespace tiretherm::input
