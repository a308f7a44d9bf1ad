// SPDX-License-Identifier: BSD-3-Clause
// Estimates from counts, with bytes as measured on sections and blocks, and the sentences for what is too large.

#include "input/model/size_limits.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

// Measured on a block of 216 000 cells and the library's sections: a run's peak over that of the smallest case, and the
// compressed files of fields and mesh.
constexpr double bytes_of_program = 40e6;
constexpr double bytes_per_cell = 2000.0;
constexpr double file_bytes_per_cell = 45.0;
constexpr double file_bytes_per_cell_and_field = 33.0;
constexpr double file_bytes_in_any_case = 150e3;
/// In results.h5 and in channels.csv.
constexpr double file_bytes_per_number = 8.0;
constexpr double bytes_per_number = 24.0;

/// Temperatures of 300 K are 6e-14 K apart in double precision, and an error is a difference of some of them.
constexpr double finest_tolerance = 1e-12;

/// Nothing for what is no amount of memory above 0.
std::optional<double> parse_bytes(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string_view unit = trim(text.substr(static_cast<std::size_t>(end - text.data())));
    constexpr std::array<std::pair<std::string_view, double>, 5> units{
        {{"B", 1.0}, {"kB", 1e3}, {"MB", 1e6}, {"GB", 1e9}, {"TB", 1e12}}};
    const auto known = std::ranges::find(units, unit, &std::pair<std::string_view, double>::first);
    const bool is_sound = error == std::errc() && known != units.end() && number > 0.0 && std::isfinite(number);
    return is_sound ? std::optional(number * known->second) : std::nullopt;
}

void read_bytes(TomlTable& table, std::string_view key, double& into) {
    if (const std::optional<std::string> text = table.text(key)) {
        const std::string_view written = trim(*text);
        const std::optional<double> bytes = parse_bytes(written);
        if (!bytes) {
            table.add_error(
                key, fmt::format("{}: \"{}\" is no amount of memory above 0", key, written),
                fmt::format("write {} = \"{}\"; the units are B, kB, MB, GB and TB", key, spell_bytes(into)));
        }
        into = bytes.value_or(into);
    }
}

std::string in_words(double count) {
    return count >= 1e10  ? fmt::format("{:.2g}", count)
           : count >= 1e6 ? fmt::format("{:.{}g} million", count * 1e-6, count >= 1e9 ? 4 : 3)
                          : fmt::format("{:.6g}", count);
}

/// Numbers that a row has in the files.
double numbers_in_a_row(const solver::Problem& problem) {
    return 2.0 * (1.0 + static_cast<double>(problem.channels.size())) +
           2.0 * static_cast<double>(problem.effects.size());
}

double pieces(const solver::Settings& settings, double interval) {
    // An interval that divides the run exactly gives no further piece by round-off.
    return std::ceil((settings.end - settings.start) / interval * (1.0 - 1e-12));
}

}  // namespace

std::string spell_bytes(double bytes) {
    constexpr std::array<std::string_view, 5> units{"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    while (bytes >= 999.5 && unit + 1 < units.size()) {
        bytes /= 1e3;
        ++unit;
    }
    return fmt::format("{:.{}g} {}", bytes, bytes >= 100.0 ? 3 : 2, units[unit]);
}

CaseSize size_of(const solver::Problem& problem) {
    const solver::Settings& settings = problem.settings;
    CaseSize size{.cells = static_cast<double>(problem.mesh.n_cells), .rows = 1.0, .fields = 1.0};
    if (!settings.steady) {
        if (const std::optional<double> longest = settings.fixed_step ? settings.fixed_step : settings.largest_step) {
            size.steps = pieces(settings, *longest);
        }
        size.rows = settings.output_interval > 0.0 ? pieces(settings, settings.output_interval) + 1.0
                                                   : size.steps.value_or(-1.0) + 1.0;
        size.fields = settings.field_interval > 0.0 ? pieces(settings, settings.field_interval) + 1.0 : 2.0;
    }
    const double nodes = static_cast<double>(problem.mesh.n_nodes);
    size.output = file_bytes_in_any_case + nodes * file_bytes_per_cell +
                  size.fields * nodes * file_bytes_per_cell_and_field +
                  size.rows * numbers_in_a_row(problem) * file_bytes_per_number;
    size.memory = bytes_of_program + nodes * bytes_per_cell +
                  size.rows * bytes_per_number * (1.0 + static_cast<double>(problem.channels.size()));
    return size;
}

