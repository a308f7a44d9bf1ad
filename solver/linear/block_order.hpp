// SPDX-License-Identifier: BSD-3-Clause
// An order of the nodes of a mesh in which blocks of them do not touch each other, so that a triangular factor is swept through by
// several threads.
#pragma once

#include <vector>

#include "solver/linear/matrix.hpp"

namespace tiretherm::solver {

/// Nodes in blocks, and blocks in phases: no node of a block touches one of another block of its phase. First the blocks, then what
/// lies between two of them, then what lies between these. It is found from the pattern alone, whatever the number of threads;
/// a small pattern is one block in its own order.
struct BlockOrder {
    std::vector<int> node;   ///< [n] in this order
    std::vector<int> block;  ///< [n_blocks + 1] first place of each block
    std::vector<int> phase;  ///< [n_phases + 1] first block of each phase
};

[[nodiscard]] BlockOrder block_order_of(const Pattern& pattern);

/// The place of each node in the order. @returns [n]
[[nodiscard]] std::vector<int> places_in(const BlockOrder& order);

}  // namespace tiretherm::solver
