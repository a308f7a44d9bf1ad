// SPDX-License-Identifier: BSD-3-Clause
// The descriptions of keys: each once, complete, and found by the titles that messages use.
#include <algorithm>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "input/model/sensors.hpp"
#include "input/runs/reader.hpp"
#include "input/schema/all_tables.hpp"
#include "input/toml/toml_table.hpp"
#include "input/toml/toml_text.hpp"
#include "solver/problem.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

const Key& key(std::string_view table, std::string_view name, std::string_view kind = {}) {
    return *keys_of_table(table)->find(name, kind);
}

}  // namespace

TEST(AllTables, EveryTableAndEveryKeyIsDescribedOnceAndInFull) {
    std::set<std::string_view> paths;
    for (const TableKeys& table : all_tables()) {
        EXPECT_TRUE(paths.insert(table.path).second) << table.path;
        EXPECT_TRUE(table.sentence.ends_with('.') || table.sentence.ends_with('`')) << table.path;
        std::set<std::pair<std::string_view, std::string_view>> names;
        for (const Key& one : table.keys) {
            EXPECT_TRUE(names.insert({one.name, one.of_kinds}).second) << table.path << ' ' << one.name;
            EXPECT_TRUE(one.sentence.ends_with('.')) << table.path << ' ' << one.name;
            EXPECT_EQ(one.form == KeyForm::choice, !one.words.empty()) << table.path << ' ' << one.name;
            EXPECT_EQ(one.form == KeyForm::count, one.low < one.high) << table.path << ' ' << one.name;
            EXPECT_TRUE(one.spec.unit.empty() || !signature(one.spec.unit).empty()) << table.path << ' ' << one.name;
        }
    }
}

// A key that differs between kinds of a table: on a disc a point may lie on the axis, and a spot has a size.
TEST(AllTables, AKeyMayDifferFromKindToKind) {
    EXPECT_FALSE(key("[[sensor]]", "radius", "point").spec.above);
    EXPECT_TRUE(key("[[sensor]]", "radius", "spot").spec.above);
    EXPECT_TRUE(key("[mesh]", "crown_cells").is_of("section"));
    EXPECT_FALSE(key("[mesh]", "crown_cells").is_of("layers"));
    EXPECT_TRUE(key("[mesh]", "kind").is_of("layers"));
}

// Kinds are a list of their readers; the description prints it.
TEST(AllTables, KindsAreThoseOfTheirReaders) {
    std::vector<std::string_view> names;
    std::ranges::transform(sensor_kinds(), std::back_inserter(names), &SensorKind::name);
    EXPECT_EQ(key("[[sensor]]", "kind").words, names);
    const Written written;
    for (const std::string_view kind : key("[mesh]", "kind").words) {
        const std::string text = "[mesh]\nkind = \"" + std::string(kind) + "\"\n";
        for (const InputError& error : read_case(written.add("case.toml", text)).errors) {
            EXPECT_FALSE(error.what.starts_with("kind cannot be")) << kind;
        }
    }
}

// By hand, from the manual.
TEST(AllTables, TitlesOfMessagesFindThem) {
    EXPECT_EQ(key("[[mesh.layer]]", "thickness").spec.unit, "m");
    EXPECT_EQ(key("[mesh.layer]", "thickness").need, Need::required);
    EXPECT_EQ(key("[[mesh.y]]", "to").need, Need::required);
    EXPECT_EQ(key("[material.conductivity]", "at").spec.unit, "K");
    EXPECT_EQ(key("the case", "title").form, KeyForm::text);
    EXPECT_EQ(key("[effects.road_contact]", "on").form, KeyForm::flag);
    EXPECT_EQ(key("[identify]", "noise").words, (std::vector<std::string_view>{"automatic", "correlated", "white"}));
    EXPECT_EQ(key("[drive]", "speed").spec.unit, "m s-1");
    EXPECT_EQ(key("[time]", "end").need, Need::sometimes);
}

// By hand: 2 min are 120 s; what is absent (output) and what is wrong (a negative tolerance, which is the one error) stays
// as it was. `start` is no member of the settings: its reader decides.
TEST(AllTables, ValuesGoToTheMembersThatTheirDescriptionsName) {
    using namespace toml_text;
    const TomlValue time = table_value({{"steady", boolean_value(true)},
                                        {"step", text_value("2 min")},
                                        {"method", text_value("backward_euler")},
                                        {"tolerance", text_value("-1 K")}});
    InputErrors errors;
    solver::Settings settings;
    settings.tolerance = 0.5;
    settings.output_interval = 7.0;
    TomlTable table(time, "[time]", errors);
    table.read_into(settings);
    EXPECT_TRUE(settings.steady);
    EXPECT_EQ(settings.fixed_step, 120.0);
    EXPECT_EQ(settings.method, solver::Method::backward_euler);
    EXPECT_EQ(settings.tolerance, 0.5);
    EXPECT_EQ(settings.output_interval, 7.0);
    EXPECT_EQ(settings.start, 0.0);
    EXPECT_EQ(errors.count(), 1U);
}

// Names that a user chooses are no keys: columns of a file, layers, parameters of an effect.
TEST(AllTables, NamesOfTheUserAreNone) {
    EXPECT_EQ(keys_of_table("[run.columns]"), nullptr);
    EXPECT_EQ(keys_of_table("[initial]")->find("tread"), nullptr);
    EXPECT_EQ(keys_of_table("[effects.road_contact]")->find("Hc"), nullptr);
}

}  // namespace tiretherm::input
