// SPDX-License-Identifier: BSD-3-Clause
// Foot of a page: which files and which program it was made from, and what to cite.
#pragma once

#include "post/page/html_page.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

/// Files that were read, version and commit of the program, versions of its libraries.
[[nodiscard]] ReportSection origin_section(const PageOrigin& origin);

/// The program, and the sources of the effects that are on, each with the effects that come from it.
[[nodiscard]] ReportSection citations_section(const solver::Problem& problem);

}  // namespace tiretherm::post
