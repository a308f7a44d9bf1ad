// SPDX-License-Identifier: BSD-3-Clause
// The state file that shows a series of fields in ParaView.
#pragma once

#include <string>

#include "mesh/mesh.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

/// What the view of a series has to know.
struct FieldView {
    const solver::Problem& problem;
    mesh::CellShape shape;      ///< of the cells that are drawn
    double low = 0.0;           ///< degC, of all times
    double high = 0.0;          ///< degC
    double hottest_time = 0.0;  ///< s
    double end = 0.0;           ///< s, of the last field
};

/// A state file in Python, which ParaView opens by File > Load State. Python, because ParaView's interface for it has stayed
/// the same over its versions and the file takes its folder from its own place; a state in XML names every property of a
/// version and absolute paths.
[[nodiscard]] std::string field_view(const FieldView& view);

}  // namespace tiretherm::post
