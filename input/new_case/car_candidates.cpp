// SPDX-License-Identifier: BSD-3-Clause
// Ranks the rules for cars, and finds where names leave open which sensor is which.
#include "input/new_case/car_candidates.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "input/loggers/logger_units.hpp"
#include "input/new_case/column_words.hpp"
#include "input/text/characters.hpp"
#include "input/text/column_names.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

constexpr int behind_all = 1000;  ///< of a rank

}  // namespace

bool has_unit_for(const Heading& heading, const ColumnMeaning* meaning) {
    const QuantitySpec& spec = meaning == nullptr ? quantity_specs::temperature : meaning->spec;
    return !heading.unit || trim(*heading.unit).empty() || (meaning != nullptr && meaning->any_unit) ||
           !read_heading_unit(heading, spec).error || !guess_unit(*heading.unit, spec.unit, spec.scale).empty();
}

std::vector<CarCandidate> car_candidates(const std::vector<LogColumn>& columns,
                                         const std::vector<ColumnMeaning>& meanings) {
    std::vector<CarCandidate> candidates;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Heading& heading = columns[i].heading;
        if (columns[i].is_used() || !columns[i].reason.empty() || !is_printable(heading.name)) {
            continue;
        }
        for (CarColumn& is : car_columns(heading)) {
            const ColumnMeaning* meaning = find_meaning(meanings, is.name);
            if (!has_unit_for(heading, meaning)) {
                continue;
            }
            if (meaning != nullptr && meaning->any_unit && !is_pressure(heading)) {
                is.rank += behind_all;  // volts of a brake's sensor come after its bar
            }
            candidates.push_back({i, std::move(is)});
        }
    }
    std::ranges::stable_sort(candidates, {}, [](const CarCandidate& candidate) { return candidate.is.rank; });
    return candidates;
}

int name_arrays(std::vector<CarCandidate>& candidates) {
    int zones = 0;
    std::map<std::string, std::map<int, std::vector<CarCandidate*>>> places;
    for (CarCandidate& candidate : candidates) {
        if (candidate.is.place) {
            places[candidate.is.corner][*candidate.is.place].push_back(&candidate);
        }
    }
    for (auto& [corner, by_number] : places) {
        const int first = by_number.begin()->first;
        const int count = by_number.rbegin()->first - first + 1;
        const bool whole = first <= 1 && count > 1 && std::cmp_equal(count, by_number.size()) &&
                           (zones == 0 || zones == count) &&
                           std::ranges::all_of(by_number, [](const auto& one) { return one.second.size() == 1; });
        zones = whole ? count : zones;
        if (by_number.size() == 1 && by_number.begin()->second.size() == 1) {
            continue;  // a number in the name of the only sensor
        }
        for (auto& [number, columns] : by_number) {
            for (CarCandidate* candidate : columns) {
                if (whole) {
                    candidate->is.name = fmt::format("infrared_{}", number - first + 1);
                } else {
                    candidate->is.question = "which place across the tread?";
                }
            }
        }
    }
    return zones;
}

void ask_about_equals(std::vector<CarCandidate>& candidates) {
    const auto meant = [](const CarCandidate& one) { return std::make_tuple(one.is.name, one.is.corner, one.is.rank); };
    std::map<decltype(meant(candidates.front())), std::set<std::size_t>> columns;
    for (const CarCandidate& one : candidates) {
        columns[meant(one)].insert(one.column);
    }
    for (CarCandidate& one : candidates) {
        if (one.is.name.ends_with("surface_temperature") && one.is.question.empty() &&
            columns.at(meant(one)).size() > 1) {
            one.is.question = "which of several across the tread?";
        }
    }
}

}  // namespace tiretherm::input
