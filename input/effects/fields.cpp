// SPDX-License-Identifier: BSD-3-Clause
// Reads `field` and `use` of [effects.NAME]: transfers a field of a structural code to the mesh as placement weights
// and, where wanted, total watts.

#include <algorithm>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "input/effects/effects.hpp"
#include "input/effects/measured_loss.hpp"
#include "input/tables/field_file.hpp"
#include "input/text/error_limiter.hpp"

namespace tiretherm::input {

namespace {

using physics::ActiveEffect;
using physics::Field;
using physics::FieldOf;

/// All points must lie on the tire; those that do not are reported with their number and place.
bool are_on(const mesh::Mesh& mesh, std::span<const int> patches, const FieldFile& file, const std::string& shown,
            InputErrors& errors) {
    const std::size_t before = errors.count();
    ErrorLimiter limiter(errors);
    for (const FieldFrame& frame : file.frames) {
        for (const physics::Stray& stray : physics::strays(mesh, patches, frame.points)) {
            const FieldLocation spot = file.file->spot(frame.first_row + stray.point);
            limiter.add(spot.place, {stray.what + spot.aside,
                                     "leave the point out, or correct the origin or the sign of its coordinates"});
        }
    }
    limiter.close(shown);
    return errors.count() == before;
}

/// What the nodes have of every frame. W, or what is proportional to it
std::vector<std::vector<double>> transferred(const mesh::Mesh& mesh, std::span<const int> patches,
                                             const FieldFile& file, std::vector<int>& nodes) {
    std::vector<std::vector<double>> found;
    physics::FieldTransfer transfer;
    const FieldFrame* last = nullptr;
    for (const FieldFrame& frame : file.frames) {
        // Most files have one grid for all frames: its points are looked up once.
        if (last == nullptr || frame.points != last->points) {
            transfer = patches.empty() ? physics::onto_cells(mesh, frame.points)
                                       : physics::onto_faces(mesh, patches, frame.points);
        }
        last = &frame;
        found.push_back(transfer.watts(frame.density));
    }
    nodes = transfer.nodes;
    return found;
}

/// The mean over a revolution takes the place of the frames.
void average(const FieldFile& file, std::vector<std::vector<double>>& frames) {
    const std::vector<double> shares = file.shares_of_revolution();
    std::vector<double> mean(frames.front().size());
    // A revolution is short against the spread of heat to the next cell: the mean over it acts.
    for (std::size_t k = 0; k < frames.size(); ++k) {
        for (std::size_t i = 0; i < mean.size(); ++i) {
            mean[i] += shares[k] * frames[k][i];
        }
    }
    frames = {std::move(mean)};
}

/// Frames as shares and totals. @returns the first frame that is zero everywhere, frames.size() when none is
std::size_t normalise(const std::vector<std::vector<double>>& frames, Field& field) {
    std::size_t empty = frames.size();
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const double total = std::accumulate(frames[k].begin(), frames[k].end(), 0.0);
        std::vector<double> weights = frames[k];
        for (double& weight : weights) {
            weight = total > 0.0 ? weight / total : 1.0 / static_cast<double>(weights.size());
        }
        empty = total > 0.0 ? empty : std::min(empty, k);
        field.weights.push_back(std::move(weights));
        field.watts.push_back(total);
    }
    return empty;
}

/// What a field stands in for, and what cannot stand beside it.
void check_rivals(TomlTable& table, const ActiveEffect& active) {
    const std::string_view id = active.effect->id;
    if (std::ranges::any_of(active.tables, [](const auto& curve) { return curve.has_value(); })) {
        table.add_error("field", fmt::format("{} has a profile and a field, which both place its heat", id),
                        "remove one of them");
    }
    const auto number = [&](std::string_view key) {
        const int index = physics::find_parameter(*active.effect, key);
        return index < 0 ? 0.0 : active[static_cast<std::size_t>(index)];
    };
    if (active.effect->field() == FieldOf::loss && (!active.overrides.empty() || number("belt_edge_gain") != 0.0)) {
        table.add_error("field", "the field replaces the weights of layers, zones and belt edges",
                        "remove belt_edge_gain and the tables _by_layer and _by_zone, or the field");
    }
}

/// Watts of a file are taken as they are: what else the effect knows about its heat is ignored, but for the share of
/// friction that the tire takes.
void warn_of_idle_keys(const TomlTable& table, const ActiveEffect& active) {
    const auto warn = [&](std::string_view key) {
        if (table.has(key)) {
            table.errors().warn(table.place(key),
                                "{} is ignored: the field gives the watts; use = \"shape\" lets it scale them", key);
        }
    };
    for (const physics::ParameterSpec& parameter : active.effect->parameters) {
        if (parameter.key != "partition") {
            warn(parameter.key);
        }
    }
    for (const physics::Choice& choice : active.effect->choices) {
        if (choice.key != "partition") {
            warn(choice.key);
        }
    }
}

class FieldBinder {
public:
    FieldBinder(TomlTable& table, solver::Problem& problem, ActiveEffect& active)
        : table_(table), problem_(problem), active_(active), errors_(table.errors()) {}

