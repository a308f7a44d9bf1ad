#include <algorithm>

#include <fmt/format.h>

#include "input/model/draft.hpp"
#include "input/model/law.hpp"
#include "input/text/wanted.hpp"
#include "input/text/words.hpp"

namespace tiretherm::input {

namespace {

using physics::Curve;

std::size_t index(mesh::Axis axis) { return static_cast<std::size_t>(axis); }

}  // namespace

void read_materials(Section& root, Draft& draft) {
    root.each(
        "material",
        [&](Section& section) {
            Stock stock{.material = {}, .table = &section.table()};
            physics::Material& material = stock.material;
            material.name = section.name("name", Need::required).value_or("");
            material.density = section.quantity("density", wanted::density, Need::required).value_or(material.density);
            const Curve none = Curve::constant(1.0);
            material.heat_capacity =
                read_law(section, "heat_capacity", wanted::heat_capacity, Need::required).value_or(none);
            const Curve through =
                read_law(section, "conductivity", wanted::conductivity, Need::required).value_or(none);
            material.conductivity[index(mesh::Axis::through)] = through;
            material.conductivity[index(mesh::Axis::meridian)] =
                read_law(section, "conductivity_meridian", wanted::conductivity, Need::optional).value_or(through);
            material.conductivity[index(mesh::Axis::circumference)] =
                read_law(section, "conductivity_circumference", wanted::conductivity, Need::optional).value_or(through);
            const auto same = std::find_if(draft.stock.begin(), draft.stock.end(),
                                           [&](const Stock& other) { return other.material.name == material.name; });
            if (same != draft.stock.end() && !material.name.empty()) {
                section.mistake("name",
                                fmt::format("a second material is called \"{}\"; the first is at {}", material.name,
                                            section.mistakes().spell(same->table->place)),
                                "rename or remove one");
                return;
            }
            draft.stock.push_back(std::move(stock));
        },
        Need::required);
}

const physics::Material* read_material(Section& section, std::string_view key, Draft& draft) {
    const std::optional<std::string> name = section.text(key, Need::required);
    if (!name) {
        return nullptr;
    }
    std::vector<std::string> known;
    for (Stock& stock : draft.stock) {
        if (stock.material.name == *name) {
            stock.used = true;
            return &stock.material;
        }
        known.push_back(stock.material.name);
    }
    section.mistake(key, fmt::format("there is no material \"{}\"", *name), suggest(*name, known, "materials"));
    return nullptr;
}

}  // namespace tiretherm::input
