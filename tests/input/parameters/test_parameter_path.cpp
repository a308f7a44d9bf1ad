// SPDX-License-Identifier: BSD-3-Clause
// The address of one number of a case, in all its forms: from text to path, to the document, to the problem and back.
#include "input/parameters/effect_names.hpp"
#include "input/parameters/parameter_kind.hpp"

#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/cameras/camera_bench.hpp"
#include "input/runs/read_experiment.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using solver::FreeParameter;

std::string case_including(const std::string& name) {
    return "include = [\"" + (source_folder() / "tests/bad_cases/good" / name).string() + "\"]\n";
}

/// A section with an effect of each sort. A name of a material has dots and a blank.
const std::string section_case = case_including("section.toml") + R"(
[effects.still_air]
patches = ["inside", "beads"]
h_by_patch = { beads = "40 W/m2K" }
[effects.inner_gas]
[effects.sensor_offset]
channels = ["bulk_temperature"]
[[mesh.layer]]
name = "tread"
zones = ["crown", "shoulders"]
thickness = "8 mm"
cells = 2
material = "K1.v2 soft"
[[mesh.layer]]
name = "carcass"
thickness = "4 mm"
cells = 2
material = "rubber"
[[material]]
name = "K1.v2 soft"
density = "1100 kg/m3"
heat_capacity = "1900 J/kgK"
conductivity = "0.3 W/mK"
[[source]]
name = "throttle heat"
follows = "speed"
at = "tread"
watts = "37 W"
[[exchange]]
name = "brake_air"
follows = "speed"
at = "carcass"
conductance = "5 W/K"
[[measured]]
channel = "bulk_temperature"
value = "40 degC"
uncertainty = "1 K"
)";

Experiment read_again(const fs::path& file) {
    ExperimentReading reading = read_experiment(file);
    for (const InputError& error : reading.errors) {
        ADD_FAILURE() << render(error);
    }
    return reading.experiment.value_or(Experiment{});
}

TomlValue document_of(const fs::path& file) {
    InputErrors errors;
    return read_document(file, errors).value_or(TomlValue{});
}

ParameterPath parsed(const std::string& text, const TomlValue& document) {
    InputErrors errors;
    const std::optional<ParameterPath> path =
        ParameterPath::parse({text, {.file = 0, .line = 1, .column = 7, .length = 1}}, document, errors);
    EXPECT_TRUE(path.has_value()) << text;
    return path.value_or(ParameterPath{});
}

TomlValue text_value(const std::string& text) {
    TomlValue value;
    value.kind = TomlValue::Kind::text;
    value.text = text;
    return value;
}

/// The numbers that a [[parameter]] with this text frees, added to a case.
std::vector<FreeParameter> freed(const Written& written, const std::string& text, const std::string& entry) {
    const Experiment experiment = read_again(written.add("free.toml", text + "[[parameter]]\n" + entry));
    return experiment.parameters;
}

void expect_same(const FreeParameter& a, const FreeParameter& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.unit, b.unit);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.effect, b.effect);
    EXPECT_EQ(a.parameter, b.parameter);
    EXPECT_EQ(a.everywhere, b.everywhere);
    EXPECT_EQ(a.scope, b.scope);
    EXPECT_EQ(a.place, b.place);
    EXPECT_EQ(a.layers, b.layers);
    EXPECT_EQ(a.knots, b.knots);
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_EQ(a.runs, b.runs);
    EXPECT_EQ(a.prior, b.prior);
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
}

/// What is wrong with a path of a [[parameter]], and where the caret stands.
InputError error_of(const Written& written, const std::string& text, const std::string& path) {
    const ExperimentReading reading =
        read_experiment(written.add("wrong.toml", text + fmt::format("[[parameter]]\nkey = \"{}\"\n", path)));
    EXPECT_FALSE(reading.experiment.has_value()) << path;
    EXPECT_EQ(reading.errors.size(), 1U) << path;
    return reading.errors.empty() ? InputError{} : reading.errors.front();
}

}  // namespace

