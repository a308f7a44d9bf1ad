#include "input/effects/measured_loss.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "input/effects/resistance_table.hpp"
#include "input/text/wanted.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;
using physics::MeasuredLoss;

/// What is measured over must be among the inputs.
void need(Section& section, std::string_view key, const std::string& signal, Draft& draft) {
    draft.followed.push_back(signal);
    const physics::Signal& input = *physics::find_signal(signal);
    if (!draft.problem.drive.gives(input) && !draft.given.contains(signal)) {
        section.mistake(key, fmt::format("[drive] lacks {}, over which the loss was measured", signal),
                        fmt::format("add {} = {} to [drive]", signal, spell_example(wanted::of(input))));
    }
}

/// Beyond the table its end is held: the user is told where the drive goes there.
void warn_beyond(const Section& section, const physics::Signal& signal, const std::vector<double>& at,
                 const solver::Drive& drive) {
    double low = drive.constants().*signal.member;
    double high = low;
    for (const solver::Series& series : drive.series()) {
        if (series.signal == &signal) {
            low = *std::ranges::min_element(series.value);
            high = *std::ranges::max_element(series.value);
        }
    }
    const bool below = signal.name != "speed" && signal.name != "vertical_load" && low < at.front();
    if (below || high > at.back()) {
        section.mistakes().warn(section.place("total"),
                                fmt::format("{} goes from {:.6g} to {:.6g} {}, the table from {:.6g} to {:.6g}: beyond "
                                            "its ends the table is held",
                                            signal.name, low, high, signal.unit, at.front(), at.back()));
    }
}

std::optional<MeasuredLoss> read_table(Section& section, const std::string& name, Draft& draft) {
    const Place mentioned = section.place("total");
    const fs::path beside = fs::path(section.mistakes().file(mentioned.file)).parent_path();
    std::optional<ResistanceFile> file =
        read_resistance_table((beside / name).lexically_normal(), mentioned, section.mistakes());
    if (!file) {
        return std::nullopt;
    }
    MeasuredLoss loss;
    for (std::size_t a = 0; a < file->names.size(); ++a) {
        const std::vector<double>& at = file->table.axes[a].at;
        if (file->table.axes[a].input == nullptr) {
            loss.bulk_temperatures = at;
            if (at.size() > physics::most_temperatures) {
                section.mistake("total", fmt::format("the table has {} temperatures; {} are the most", at.size(),
                                                     physics::most_temperatures));
            }
            continue;
        }
        need(section, "total", file->names[a], draft);
        warn_beyond(section, *physics::find_signal(file->names[a]), at, draft.problem.drive);
    }
    loss.table = std::move(file->table);
    return loss;
}

/// A unit of the fit in SI.
double unit_of_fit(Section& fit, std::string_view key, const Wanted& wanted, std::string_view standard) {
    const std::string unit = fit.text(key).value_or(std::string(standard));
    const UnitRead read = read_unit(unit, wanted, fmt::format("{} is [{}]", key, unit));
    if (read.fault) {
        fit.mistake(key, read.fault->what, fmt::format("write {} = \"{}\"", key, standard));
    }
    return read.conversion.factor;
}

MeasuredLoss read_coastdown(Section& section, Draft& draft) {
    Section fit = section.section("coastdown");
    const auto number = [&](std::string_view key, double low, double high) {
        return fit.quantity(key, {.unit = "1", .low = low, .high = high}, Need::required).value_or(0.0);
    };
    physics::CoastdownFit found;
    found.law = {.pressure_exponent = number("alpha", -5.0, 5.0),
                 .load_exponent = number("beta", -5.0, 5.0),
                 .constant = number("a", 0.0, 1e12),
                 .linear = number("b", -1e12, 1e12),
                 .quadratic = number("c", -1e12, 1e12)};
    found.pressure_unit = unit_of_fit(fit, "pressure_unit", {.unit = "Pa"}, "kPa");
    found.load_unit = unit_of_fit(fit, "load_unit", {.unit = "N"}, "N");
    found.speed_unit = unit_of_fit(fit, "speed_unit", {.unit = "m s-1"}, "km/h");
    found.force_unit = unit_of_fit(fit, "force_unit", {.unit = "N"}, "N");
    need(section, "coastdown", "inflation_pressure", draft);
    return {.coastdown = found, .table = {}};
}

}  // namespace

void read_measured_loss(Section& section, Draft& draft, physics::ActiveEffect& active) {
    const std::size_t before = section.mistakes().count();
    const std::optional<std::string> table = section.text("total");
    const bool fitted = section.has("coastdown");
    if (!table && !fitted) {
        return;
    }
    const std::string_view key = table ? "total" : "coastdown";
    if (table && fitted) {
        section.mistake("coastdown", "the loss is measured twice: total and coastdown", "remove one of them");
    }
    if (active.choices.front() == 1) {
        section.mistake(key, "a measured total knows the bulk's temperature at most, and temperature is \"local\"",
                        "remove temperature = \"local\"");
    }
    if (active.field && !active.field->watts.empty()) {
        section.mistake(key, "the field gives the watts already", "write use = \"shape\", or remove one of them");
    }
    std::optional<MeasuredLoss> loss = table ? read_table(section, *table, draft) : read_coastdown(section, draft);
    if (loss && section.mistakes().count() == before) {
        if (loss->bulk_temperatures.size() > 1 && active.effect->n_intensities < active.effect->frame_intensities) {
            active.effect = &physics::in_frames(*active.effect);
        }
        active.total = std::make_shared<const MeasuredLoss>(std::move(*loss));
    }
}

}  // namespace tiretherm::input
