// SPDX-License-Identifier: BSD-3-Clause
// Writes sets of dirty data, each with its case and its answer: make_dirty_sets FOLDER FIRST_SEED COUNT
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "dirty/dirty_case_truth.hpp"

int main(int count, char** words) {
    if (count != 4) {
        std::cerr << "usage: make_dirty_sets FOLDER FIRST_SEED COUNT\n";
        return 1;
    }
    try {
        const std::filesystem::path folder = words[1];
        const std::uint64_t first = std::stoull(words[2]);
        const std::uint64_t n = std::stoull(words[3]);
        for (std::uint64_t seed = first; seed < first + n; ++seed) {
            hidden_effects::write_dirty_set(hidden_effects::draw_dirty_set(seed),
                                            folder / ("set" + std::to_string(seed)));
        }
    } catch (const std::exception& failure) {
        std::cerr << "make_dirty_sets: " << failure.what() << '\n';
        return 1;
    }
    return 0;
}
