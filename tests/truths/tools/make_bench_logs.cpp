// SPDX-License-Identifier: BSD-3-Clause
// Writes the made-up runs of the bench of two nodes: make_bench_logs CASES, where CASES is the folder cases/.
#include "two_node/shipped_truth.hpp"

int main(int count, char** arguments) {
    const std::filesystem::path cases = count > 1 ? arguments[1] : "cases";
    for (const hidden_effects::ShippedLog& log : hidden_effects::bench_logs()) {
        hidden_effects::write(cases / log.file, log.columns);
    }
}