// Text -> path -> set -> find gives what was set, whether or not the case has the value; the text is the same again.
TEST(ParameterPath, LeadsToWhatWasSetThere) {
    const Written written;
    const TomlValue document = document_of(written.add("case.toml", section_case));
    for (const auto& [text, n_keys] :
         std::vector<std::pair<std::string, std::size_t>>{{"drive.speed", 2U},
                                                          {"time.end", 2U},
                                                          {"mesh.crown_cells", 2U},
                                                          {"mesh.layer.tread.thickness", 4U},
                                                          {"material.K1.v2 soft.density", 3U},
                                                          {"material.rubber.conductivity", 3U},
                                                          {"source.throttle heat.watts", 3U},
                                                          {"effects.air_convection.lambda_h", 3U},
                                                          {"effects.still_air.h_by_patch.beads", 4U},
                                                          {"effects.radiation.emissivity", 3U}}) {
        const ParameterPath path = parsed(text, document);
        EXPECT_EQ(path.keys.size(), n_keys) << text;
        EXPECT_EQ(path.text(), text);
        TomlValue changed = document;
        InputErrors errors;
        ASSERT_TRUE(path.set(changed, text_value("12.5 K"), errors)) << text;
        ASSERT_NE(path.find(changed), nullptr) << text;
        EXPECT_EQ(path.find(changed)->text, "12.5 K") << text;
    }
    EXPECT_EQ(parsed("source.throttle heat.watts", document).find(document)->text, "37 W");
    EXPECT_EQ(parsed("material.K1.v2 soft.density", document).find(document)->text, "1100 kg/m3");
    EXPECT_EQ(parsed("effects.radiation.emissivity", document).find(document), nullptr);
    EXPECT_EQ(parsed("drive.speed.mean", document).find(document), nullptr);
}

// Of two names that both begin the rest of a path the longer one is meant.
TEST(ParameterPath, TakesTheLongestNameOfAList) {
    const Written written;
    const TomlValue document =
        document_of(written.add("case.toml", "[[material]]\nname = \"a\"\n[[material]]\nname = \"a.b\"\n"));
    EXPECT_EQ(parsed("material.a.b.density", document).keys[1].text, "a.b");
    EXPECT_EQ(parsed("material.a.bc.density", document).keys[1].text, "a");
}

// Each number of an effect, a law or the start: its path frees it as the other form of [[parameter]] does, and the path of
// what was freed is the text that freed it.
TEST(ParameterPath, FreesWhatTheFormsOfAParameterFree) {
    const Written written;
    const std::vector<std::array<std::string, 2>> forms{
        {"effects.air_convection.lambda_h", "effect = \"air_convection\"\nkey = \"lambda_h\"\n"},
        {"effects.still_air.h_by_patch.beads", "effect = \"still_air\"\nkey = \"h\"\npatch = \"beads\"\n"},
        {"effects.strain_energy_loss.strain_energy_share_by_layer.carcass",
         "effect = \"strain_energy_loss\"\nkey = \"strain_energy_share\"\nlayer = \"carcass\"\n"},
        {"effects.strain_energy_loss.strain_energy_share_by_zone.inside_shoulder",
         "effect = \"strain_energy_loss\"\nkey = \"strain_energy_share\"\nzone = \"inside_shoulder\"\n"},
        {"effects.sensor_offset.kelvin_by_channel.bulk_temperature",
         "effect = \"sensor_offset\"\nkey = \"kelvin\"\nchannel = \"bulk_temperature\"\n"},
        {"source.throttle heat.watts", "source = \"throttle heat\"\n"},
        {"source.throttle heat.watts", "effect = \"throttle heat\"\nkey = \"watts\"\n"},
        {"exchange.brake_air.conductance", "exchange = \"brake_air\"\nkey = \"conductance\"\n"},
        {"initial.tread", "initial = \"tread\"\n"},
        {"initial.gas", "initial = [\"gas\"]\n"},
        {"initial.temperature", "initial = \"temperature\"\n"},
    };
    for (const auto& [path, form] : forms) {
        SCOPED_TRACE(path);
        const std::vector<FreeParameter> by_path = freed(written, section_case, "key = \"" + path + "\"\n");
        const std::vector<FreeParameter> by_form = freed(written, section_case, form);
        ASSERT_EQ(by_path.size(), 1U);
        ASSERT_EQ(by_form.size(), 1U);
        expect_same(by_path.front(), by_form.front());
        const Experiment experiment = read_again(written.add("plain.toml", section_case));
        EXPECT_EQ(path_of(experiment.runs.front().problem, by_path.front()).text(), path);
    }
}

