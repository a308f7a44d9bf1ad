// SPDX-License-Identifier: BSD-3-Clause
// Order and headings of the TOML tables of a converted case, and the way back from a line of text to its cell.

#include <array>

#include <fmt/format.h>

#include "input/spreadsheet/sheet_body.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

/// A table of a case and what stands at its head.
struct Head {
    std::string_view table;
    std::string_view text;
};
constexpr std::array heads{
    Head{"", ""},
    Head{"tire", "[tire]\n"},
    Head{"tire.modulus", "[tire.modulus]  # behind the cornering stiffness\n"},
    Head{"mesh", "[mesh]\nkind = \"two_node\"\nmaterial = \"rubber\"\n"},
    Head{"material", "[[material]]\nname = \"rubber\"\n"},
    Head{"effects.strain_energy_loss", "[effects.strain_energy_loss]\n"},
    Head{"effects.sliding_friction", "[effects.sliding_friction]\n"},
    Head{"effects.air_convection",
         "[effects.air_convection]\nexponential = \"on\"                  # thesis (33) as printed\n"},
    Head{"effects.road_contact", "[effects.road_contact]\n"},
    Head{"effects.conduction", "[effects.conduction]\n"},
    Head{"drive", "[drive]\n"},
    Head{"initial", "[initial]\n"},
    Head{"time", "[time]\n"},
    Head{"sensor.surface_temperature", "[[sensor]]\nname = \"surface_temperature\"\nkind = \"region\"\n"},
    Head{"sensor.bulk_temperature", "[[sensor]]\nname = \"bulk_temperature\"\nkind = \"region\"\n"},
    Head{"sensor.cornering_stiffness", "[[sensor]]\nname = \"cornering_stiffness\"\n"},
};

}  // namespace

std::vector<SheetBody::Line> SheetBody::lines() const {
    std::vector<Line> all;
    for (const Head& head : heads) {
        bool open = false;
        for (const Entry& entry : entries_) {
            if (entry.table != head.table) {
                continue;
            }
            if (!open && !head.text.empty()) {
                all.push_back({"", nullptr, {}});
                std::string_view rest = head.text;
                for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
                    all.push_back({std::string(rest.substr(0, end)), nullptr, {}});
                    rest.remove_prefix(end + 1);
                }
            }
            open = true;
            for (std::size_t i = 0; i < entry.lines.size(); ++i) {
                std::string text = i == 0 ? fmt::format("{} = {}", entry.key, entry.lines[i]) : entry.lines[i];
                text += i == 0 && !entry.remark.empty() ? "  # " + printable(entry.remark) : "";
                all.push_back({std::move(text), &entry, entry.places[i]});
            }
        }
    }
    return all;
}

std::string SheetBody::text() const {
    std::string text;
    for (const Line& line : lines()) {
        text += line.text + "\n";
    }
    return text;
}

const SheetBody::Entry* SheetBody::entry_at(int line) const {
    const std::vector<Line> all = lines();
    return line > 0 && static_cast<std::size_t>(line) <= all.size() ? all[static_cast<std::size_t>(line) - 1].entry
                                                                    : nullptr;
}

SourceLocation SheetBody::place_at(int line) const {
    const std::vector<Line> all = lines();
    return line > 0 && static_cast<std::size_t>(line) <= all.size() ? all[static_cast<std::size_t>(line) - 1].place
                                                                    : SourceLocation{};
}

}  // namespace tiretherm::input
