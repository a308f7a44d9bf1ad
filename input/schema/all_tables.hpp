// SPDX-License-Identifier: BSD-3-Clause
// Every table that a case, a study or a table of measured numbers may have, with its keys.
#pragma once

#include <string_view>
#include <vector>

#include "input/schema/key.hpp"

namespace tiretherm::input {

/// All of them, in the order of docs/case-reference.md.
[[nodiscard]] const std::vector<TableKeys>& all_tables();

/// The keys of a table. Segments of an axis, laws of temperature and the values that a number of a table is compared with
/// are described once for all places where they stand.
/// @param title as messages call it: "[[mesh.layer]]", "the case"
/// @returns null for a table whose keys are names that the user chooses, such as columns of a file
[[nodiscard]] const TableKeys* keys_of_table(std::string_view title);

/// The tables by file of this folder, in the order of the reference.
namespace schema {

[[nodiscard]] std::vector<TableKeys> case_tables();
[[nodiscard]] std::vector<TableKeys> tire_tables();
[[nodiscard]] std::vector<TableKeys> mesh_tables();
[[nodiscard]] std::vector<TableKeys> material_tables();
[[nodiscard]] std::vector<TableKeys> effect_tables();
[[nodiscard]] std::vector<TableKeys> drive_tables();
[[nodiscard]] std::vector<TableKeys> vehicle_tables();
[[nodiscard]] std::vector<TableKeys> time_tables();
[[nodiscard]] std::vector<TableKeys> sensor_tables();
[[nodiscard]] std::vector<TableKeys> run_tables();
[[nodiscard]] std::vector<TableKeys> fit_tables();
[[nodiscard]] std::vector<TableKeys> study_tables();
[[nodiscard]] std::vector<TableKeys> validation_tables();

/// Makes a key of each form.
[[nodiscard]] inline Key value(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::value, .sentence = sentence};
}
[[nodiscard]] inline Key text(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::text, .sentence = sentence};
}
[[nodiscard]] inline Key name(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::name, .sentence = sentence};
}
[[nodiscard]] inline Key texts(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::texts, .sentence = sentence};
}
[[nodiscard]] inline Key flag(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::flag, .sentence = sentence};
}
[[nodiscard]] inline Key subtable(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::table, .sentence = sentence};
}
[[nodiscard]] inline Key tables(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::tables, .sentence = sentence};
}
[[nodiscard]] inline Key choice(std::string_view name, std::vector<std::string_view> words, std::string_view sentence) {
    return {.name = name, .form = KeyForm::choice, .sentence = sentence, .words = std::move(words)};
}
[[nodiscard]] inline Key count(std::string_view name, int low, int high, std::string_view sentence) {
    return {.name = name, .form = KeyForm::count, .sentence = sentence, .low = low, .high = high};
}
[[nodiscard]] inline Key quantity(std::string_view name, const QuantitySpec& spec, std::string_view sentence) {
    return {.name = name, .form = KeyForm::quantity, .sentence = sentence, .spec = spec};
}
[[nodiscard]] inline Key quantity_of_owner(std::string_view name, std::string_view sentence) {
    return {.name = name, .form = KeyForm::quantity_of_owner, .sentence = sentence};
}
[[nodiscard]] inline Key quantity_or_text(std::string_view name, const QuantitySpec& spec, std::string_view sentence) {
    return {.name = name, .form = KeyForm::quantity_or_text, .sentence = sentence, .spec = spec};
}
[[nodiscard]] inline Key law(std::string_view name, const QuantitySpec& spec, std::string_view sentence) {
    return {.name = name, .form = KeyForm::law, .sentence = sentence, .spec = spec};
}
/// An input of the tire, with the unit and the range of physics::signals().
[[nodiscard]] Key signal(std::string_view name, std::string_view sentence);

}  // namespace schema

}  // namespace tiretherm::input
