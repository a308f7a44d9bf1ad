// SPDX-License-Identifier: BSD-3-Clause
// Copies each row once, while it is there; arrays look at these copies.

#include "python/extension/recorded_run.hpp"

#include <algorithm>
#include <memory>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "mesh/place.hpp"
#include "post/fields/whole_drawing.hpp"
#include "python/extension/values.hpp"

namespace tiretherm::python {

namespace py = pybind11;

namespace {

void append(std::vector<double>& to, std::span<const double> values, double factor = 1.0) {
    for (const double value : values) {
        to.push_back(factor * value);
    }
}

py::ssize_t signed_size(std::size_t n) { return static_cast<py::ssize_t>(n); }

/// A copy of points. @returns [n, 3] m
py::array_t<double> coordinates(const std::vector<mesh::Point>& points) {
    py::array_t<double> array({signed_size(points.size()), py::ssize_t{3}});
    auto at = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            at(signed_size(i), signed_size(axis)) = points[i][axis];
        }
    }
    return array;
}

template <typename Number>
py::array_t<Number> copied(const std::vector<Number>& values) {
    return py::array_t<Number>(signed_size(values.size()), values.data());
}

}  // namespace

RecordedRun::RecordedRun(const input::RunOfCase& run, const std::vector<OwnSensor>& sensors)
    : rows_(run),
      settings_(run.problem.settings),
      symmetry_(run.problem.symmetry),
      mesh_(run.problem.mesh),
      sensors_(&sensors) {
    for (const OwnSensor& sensor : sensors) {
        rows_.channels.push_back({.name = sensor.name, .unit = "", .shown = "", .meaning = "computed in Python"});
    }
    for (const physics::ActiveEffect& active : run.problem.effects) {
        effects_.emplace_back(active.title());
    }
}

void RecordedRun::take(const solver::Snapshot& row) {
    rows_.take(row);
    if (!sensors_->empty()) {
        const py::gil_scoped_acquire gil;
        const py::array_t<double> temperature(signed_size(row.temperature.size()), row.temperature.data());
        for (const OwnSensor& sensor : *sensors_) {
            rows_.values.push_back(sensor.read(row.time, temperature).cast<double>());
        }
    }
    append(watts_, row.watts, symmetry_);
    append(joules_, row.joules, symmetry_);
    stored_.push_back(symmetry_ * row.stored);
    if (row.field) {
        field_time_.push_back(row.time);
        append(fields_, row.temperature);
    }
}

double RecordedRun::progress(double time) const {
    const double whole = settings_.end - settings_.start;
    return whole > 0.0 ? std::clamp((time - settings_.start) / whole, 0.0, 1.0) : 1.0;
}

py::dict RecordedRun::mesh() const {
    py::dict mesh;
    const post::WholeDrawing drawing = post::whole_drawing(mesh_);
    mesh["kind"] = mesh_.kind;
    mesh["cells"] = mesh_.n_cells;
    mesh["centre"] = coordinates(mesh_.centre);
    mesh["volume"] = copied(mesh_.volume);
    mesh["layer"] = copied(mesh_.layer);
    mesh["layers"] = mesh_.layers;
    mesh["zone"] = copied(mesh_.zone);
    mesh["zones"] = mesh_.zones;
    mesh["points"] = coordinates(drawing.points);
    mesh["corners"] = copied(drawing.corners);
    mesh["corners_per_cell"] = mesh::corners_per_cell(drawing.shape);
    mesh["drawn_cell"] = copied(drawing.cell);
    return mesh;
}

py::dict RecordedRun::extreme(const solver::MarchReport::Extreme& extreme) const {
    py::dict dict;
    dict["temperature"] = extreme.temperature;
    dict["time"] = extreme.time;
    dict["node"] = extreme.node;
    dict["place"] = extreme.node >= 0 ? mesh::describe_place(mesh_, extreme.node) : std::string();
    return dict;
}

void RecordedRun::define(py::module_& module) {
    using Self = const std::shared_ptr<RecordedRun>&;
    const auto table = [](std::vector<double> RecordedRun::*values, auto columns) {
        return [values, columns](Self self) {
            return view(self.get()->*values, {signed_size(self->rows()), signed_size((self.get()->*columns).size())},
                        py::cast(self));
        };
    };
    py::class_<RecordedRun, std::shared_ptr<RecordedRun>> run(module, "RecordedRun");
    run.def_property_readonly("name", [](Self self) { return self->rows_.name; });
    run.def_property_readonly("corner", [](Self self) { return self->rows_.corner; });
    run.def_property_readonly("channels", [](Self self) {
        py::list list;
        for (const calls::RecordedRows::Channel& channel : self->rows_.channels) {
            list.append(py::make_tuple(channel.name, channel.unit, channel.shown, channel.meaning));
        }
        return list;
    });
    run.def_property_readonly("effects", [](Self self) { return self->effects_; });
    run.def_property_readonly(
        "time", [](Self self) { return view(self->rows_.time, {signed_size(self->rows())}, py::cast(self)); });
    run.def_property_readonly("values", [](Self self) {
        return view(self->rows_.values, {signed_size(self->rows()), signed_size(self->rows_.channels.size())},
                    py::cast(self));
    });
    run.def_property_readonly("watts", table(&RecordedRun::watts_, &RecordedRun::effects_));
    run.def_property_readonly("joules", table(&RecordedRun::joules_, &RecordedRun::effects_));
    run.def_property_readonly(
        "stored", [](Self self) { return view(self->stored_, {signed_size(self->rows())}, py::cast(self)); });
    run.def_property_readonly("field_time", [](Self self) {
        return view(self->field_time_, {signed_size(self->field_time_.size())}, py::cast(self));
    });
    run.def_property_readonly("fields", [](Self self) {
        return view(self->fields_, {signed_size(self->field_time_.size()), py::ssize_t{self->mesh_.n_nodes}},
                    py::cast(self));
    });
    run.def_property_readonly("mesh", [](Self self) { return self->mesh(); });
    run.def_property_readonly("hottest", [](Self self) { return self->extreme(self->report_.hottest); });
    run.def_property_readonly("coldest", [](Self self) { return self->extreme(self->report_.coldest); });
    run.def_property_readonly("energy_closure", [](Self self) { return self->report_.energy_closure; });
    run.def_property_readonly("steps", [](Self self) { return self->report_.steps; });
    run.def_property_readonly("message", [](Self self) { return self->report_.status.message; });
    run.def_property_readonly("is_stopped",
                              [](Self self) { return self->report_.status.outcome == solver::Outcome::stopped; });
}

}  // namespace tiretherm::python
