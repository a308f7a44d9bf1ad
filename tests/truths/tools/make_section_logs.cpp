// SPDX-License-Identifier: BSD-3-Clause
// Writes the made-up runs of the benches of a section and of layers: make_section_logs CASES, where CASES is the folder cases/.
#include "section/section_logs_truth.hpp"

int main(int count, char** arguments) {
    const std::filesystem::path cases = count > 1 ? arguments[1] : "cases";
    for (const hidden_effects::ShippedLog& log : hidden_effects::section_logs()) {
        hidden_effects::write(cases / log.file, log.columns);
    }
    for (const hidden_effects::ShippedLog& log : hidden_effects::layers_logs()) {
        hidden_effects::write(cases / log.file, log.columns);
    }
}
