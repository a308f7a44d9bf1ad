// SPDX-License-Identifier: BSD-3-Clause
// Writes the log of the made-up car: make_car_logs CASES, where CASES is the folder cases/; prints what is in its tires at
// the end.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "car/car_layouts_truth.hpp"

int main(int count, char** arguments) {
    using namespace hidden_effects;
    const std::filesystem::path cases = count > 1 ? arguments[1] : "cases";
    std::ofstream(cases / "car" / "session.csv") << shipped_car_log();
    std::ofstream(cases / "car" / "wheels.csv") << shipped_wheel_log();
    std::filesystem::create_directories(cases / "car" / "loggers");
    for (const LoggerFile& file : shipped_logger_files()) {
        std::ofstream(cases / "car" / "loggers" / file.name, std::ios::binary) << file.content;
    }
    const Session session = drive_session(made_up_circuit(), Car{}, 8, 0.1);
    for (std::size_t w = 0; w < n_wheels; ++w) {
        std::printf("%s bulk %.2f degC\n", wheel_names[w], session.wheels[w].bulk.back() - 273.15);
    }
}
