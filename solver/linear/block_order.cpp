// SPDX-License-Identifier: BSD-3-Clause
// Cuts the numbering of the nodes into equal pieces; a node far from what it touches, such as a surface numbered behind all cells,
// goes where that is. Of two nodes that touch across a cut the later one is put between the blocks.

#include "solver/linear/block_order.hpp"

#include <algorithm>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

/// Nodes of a block at least, and blocks at most: more would lengthen what lies between them.
constexpr int least_of_block = 8000;
constexpr int most_blocks = 16;
constexpr int n_phases = 3;

/// The piece of the numbering to which each node belongs.
std::vector<int> pieces_of(const Pattern& pattern, int n_pieces) {
    const int reach = pattern.n / (2 * n_pieces);
    std::vector<int> piece(at(pattern.n), -1);
    std::vector<int> near;
    for (int i = 0; i < pattern.n; ++i) {
        const int own = pattern.diagonal[at(i)];
        const bool first = own == pattern.start[at(i)];
        if (first || i - pattern.column[at(own - 1)] < reach) {
            near.push_back(i);
        }
    }
    for (std::size_t k = 0; k < near.size(); ++k) {
        piece[at(near[k])] = static_cast<int>(k * at(n_pieces) / near.size());
    }
    for (int i = 0; i < pattern.n; ++i) {
        if (piece[at(i)] < 0) {
            piece[at(i)] = piece[at(pattern.column[at(pattern.diagonal[at(i)] - 1)])];
        }
    }
    return piece;
}

/// Whether a node touches an earlier one of the same phase in another piece.
bool meets(const Pattern& pattern, int i, const std::vector<int>& piece, const std::vector<int>& phase) {
    const auto begin = pattern.column.begin();
    return std::any_of(begin + pattern.start[at(i)], begin + pattern.diagonal[at(i)],
                       [&](int j) { return phase[at(j)] == phase[at(i)] && piece[at(j)] != piece[at(i)]; });
}

}  // namespace

BlockOrder block_order_of(const Pattern& pattern) {
    const int n_pieces = at(pattern.n) < least_shared ? 1 : std::clamp(pattern.n / least_of_block, 1, most_blocks);
    std::vector<int> piece(at(pattern.n), 0);
    std::vector<int> phase(at(pattern.n), 0);
    if (n_pieces > 1) {
        piece = pieces_of(pattern, n_pieces);
        for (int pass = 0; pass + 1 < n_phases; ++pass) {
            for (int i = 0; i < pattern.n; ++i) {
                phase[at(i)] += phase[at(i)] == pass && meets(pattern, i, piece, phase) ? 1 : 0;
            }
        }
    }
    // Of each phase the pieces, one after the other; what is left for the last phase is one block.
    const auto bin = [&](std::size_t i) { return at(n_pieces * phase[i] + (phase[i] == n_phases - 1 ? 0 : piece[i])); };
    std::vector<int> end(at(n_phases * n_pieces), 0);
    for (std::size_t i = 0; i < piece.size(); ++i) {
        ++end[bin(i)];
    }
    BlockOrder order{.node = std::vector<int>(piece.size()), .block = {0}, .phase = {0}};
    for (int k = 0; k < n_phases * n_pieces; ++k) {
        const int begin = order.block.back();
        if (end[at(k)] > 0) {
            order.block.push_back(begin + end[at(k)]);
        }
        end[at(k)] = begin;  // of what is filled in
        const int blocks = static_cast<int>(order.block.size()) - 1;
        if ((k + 1) % n_pieces == 0 && blocks > order.phase.back()) {
            order.phase.push_back(blocks);
        }
    }
    for (std::size_t i = 0; i < piece.size(); ++i) {
        order.node[at(end[bin(i)]++)] = static_cast<int>(i);
    }
    return order;
}

std::vector<int> places_in(const BlockOrder& order) {
    std::vector<int> place(order.node.size());
    for (std::size_t k = 0; k < place.size(); ++k) {
        place[at(order.node[k])] = static_cast<int>(k);
    }
    return place;
}

}  // namespace tiretherm::solver
