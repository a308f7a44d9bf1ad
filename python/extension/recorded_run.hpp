// SPDX-License-Identifier: BSD-3-Clause
// The rows of a run as Python has them: arrays of time, channels, heat and fields.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "calls/outcome.hpp"

namespace tiretherm::python {

/// A sensor that is written in Python: its value from the time and the temperatures of all nodes, at each row.
struct OwnSensor {
    std::string name;
    pybind11::object read;
};

/// One tire's run. Everything in SI and kelvin, of the whole tire: heat is multiplied by the planes of symmetry.
class RecordedRun {
public:
    RecordedRun(const input::RunOfCase& run, const std::vector<OwnSensor>& sensors);

    void take(const solver::Snapshot& row);
    void end(const calls::SimulatedRun& run) { report_ = run.report; }

    [[nodiscard]] const solver::MarchReport& report() const { return report_; }
    [[nodiscard]] double progress(double time) const;

    /// Adds the class to the module.
    static void define(pybind11::module_& module);

private:
    [[nodiscard]] std::size_t rows() const { return rows_.time.size(); }
    [[nodiscard]] pybind11::dict mesh() const;
    [[nodiscard]] pybind11::dict extreme(const solver::MarchReport::Extreme& extreme) const;

    calls::RecordedRows rows_;
    solver::Settings settings_;
    double symmetry_;
    mesh::Mesh mesh_;
    std::vector<std::string> effects_;
    const std::vector<OwnSensor>* sensors_;  ///< of the call, which has ended where rows are no longer taken
    std::vector<double> watts_;              ///< [rows][effects] W
    std::vector<double> joules_;             ///< [rows][effects] J
    std::vector<double> stored_;             ///< [rows] J
    std::vector<double> field_time_;         ///< [fields] s
    std::vector<double> fields_;             ///< [fields][nodes] K
    solver::MarchReport report_;
};

}  // namespace tiretherm::python
