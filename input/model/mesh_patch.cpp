#include <cmath>

#include <fmt/format.h>

#include "input/model/draft.hpp"
#include "input/text/wanted.hpp"

namespace tiretherm::input {

namespace {

constexpr int most_cells_in_a_row = 1'000'000;
constexpr double most_cells = 5e6;
constexpr Wanted ratio{.unit = "1", .low = 1e-5, .high = 1e5};

/// Neighbours that differ much in size cost accuracy.
void check_growth(const Section& section, int cells, double total_ratio) {
    const double step = cells > 1 ? std::pow(std::max(total_ratio, 1.0 / total_ratio), 1.0 / (cells - 1)) : 1.0;
    if (step > 2.0) {
        section.mistakes().warn(section.place("ratio"), fmt::format("neighbouring cells differ by a factor of {:.3g}; "
                                                                    "accuracy suffers above about 1.5",
                                                                    step));
    }
}

/// The list x, y or radius. @param centred its first cell starts at minus the last `to`
std::vector<mesh::Segment> read_segments(Section& mesh, std::string_view key, bool centred) {
    std::vector<mesh::Segment> segments;
    std::vector<Place> places;
    mesh.each(
        key,
        [&](Section& section) {
            mesh::Segment segment;
            segment.to = section.quantity("to", wanted::coordinate, Need::required).value_or(std::nan(""));
            segment.cells = section.count("cells", 1, most_cells_in_a_row, Need::required).value_or(1);
            segment.ratio = section.quantity("ratio", ratio).value_or(1.0);
            check_growth(section, segment.cells, segment.ratio);
            segments.push_back(segment);
            places.push_back(section.place("to"));
        },
        Need::required, fmt::format("{} = [{{ to = \"30 mm\", cells = 8 }}]", key));
    double before = segments.empty() || !centred ? 0.0 : -segments.back().to;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (segments[i].to <= before) {
            mesh.mistakes().add(
                places[i], fmt::format("{} goes from {:.6g} mm to {:.6g} mm", key, before * 1e3, segments[i].to * 1e3),
                "let `to` ascend from segment to segment");
            return {};
        }
        before = segments[i].to;
    }
    return segments;
}

int cells(const std::vector<mesh::Segment>& segments) {
    int sum = 0;
    for (const mesh::Segment& segment : segments) {
        sum += segment.cells;
    }
    return sum;
}

bool is_affordable(const Section& mesh, std::initializer_list<int> counts) {
    double product = 1.0;
    for (const int count : counts) {
        product *= count;
    }
    if (product > most_cells) {
        mesh.mistakes().add(mesh.place(),
                            fmt::format("the mesh has {:.3g} million cells, more than {:.3g} million", product * 1e-6,
                                        most_cells * 1e-6),
                            "take fewer cells");
        return false;
    }
    return true;
}

int cells_through(const std::vector<mesh::Layer>& stack) {
    int sum = 0;
    for (const mesh::Layer& layer : stack) {
        sum += layer.cells;
    }
    return sum;
}

}  // namespace

std::vector<mesh::Layer> read_stack(Section& mesh, Draft& draft, std::vector<std::vector<Word>>* zones) {
    std::vector<mesh::Layer> stack;
    bool complete = true;
    mesh.each(
        "layer",
        [&](Section& section) {
            mesh::Layer layer;
            layer.name = section.name("name", Need::required).value_or("");
            layer.thickness = section.quantity("thickness", wanted::thickness, Need::required).value_or(0.001);
            layer.cells = section.count("cells", 1, most_cells_in_a_row, Need::required).value_or(1);
            layer.ratio = section.quantity("ratio", ratio).value_or(1.0);
            check_growth(section, layer.cells, layer.ratio);
            if (zones != nullptr) {
                zones->push_back(section.texts("zones"));
            }
            const physics::Material* material = read_material(section, "material", draft);
            complete = complete && material != nullptr;
            draft.problem.materials.push_back(material != nullptr ? *material : physics::Material{});
            for (const mesh::Layer& other : stack) {
                if (other.name == layer.name && !layer.name.empty()) {
                    section.mistake("name", fmt::format("a second layer is called \"{}\"", layer.name), "rename one");
                }
            }
            stack.push_back(std::move(layer));
        },
        Need::required);
    return complete && is_affordable(mesh, {cells_through(stack)}) ? stack : std::vector<mesh::Layer>{};
}

bool read_block(Section& mesh, Draft& draft) {
    mesh::Block block;
    block.quarter = mesh.flag("quarter").value_or(true);
    block.side_patches = mesh.flag("side_patches").value_or(false);
    block.x = read_segments(mesh, "x", !block.quarter);
    block.y = read_segments(mesh, "y", !block.quarter);
    block.stack = read_stack(mesh, draft);
    if (block.x.empty() || block.y.empty() || block.stack.empty() ||
        !is_affordable(mesh, {cells(block.x), cells(block.y), cells_through(block.stack)})) {
        return false;
    }
    draft.problem.symmetry = block.quarter ? 4.0 : 1.0;
    draft.problem.mesh = build(block);
    return true;
}

bool read_axisymmetric(Section& mesh, Draft& draft) {
    mesh::Axisymmetric disc;
    disc.side_patches = mesh.flag("side_patches").value_or(false);
    disc.radius = read_segments(mesh, "radius", false);
    disc.stack = read_stack(mesh, draft);
    if (disc.radius.empty() || disc.stack.empty() ||
        !is_affordable(mesh, {cells(disc.radius), cells_through(disc.stack)})) {
        return false;
    }
    draft.problem.mesh = build(disc);
    return true;
}

}  // namespace tiretherm::input
