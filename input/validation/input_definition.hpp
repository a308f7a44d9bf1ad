// SPDX-License-Identifier: BSD-3-Clause
// [[input]] of a validation table: an input of an experiment, what it changes, and how it changes the document of a case.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "input/parameters/study_value.hpp"
#include "input/toml/toml_table.hpp"
#include "input/validation/validation.hpp"

namespace tiretherm::input {

/// What an input of an experiment changes.
enum class InputAction : std::uint8_t {
    none,     ///< nothing: a printed one that is only stated
    keys,     ///< values of the case
    signal,   ///< those entries of a column of its schedules that have the value
    parts,    ///< the lengths of parts of its schedules; what follows is shifted
    channel,  ///< which sensor a number is read from
    of_case,  ///< which case a number is read from
    time_to   ///< which share of a change a time is read at
};

/// A part of a test.
struct SchedulePart {
    double begin = 0.0;  ///< s
    double end = 0.0;    ///< s
};

/// An input of an experiment with all that the reader needs in order to change it.
struct InputDefinition {
    ValidationInput shown;
    SourceLocation place;  ///< of its value
    InputAction action = InputAction::none;
    std::vector<LocatedString> keys;   ///< paths into the case
    bool adds_keys = false;            ///< also to cases that do not give them
    std::string signal;                ///< of the schedules
    std::vector<SchedulePart> parts;   ///< ascending, each as long as the value
    std::vector<LocatedString> cases;  ///< on which it acts; empty: on all
    Measure value;                     ///< of keys, signal, parts, time_to
    std::vector<Measure> ends;         ///< in the unit of the value
    std::vector<LocatedString> words;  ///< of channel and of_case: what stands in the place of the value
};

/// One [[input]]. @param known those above it, whose names are taken
[[nodiscard]] InputDefinition read_input(TomlTable& table, const std::vector<InputDefinition>& known);

/// What an input finds in a case.
struct InputTrace {
    bool acts = false;
    std::string other_value;  ///< a value of the case that is not the input's; empty where there is none
};
/// @param document of a case   @pre the input's action changes cases: keys, signal or parts
[[nodiscard]] InputTrace find_in_case(const InputDefinition& input, const TomlValue& document);
/// Writes an end of the range of an input into the document of a case. @pre find_in_case(...).acts
void change_case(const InputDefinition& input, std::size_t end, TomlValue& document, InputErrors& errors);

/// A moment of the unchanged test, where the parts have another length.  @param t s  @param length of each part, s
[[nodiscard]] double moved_moment(double t, const std::vector<SchedulePart>& parts, double length);
/// An end of the range of parts. @returns s
[[nodiscard]] double length_of(const InputDefinition& input, std::size_t end);

}  // namespace tiretherm::input