SizeLimits read_limits(TomlTable& root) {
    SizeLimits limits;
    TomlTable table = root.subtable("limits");
    limits.cells = table.quantity("cells").value_or(limits.cells);
    limits.rows = table.quantity("rows").value_or(limits.rows);
    limits.steps = table.quantity("steps").value_or(limits.steps);
    read_bytes(table, "output", limits.output);
    read_bytes(table, "memory", limits.memory);
    return limits;
}

bool is_affordable(const TomlTable& mesh, double cells, const SizeLimits& limits) {
    const double memory = bytes_of_program + bytes_per_cell * cells;
    if (cells > limits.cells) {
        mesh.errors().add(mesh.place(),
                          fmt::format("the mesh has {} cells, more than {}", in_words(cells), in_words(limits.cells)),
                          fmt::format("take fewer cells, or raise the limit: [limits] cells = {:.2g}", cells * 1.1));
        return false;
    }
    if (memory > limits.memory) {
        mesh.errors().add(mesh.place(),
                          fmt::format("a run on the mesh's {} cells takes about {} of memory, more than {}",
                                      in_words(cells), spell_bytes(memory), spell_bytes(limits.memory)),
                          fmt::format("take fewer cells, or, where the machine has as much, raise the limit: [limits] "
                                      "memory = \"{}\"",
                                      spell_bytes(memory * 1.2)));
        return false;
    }
    return true;
}

std::optional<SizeExcess> excess_of(const solver::Problem& problem, const SizeLimits& limits) {
    const solver::Settings& settings = problem.settings;
    if (settings.tolerance < finest_tolerance) {
        return SizeExcess{
            "tolerance",
            fmt::format("a tolerance of {:.3g} K is below what double precision resolves", settings.tolerance),
            fmt::format("take {:g} K or more; the default is 0.001 K", finest_tolerance)};
    }
    if (settings.steady) {
        return std::nullopt;
    }
    const double latest = std::max(std::abs(settings.start), std::abs(settings.end));
    const double apart = std::nextafter(latest, std::numeric_limits<double>::infinity()) - latest;
    for (const auto& [key, interval] :
         {std::pair("step", settings.fixed_step.value_or(0.0)),
          std::pair("largest_step", settings.largest_step.value_or(0.0)), std::pair("output", settings.output_interval),
          std::pair("fields", settings.field_interval)}) {
        if (interval > 0.0 && interval < 16.0 * apart) {
            return SizeExcess{key,
                              fmt::format("{} = {:.3g} s is below what double precision resolves: times near {:.6g} s "
                                          "are {:.2g} s apart",
                                          key, interval, latest, apart),
                              "take a longer one"};
        }
    }
    const CaseSize size = size_of(problem);
    const auto raised = [](double value) { return fmt::format("{:.2g}", value * 1.1); };
    if (size.steps && *size.steps > limits.steps) {
        return SizeExcess{
            settings.fixed_step ? "step" : "largest_step",
            fmt::format("the run would take {} steps, more than {}", in_words(*size.steps), in_words(limits.steps)),
            "take a longer step, or raise the limit: [limits] steps = " + raised(*size.steps)};
    }
    if (size.rows > limits.rows) {
        return SizeExcess{
            settings.output_interval > 0.0 ? "output" : "step",
            fmt::format("the run would give {} rows, more than {}", in_words(size.rows), in_words(limits.rows)),
            "take a longer output, or raise the limit: [limits] rows = " + raised(size.rows)};
    }
    const bool by_fields =
        size.fields * static_cast<double>(problem.mesh.n_nodes) * file_bytes_per_cell_and_field > 0.5 * size.output;
    if (size.output > limits.output) {
        return SizeExcess{by_fields && settings.field_interval > 0.0 ? "fields" : "output",
                          fmt::format("the run would write about {} ({} rows, {} fields of {} cells), more than {}",
                                      spell_bytes(size.output), in_words(size.rows), in_words(size.fields),
                                      in_words(size.cells), spell_bytes(limits.output)),
                          fmt::format("take longer output and fields, or raise the limit: [limits] output = \"{}\"",
                                      spell_bytes(size.output * 1.2))};
    }
    if (size.memory > limits.memory) {
        return SizeExcess{
            "output",
            fmt::format("the run would take about {} of memory, more than {}", spell_bytes(size.memory),
                        spell_bytes(limits.memory)),
            fmt::format("take a longer output, or, where the machine has as much, raise the limit: [limits] "
                        "memory = \"{}\"",
                        spell_bytes(size.memory * 1.2))};
    }
    return std::nullopt;
}

}  // namespace tiretherm::input
