// SPDX-License-Identifier: BSD-3-Clause
// Hashes a problem field by field, and turns a prediction into numbers and back.

#include "solver/sensitivity/kept_results.hpp"

#include <algorithm>
#include <atomic>

namespace tiretherm::solver {

namespace {

std::atomic<KeptResults*> in_use = nullptr;

void add(Digest& digest, const mesh::Functional& functional) {
    digest.add(functional.nodes);
    digest.add(functional.weights);
}

void add(Digest& digest, const std::vector<std::string>& texts) {
    digest.add(texts.size());
    for (const std::string& text : texts) {
        digest.add(text);
    }
}

void add(Digest& digest, const mesh::Point& point) {
    for (const double coordinate : point) {
        digest.add(coordinate);
    }
}

void add_parts(Digest& digest, const mesh::Mesh& mesh) {
    for (const mesh::Link& link : mesh.links) {
        digest.add(link.length);
        digest.add(link.region);
    }
    for (const mesh::Patch& patch : mesh.patches) {
        digest.add(patch.name);
        digest.add(patch.faces.size());
        for (const mesh::PatchFace& face : patch.faces) {
            digest.add(face.node);
            digest.add(face.cell);
            digest.add(face.area);
            add(digest, face.centre);
        }
    }
    for (const mesh::Region& region : mesh.regions) {
        digest.add(region.name);
        add(digest, region.mean);
    }
    for (const mesh::LumpedNode& lump : mesh.lumped_nodes) {
        digest.add(lump.name);
        digest.add(lump.node);
    }
    digest.add(mesh.sectors);
    digest.add(mesh.columns.size());
}

void add(Digest& digest, const mesh::Mesh& mesh) {
    digest.add(mesh.kind);
    digest.add(mesh.n_cells);
    digest.add(mesh.n_nodes);
    digest.add(mesh.volume);
    for (const mesh::Point& centre : mesh.centre) {
        add(digest, centre);
    }
    digest.add(mesh.layer);
    digest.add(mesh.zone);
    add(digest, mesh.layers);
    add(digest, mesh.zones);
    digest.add(mesh.faces.size());
    for (const mesh::Face& face : mesh.faces) {
        digest.add(face.a);
        digest.add(face.b);
        digest.add(face.area);
        digest.add(face.half_a);
        digest.add(face.half_b);
        digest.add(face.axis);
        digest.add(face.link);
        digest.add(face.is_coupling);
    }
    add_parts(digest, mesh);
}

void add(Digest& digest, const physics::Curve& curve) {
    for (const double coefficient : curve.coefficients()) {
        digest.add(coefficient);
    }
    digest.add(curve.table_x());
    digest.add(curve.table_y());
}

void add(Digest& digest, const physics::ActiveEffect& active) {
    digest.add(active.effect->id);
    digest.add(active.name);
    digest.add(active.parameters);
    for (const std::optional<physics::Curve>& table : active.tables) {
        digest.add(table.has_value());
        if (table) {
            add(digest, *table);
        }
    }
    for (const std::vector<int>* indices :
         {&active.choices, &active.patches, &active.layers, &active.channels, &active.lumped_nodes,
          &active.coupling_faces, &active.nodes, &active.groups}) {
        digest.add(*indices);
    }
    digest.add(active.overrides.size());
    for (const physics::ActiveEffect::Override& other : active.overrides) {
        digest.add(other.scope);
        digest.add(other.index);
        digest.add(other.parameter);
        digest.add(other.value);
    }
    digest.add(active.weights);
    digest.add(active.skew);
    digest.add(active.total != nullptr);
    digest.add(active.field != nullptr);
    if (active.field) {
        digest.add(active.field->nodes);
        digest.add(active.field->time);
        digest.add(active.field->watts);
        digest.add(active.field->weights);
    }
}

void add(Digest& digest, const InputSignals& signals) {
    for (const physics::Signal& signal : physics::signals()) {
        digest.add(signals.gives(signal));
        digest.add(signals.constants().*signal.member);
    }
    digest.add(signals.at(0.0, JumpSide::before).time);  // the run's start
    digest.add(signals.series().size());
    for (const Series& series : signals.series()) {
        digest.add(series.signal->name);
        digest.add(std::span<const double>(series.time));
        digest.add(std::span<const double>(series.value));
        digest.add(series.logged);
    }
    digest.add(signals.stops());
    digest.add(signals.samples());
}

void add(Digest& digest, const Settings& settings) {
    digest.add(settings.steady);
    digest.add(settings.start);
    digest.add(settings.end);
    digest.add(settings.method);
    digest.add(settings.fixed_step.value_or(-1.0));
    digest.add(settings.largest_step.value_or(-1.0));
    digest.add(settings.tolerance);
    digest.add(settings.output_interval);
    digest.add(settings.field_interval);
    digest.add(settings.linear_solver);
}

void add(Digest& digest, const FreeParameter& parameter) {
    digest.add(parameter.name);
    digest.add(parameter.kind);
    digest.add(parameter.effect);
    digest.add(parameter.parameter);
    digest.add(parameter.companions.size());
    for (const FreeParameter::Companion& companion : parameter.companions) {
        digest.add(companion.parameter);
        digest.add(companion.factor);
    }
    digest.add(parameter.everywhere);
    digest.add(parameter.scope);
    digest.add(parameter.place);
    digest.add(parameter.layers);
    digest.add(parameter.knots);
    digest.add(parameter.knot);
    digest.add(parameter.nodes);
    // A slope by differences takes its step from these, and stays within them.
    for (const double number : {parameter.prior, parameter.standard_deviation, parameter.low, parameter.high}) {
        digest.add(number);
    }
}

}  // namespace

UseOfKeptResults::UseOfKeptResults(KeptResults& results) { in_use = &results; }

UseOfKeptResults::~UseOfKeptResults() { in_use = nullptr; }

KeptResults* kept_results() { return in_use; }

void add(Digest& digest, const Problem& problem) {
    digest.add(problem.name);
    add(digest, problem.mesh);
    digest.add(problem.materials.size());
    for (const physics::Material& material : problem.materials) {
        digest.add(material.density);
        add(digest, material.heat_capacity);
        for (const physics::Curve& conductivity : material.conductivity) {
            add(digest, conductivity);
        }
    }
    digest.add(problem.link_laws.size());
    for (const physics::Curve& law : problem.link_laws) {
        add(digest, law);
    }
    digest.add(problem.effects.size());
    for (const physics::ActiveEffect& active : problem.effects) {
        add(digest, active);
    }
    add(digest, problem.input_signals);
    digest.add(problem.input_numbers);
    if (problem.input_model) {
        problem.input_model->add_to(digest);
    }
    digest.add(problem.initial);
    add(digest, problem.settings);
    digest.add(problem.channels.size());
    for (const Channel& channel : problem.channels) {
        digest.add(channel.name);
        add(digest, channel.where);
        digest.add(channel.quantity);
        if (channel.point) {
            add(digest, *channel.point);
        }
    }
    digest.add(problem.symmetry);
}

Digest::Value key_of(const Problem& problem, const PredictionRequest& request) {
    Digest digest;
    digest.add("prediction");
    add(digest, problem);
    digest.add(request.times);
    digest.add(request.parameters.size());
    for (const FreeParameter& parameter : request.parameters) {
        add(digest, parameter);
    }
    digest.add(request.values);
    digest.add(request.step_ends);
    digest.add(request.tolerance);
    return digest.value();
}

std::vector<double> numbers_of(const Prediction& prediction, const PredictionRequest& request) {
    std::vector<double> numbers{static_cast<double>(prediction.step_ends.size()),
                                static_cast<double>(prediction.non_smooth_parameters.size())};
    for (const std::vector<double>* values : {&prediction.step_ends, &prediction.value, &prediction.slope}) {
        numbers.insert(numbers.end(), values->begin(), values->end());
    }
    for (const std::string& name : prediction.non_smooth_parameters) {
        const auto found = std::ranges::find(request.parameters, name, &FreeParameter::name);
        numbers.push_back(static_cast<double>(found - request.parameters.begin()));
    }
    return numbers;
}

std::optional<Prediction> prediction_of(std::span<const double> numbers, const Problem& problem,
                                        const PredictionRequest& request) {
    Prediction prediction;
    prediction.n_times = request.times.size();
    prediction.n_channels = problem.channels.size();
    const std::size_t values = prediction.n_times * prediction.n_channels;
    const std::size_t slopes = request.parameters.size() * values;
    const auto most = static_cast<double>(numbers.size());
    if (numbers.size() < 2 || !(numbers[0] >= 0.0 && numbers[0] <= most) ||
        !(numbers[1] >= 0.0 && numbers[1] <= most)) {
        return std::nullopt;
    }
    const auto steps = static_cast<std::size_t>(numbers[0]);
    const auto kinks = static_cast<std::size_t>(numbers[1]);
    if (numbers.size() != 2 + steps + values + slopes + kinks) {
        return std::nullopt;
    }
    std::size_t at = 2;
    const auto take = [&](std::vector<double>& into, std::size_t n) {
        into.assign(numbers.begin() + static_cast<std::ptrdiff_t>(at),
                    numbers.begin() + static_cast<std::ptrdiff_t>(at + n));
        at += n;
    };
    take(prediction.step_ends, steps);
    take(prediction.value, values);
    take(prediction.slope, slopes);
    for (std::size_t k = 0; k < kinks; ++k) {
        const double parameter = numbers[at + k];
        if (!(parameter >= 0.0 && parameter < static_cast<double>(request.parameters.size()))) {
            return std::nullopt;
        }
        prediction.non_smooth_parameters.push_back(request.parameters[static_cast<std::size_t>(parameter)].name);
    }
    return prediction;
}

}  // namespace tiretherm::solver