TEST(ParameterPath, FreesALawAtItsTemperatures) {
    const Written written;
    const std::string at = "at = [\"40 degC\", \"90 degC\"]\n";
    const std::string two_node = case_including("tire.toml") +
                                 "[[measured]]\nchannel = \"bulk_temperature\"\nvalue = \"40 degC\"\n"
                                 "uncertainty = \"1 K\"\n";
    for (const auto& [text, path, form] : std::vector<std::array<std::string, 3>>{
             {section_case, "material.K1.v2 soft.conductivity", "material = \"K1.v2 soft\"\nlaw = \"conductivity\"\n"},
             {section_case, "material.rubber.heat_capacity", "material = \"rubber\"\nlaw = \"heat_capacity\"\n"},
             {two_node, "mesh.link_conductivity", "link = \"conductivity\"\n"}}) {
        SCOPED_TRACE(path);
        const std::vector<FreeParameter> by_path = freed(written, text, "key = \"" + path + "\"\n" + at);
        const std::vector<FreeParameter> by_form = freed(written, text, form + at);
        ASSERT_EQ(by_path.size(), 2U);
        ASSERT_EQ(by_form.size(), 2U);
        const Experiment experiment = read_again(written.add("plain.toml", text));
        for (std::size_t i = 0; i < 2; ++i) {
            expect_same(by_path[i], by_form[i]);
            EXPECT_EQ(path_of(experiment.runs.front().problem, by_path[i]).text(), path);
        }
    }
}

// The position of a camera and its emissivity are numbers of two effects, and stand in one table.
TEST(ParameterPath, FreesNumbersOfACamera) {
    const Written written;
    written.add("frames.csv", frames_csv());
    const std::string text =
        std::string(camera_bench) + std::string(one_camera) + "emissivity = 0.9\n" + std::string(one_run);
    const Experiment experiment = read_again(written.add("plain.toml", text));
    for (const std::string key : {"x", "blur", "emissivity"}) {
        SCOPED_TRACE(key);
        const std::vector<FreeParameter> by_path = freed(written, text, "key = \"camera.camera." + key + "\"\n");
        const std::vector<FreeParameter> by_form = freed(written, text, "camera = \"camera\"\nkey = \"" + key + "\"\n");
        ASSERT_EQ(by_path.size(), 1U);
        ASSERT_EQ(by_form.size(), 1U);
        expect_same(by_path.front(), by_form.front());
        EXPECT_EQ(path_of(experiment.runs.front().problem, by_path.front()).text(), "camera.camera." + key);
    }
}

// The same number by its path and by its other form is one number.
TEST(ParameterPath, IsTheNumberThatAnotherFormFreesAlready) {
    const Written written;
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml", section_case + "[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\n[[parameter]]\n"
                                    "key = \"effects.air_convection.lambda_h\"\n"));
    ASSERT_EQ(reading.errors.size(), 1U);
    EXPECT_NE(reading.errors.front().what.find("air_convection.lambda_h is already a free parameter, at "),
              std::string::npos)
        << reading.errors.front().what;
}

// The caret stands under the key of the path that is wrong: key = " has seven characters before the path.
TEST(ParameterPath, SaysWhichOfItsKeysIsWrong) {
    const Written written;
    struct Wrong {
        std::string path;
        int column;
        std::string what;
        std::string remedy;
    };
    for (const Wrong& wrong : std::vector<Wrong>{
             {"effects.air_convektion.lambda_h", 16, "there is no effect \"air_convektion\"",
              "did you mean `air_convection`?"},
             {"effects.rim_conduction.bead", 16, "rim_conduction is off: its numbers change nothing",
              "switch it on: add [effects.rim_conduction]"},
             {"effects.layer_conductivity.scale", 16, "layer_conductivity is off: its numbers change nothing",
              "switch it on: add [effects.layer_conductivity] with layers = [\"tread\", \"carcass\"], or those of them "
              "that it is to act on; without layers it leaves tread out"},
             {"effects.air_convection.lamda_h", 31, "air_convection has no parameter \"lamda_h\"",
              "did you mean `lambda_h`?"},
             {"effects.air_convection", 16, "effects.air_convection does not end at a number",
              "write \"effects.air_convection.KEY\", or at one place \"effects.air_convection.KEY_by_patch.PLACE\""},
             {"effects.still_air.h.beads", 28, "effects.still_air.h.beads does not end at a number",
              "write \"effects.still_air.KEY\", or at one place \"effects.still_air.KEY_by_patch.PLACE\""},
             {"effects.still_air.h_by_patch.bead", 37, "the mesh has no patch \"bead\"", "did you mean `beads`?"},
             {"effects.still_air.h_by_zone.crown", 36, "still_air has the same values in all zones",
              "leave zone out: the value is free everywhere"},
             {"source.throttle heat.watt", 29, "[[source]] throttle heat has no number \"watt\" to fit",
              "its number is watts"},
             {"exchange.brakes.conductance", 17, "there is no [[exchange]] \"brakes\"", "there is only `brake_air`"},
             {"camera.top.x", 15, "there is no camera \"top\"", "add [[camera]] with this name"},
             {"initial.thread", 16, "initial cannot be \"thread\"", "did you mean `tread`?"},
             {"drive.speed", 8, "drive.speed is not a number that a fit can free",
              "name a number of [effects], [[source]], [[exchange]], [[camera]], [vehicle] or [initial], "
              "material.NAME.conductivity, material.NAME.heat_capacity or mesh.link_conductivity"},
             {"drive..speed", 7, "\"drive..speed\" is not a path: a key is missing at a dot",
              "write such as \"drive.speed\""},
         }) {
        SCOPED_TRACE(wrong.path);
        const InputError error = error_of(written, section_case, wrong.path);
        EXPECT_EQ(error.what, wrong.what);
        EXPECT_EQ(error.remedy, wrong.remedy);
        EXPECT_EQ(error.column, wrong.column);
    }
}