    void bind() {
        const std::optional<std::string> name = table_.text("field");
        const bool by_watts = active_.effect->field() != FieldOf::pressure && table_.choice("use") == 1U;
        if (!table_.has("field") && table_.has("use")) {
            table_.add_error("use", "use needs a field, and there is none", "add field = \"....h5\"");
        }
        if (!name || problem_.mesh.n_nodes == 0) {
            return;
        }
        const std::size_t before = errors_.count();
        if (by_watts) {
            warn_of_idle_keys(table_, active_);
        }
        check_rivals(table_, active_);
        const mesh::Mesh& mesh = problem_.mesh;
        if (active_.effect->field() == FieldOf::loss && mesh.is_lumped()) {
            table_.add_error("field", "a field of the loss needs cells, and this mesh has two lumps",
                             "take layers or section");
            return;
        }
        if (mesh.is_ring()) {
            table_.add_error("field", "a field goes onto a section, not onto a ring", "remove sectors from [mesh]");
            return;
        }
        const SourceLocation mentioned = table_.place("field");
        const std::optional<FieldFile> file = read_field_file(
            errors_.beside(mentioned, *name), mentioned, active_.effect->field(), by_watts, mesh.is_section(), errors_);
        if (file && fits(*file, *name) && errors_.count() == before) {
            take(*file, by_watts, *name);
        }
    }

private:
    /// The faces of the effect's patches, none for the cells.
    [[nodiscard]] std::span<const int> patches() const {
        return active_.effect->field() == FieldOf::loss ? std::span<const int>() : active_.patches;
    }

    bool fits(const FieldFile& file, const std::string& name) {
        if (file.against == FieldFile::Against::time && active_.effect->heat_effect()->frame_coefficients == 0) {
            table_.add_error("field", fmt::format("{} cannot follow a field against time", active_.effect->id),
                             "give it against wheel_angle, or as one frame without time");
        }
        if (file.against == FieldFile::Against::time && file.frames.size() > physics::most_frames) {
            table_.add_error(
                "field",
                fmt::format("{} has {} frames; {} is the most", name, file.frames.size(), physics::most_frames),
                "leave out frames: between two of them the field is taken along a straight line");
        }
        return are_on(problem_.mesh, patches(), file, name, errors_);
    }

    void take(const FieldFile& file, bool by_watts, const std::string& name) {
        auto field = std::make_shared<Field>();
        std::vector<std::vector<double>> frames = transferred(problem_.mesh, patches(), file, field->nodes);
        if (file.against == FieldFile::Against::wheel_angle) {
            average(file, frames);
        }
        const std::size_t empty = normalise(frames, *field);
        if (empty < frames.size() && !by_watts) {
            const FieldLocation spot = file.file->spot(file.frames[empty].first_row);
            errors_.add(frames.size() == 1 ? table_.place("field") : spot.place,
                        fmt::format("{} is zero everywhere{}: it gives no shape", name,
                                    frames.size() == 1 ? "" : " in this frame" + spot.aside),
                        "leave the frame out, or take use = \"watts\"");
            return;
        }
        if (!by_watts) {
            field->watts.clear();
        }
        if (frames.size() > 1) {
            std::vector<double> times;
            std::ranges::transform(file.frames, std::back_inserter(times), &FieldFrame::at);
            problem_.input_signals.add_sample_times(times);
            const double start = problem_.settings.start;
            std::ranges::transform(times, std::back_inserter(field->time), [&](double t) { return t - start; });
            active_.effect = &physics::in_frames(*active_.effect);
        }
        active_.field = std::move(field);
    }

    TomlTable& table_;
    solver::Problem& problem_;
    ActiveEffect& active_;
    InputErrors& errors_;
};

}  // namespace

std::vector<std::string> read_fields(TomlTable& root, const GivenSignals& given, solver::Problem& problem) {
    std::vector<std::string> over;
    for (ActiveEffect& active : problem.effects) {
        const TomlValue* node = root.content().find({"effects", active.effect->id});
        if (active.effect->field() == FieldOf::nothing || node == nullptr || node->kind != TomlValue::Kind::table) {
            continue;
        }
        TomlTable table(*node, fmt::format("[effects.{}]", active.effect->id), root.errors());
        table.allow_unknown_keys();  // its other keys have been read
        FieldBinder(table, problem, active).bind();
        if (active.effect->field() == FieldOf::loss) {
            std::ranges::move(read_measured_loss(table, problem.input_signals, given, active),
                              std::back_inserter(over));
        }
    }
    return over;
}

}  // namespace tiretherm::input
