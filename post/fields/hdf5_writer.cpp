// SPDX-License-Identifier: BSD-3-Clause
// Lays out case, mesh, channels, heat budget and fields in the file, holds back a few hundred rows at most, and
// registers the format "hdf5".

#include "post/fields/hdf5_writer.hpp"

#include <array>

#include <fmt/format.h>

namespace tiretherm::post {

namespace {

/// Rows that are held back. Counted in rows, not in seconds, so that equal runs make equal files.
constexpr std::size_t most_waiting = 256;

std::vector<double> coordinates(const std::vector<mesh::Point>& points) {
    std::vector<double> flat;
    for (const mesh::Point& point : points) {
        flat.insert(flat.end(), point.begin(), point.end());
    }
    return flat;
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& path, const solver::Problem& problem, const Provenance& provenance)
    : problem_(problem),
      source_(fmt::format("case {}, tiretherm {}", problem.name, provenance.version)),
      path_(path),
      file_(path) {
    file_.add_attribute("/", "format", "tiretherm results 1");
    write_case(provenance);
    write_mesh();
    add_columns();
    file_.flush();
}

void Hdf5Writer::write_case(const Provenance& provenance) {
    file_.add_group("/case");
    const auto text = [&](const std::string& name, const std::string& value, const std::string& meaning) {
        file_.write("/case/" + name, value, {.units = "1", .long_name = meaning, .source = source_, .coordinates = {}});
    };
    text("name", problem_.name, "name of the case");
    text("title", problem_.title, "title of the case");
    text("tiretherm_version", provenance.version, "version of tiretherm that wrote this file");
    text("file", provenance.case_file, "file the case was read from");
    text("text", provenance.case_text, "text of that file");
    file_.write("/case/source", problem_.sources,
                {.units = "1", .long_name = "what to cite", .source = source_, .coordinates = {}});
}

void Hdf5Writer::write_mesh() {
    const mesh::Mesh& mesh = problem_.mesh;
    const mesh::Metric metric = mesh.grid ? mesh.grid->metric : mesh::Metric::cartesian;
    file_.add_group("/mesh");
    file_.add_attribute("/mesh", "kind", mesh.kind);
    file_.add_attribute("/mesh", "metric", std::string(name_of(metric)));
    file_.add_attribute("/mesh", "n_cells", mesh.n_cells);
    file_.add_attribute("/mesh", "sectors", mesh.sectors);
    file_.add_attribute("/mesh", "symmetry", problem_.symmetry);
    const auto label = [&](const char* units, const char* meaning, const char* along = "") {
        return Label{.units = units, .long_name = meaning, .source = source_, .coordinates = along};
    };
    file_.write(
        "/mesh/centre", coordinates(mesh.centre), 3,
        label("m", metric == mesh::Metric::axisymmetric ? "radius, 0 and depth of each node"
                   : !mesh.is_section()                 ? "x, y and depth of each node"
                   : !mesh.is_ring()                    ? "arc length along the meridian, 0 and depth of each node"
                                     : "arc length along the meridian, arc around the tire and depth of each node"));
    file_.write("/mesh/volume", mesh.volume, 0,
                label("m3",
                      mesh.is_section() ? "volume of each node, 0 on a surface: of the unrolled "
                                          "meridian, some per cent more than the drawn ring"
                                        : "volume of each node, 0 on a surface",
                      "/mesh/centre"));
    file_.write("/mesh/layer", mesh.layer, 0, label("1", "layer of each node, counted from 0", "/mesh/centre"));
    file_.write("/mesh/layer_name", mesh.layers, label("1", "name of each layer, from the outside in"));
    if (!mesh.zones.empty()) {
        file_.write("/mesh/zone", mesh.zone, 0, label("1", "zone of each node, counted from 0", "/mesh/centre"));
        file_.write("/mesh/zone_name", mesh.zones, label("1", "name of each zone, from outboard to inboard"));
    }
    std::vector<std::string> lumped_node_names;
    for (const mesh::LumpedNode& node : mesh.lumped_nodes) {
        lumped_node_names.push_back(node.name);
    }
    if (!lumped_node_names.empty()) {
        file_.write("/mesh/lumped_node_name", lumped_node_names,
                    label("1", "names of the last nodes, which are no places"));
        file_.add_link("/mesh/appended_name", "/mesh/lumped_node_name");  // its name before 0.3
    }
    file_.write("/mesh/point", coordinates(mesh.drawing.points), 3, label("m", "corner points for drawing, z upwards"));
    file_.write("/mesh/corners", mesh.drawing.corners,
                static_cast<std::size_t>(mesh::corners_per_cell(mesh.drawing.shape)),
                label("1", "rows of /mesh/point at the corners of each cell, in the order of VTK"));
}

Hdf5Writer::Column Hdf5Writer::column(const std::string& path, std::size_t width, const Label& label) {
    return {.rows = file_.add_rows(path, width, label), .waiting = {}};
}

void Hdf5Writer::add_columns() {
    const auto label = [&](const char* units, const std::string& meaning, const char* along) {
        return Label{.units = units, .long_name = meaning, .source = source_, .coordinates = along};
    };
    file_.add_group("/channels");
    channels_.push_back(column("/channels/time", 0, label("s", "time of each row", "")));
    for (const solver::Channel& channel : problem_.channels) {
        const std::string& meaning = channel.meaning.empty() ? channel.name : channel.meaning;
        channels_.push_back(
            column("/channels/" + channel.name, 0,
                   label(std::string(solver::unit_of(channel.quantity)).c_str(), meaning, "/channels/time")));
    }

    file_.add_group("/inputs");
    for (const physics::Signal& signal : physics::signals()) {
        if (problem_.input_signals.gives(signal)) {
            inputs_.push_back(&signal);
            channels_.push_back(
                column(fmt::format("/inputs/{}", signal.name), 0,
                       label(std::string(signal.unit).c_str(), std::string(signal.meaning), "/channels/time")));
        }
    }

    file_.add_group("/heat_budget");
    file_.add_link("/ledger", "/heat_budget");  // its name before 0.3
    file_.add_attribute("/heat_budget", "symmetry", problem_.symmetry);
    std::vector<std::string> effects;
    for (const physics::ActiveEffect& active : problem_.effects) {
        effects.emplace_back(active.title());
    }
    file_.write("/heat_budget/effect", effects, label("1", "name of each effect", ""));
    const std::string whole = "the whole specimen, positive into it";
    heat_budget_.push_back(
        column("/heat_budget/watts", effects.size(),
               label("W", "heat attributed to each effect, of " + whole, "/channels/time /heat_budget/effect")));
    heat_budget_.push_back(
        column("/heat_budget/joules", effects.size(),
               label("J", "heat of each effect since the start, of " + whole, "/channels/time /heat_budget/effect")));
    heat_budget_.push_back(
        column("/heat_budget/stored", 0, label("J", "heat stored since the start in " + whole, "/channels/time")));

    file_.add_group("/field");
    field_.push_back(column("/field/time", 0, label("s", "time of each stored field", "")));
    field_.push_back(column("/field/temperature", static_cast<std::size_t>(problem_.mesh.n_nodes),
                            label("K", "temperature of each node", "/field/time /mesh/centre")));
}

void Hdf5Writer::take(const solver::Snapshot& snapshot) {
    channels_[0].waiting.push_back(snapshot.time);
    for (std::size_t c = 0; c < snapshot.channels.size(); ++c) {
        channels_[c + 1].waiting.push_back(snapshot.channels[c]);
    }
    const physics::Inputs inputs = problem_.input_signals.at(snapshot.time, solver::JumpSide::before);
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
        channels_[snapshot.channels.size() + 1 + i].waiting.push_back(inputs.*inputs_[i]->member);
    }
    for (std::size_t e = 0; e < problem_.effects.size(); ++e) {
        heat_budget_[0].waiting.push_back(problem_.symmetry * snapshot.watts[e]);
        heat_budget_[1].waiting.push_back(problem_.symmetry * snapshot.joules[e]);
    }
    heat_budget_[2].waiting.push_back(problem_.symmetry * snapshot.stored);
    if (snapshot.field) {
        field_[0].waiting.push_back(snapshot.time);
        field_[1].waiting.assign(snapshot.temperature.begin(), snapshot.temperature.end());
    }
    if (snapshot.field || channels_[0].waiting.size() >= most_waiting) {
        flush();
    }
}

void Hdf5Writer::flush() {
    for (std::vector<Column>* group : {&channels_, &heat_budget_, &field_}) {
        for (Column& column : *group) {
            file_.append(column.rows, column.waiting);
            column.waiting.clear();
        }
    }
    file_.flush();
}

void Hdf5Writer::finish() {
    flush();
    file_.close();
}

namespace formats {

extern const OutputFormat hdf5;
const OutputFormat hdf5{
    .name = "hdf5",
    .use = OutputFormat::Use::always,
    .help = "results.h5: everything, SI units",
    .open = [](const RunTarget& target) -> std::unique_ptr<RunOutput> {
        return std::make_unique<Hdf5Writer>(target.directory / "results.h5", target.problem, target.provenance);
    },
    .names_in = [](const std::filesystem::path&) -> std::vector<std::string> { return {"results.h5"}; }};

}  // namespace formats

}  // namespace tiretherm::post