// A law is free at temperatures, and the case has to say which.
TEST(ParameterPath, OfALawNeedsItsTemperatures) {
    const Written written;
    const InputError error = error_of(written, section_case, "material.rubber.conductivity");
    EXPECT_EQ(error.what, "[[parameter]] lacks at");
    EXPECT_EQ(error.remedy, "add at = [\"...\"]");
}

// What can only be known from the document, when something is to be written there.
TEST(ParameterPath, CannotBeSetWhereNothingCanStand) {
    const Written written;
    const TomlValue document = document_of(written.add("case.toml", section_case));
    for (const auto& [text, what, remedy] : std::vector<std::array<std::string, 3>>{
             {"material.ruber.density", "there is no \"ruber\" in [[material]]", "did you mean `rubber`?"},
             {"material.rubber", "\"material.rubber\" is a table; one of its values is wanted",
              "go on with a key of it: \"material.rubber.key\""},
             {"drive.speed.mean", "drive.speed is \"100 km/h\", which has no \"mean\"",
              "end the path there: \"drive.speed\""},
             {"measured.bulk.value", "there is no \"bulk\" in [[measured]]",
              "its tables have no names, so none can be told from the others"}}) {
        InputErrors errors;
        errors.add_file("study.toml", fmt::format("key = \"{}\"\n", text));
        const std::optional<ParameterPath> path =
            ParameterPath::parse({text, {.file = 0, .line = 1, .column = 7, .length = 1}}, document, errors);
        ASSERT_TRUE(path.has_value()) << text;
        TomlValue changed = document;
        EXPECT_FALSE(path->set(changed, text_value("1"), errors)) << text;
        ASSERT_EQ(errors.in_order().size(), 1U) << text;
        EXPECT_EQ(errors.in_order().front().what, what);
        EXPECT_EQ(errors.in_order().front().remedy, remedy);
    }
}

// [diagnose] candidates names effects, their numbers, and their numbers by path.
TEST(CatalogueEntry, IsAnEffectOrOneOfItsNumbers) {
    const auto text = [](std::string_view name) {
        const std::optional<CatalogueEntry> entry = find_in_catalogue(name);
        return entry ? entry->text() : std::string("none");
    };
    EXPECT_EQ(text("radiation"), "radiation");
    EXPECT_EQ(text("radiation.emissivity"), "radiation.emissivity");
    EXPECT_EQ(text("effects.radiation.emissivity"), "radiation.emissivity");
    EXPECT_EQ(text("effects.radiation"), "radiation");
    EXPECT_EQ(text("radiation.emisivity"), "none");
    EXPECT_EQ(text("radiator"), "none");
    EXPECT_EQ(text("radiation."), "none");
    const physics::Effect& gas = *physics::find_effect("inner_gas");
    const auto rim = static_cast<std::size_t>(physics::find_parameter(gas, "rim"));
    EXPECT_TRUE(find_in_catalogue("inner_gas")->includes(gas, rim));
    EXPECT_TRUE(find_in_catalogue("inner_gas.rim")->includes(gas, rim));
    EXPECT_FALSE(find_in_catalogue("inner_gas.liner")->includes(gas, rim));
    EXPECT_FALSE(find_in_catalogue("radiation")->includes(gas, rim));
}

}  // namespace tiretherm::input
