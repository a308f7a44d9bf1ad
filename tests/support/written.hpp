// SPDX-License-Identifier: BSD-3-Clause
// A temporary folder of files that a test writes, and a minimal sound case.
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

#include "input/runs/reader.hpp"

namespace tiretherm::input {

/// A folder of files that a test writes; gone with the test.
class Written {
public:
    Written() {
        static std::atomic<int> count{0};
        folder_ = std::filesystem::temp_directory_path() /
                  ("tiretherm_cases_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
        std::filesystem::create_directories(folder_);
    }
    ~Written() { std::filesystem::remove_all(folder_); }
    Written(const Written&) = delete;
    Written& operator=(const Written&) = delete;

    std::filesystem::path add(const std::string& name, std::string_view text) const {
        std::filesystem::path file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
};

/// A sound slab of one cell under still air; tests add to it.
inline constexpr std::string_view slab = R"(
[mesh]
kind = "block"
x = [{ to = "10 mm", cells = 1 }]
y = [{ to = "10 mm", cells = 1 }]
[[mesh.layer]]
name = "rubber"
thickness = "10 mm"
cells = 2
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.25 W/mK"
[initial]
temperature = "23 degC"
[time]
end = "60 s"
[[sensor]]
name = "top"
kind = "point"
depth = "0 mm"
)";

/// All errors and warnings of a reading, for the message of an assertion.
inline std::string error_report(const Reading& reading) { return render(reading); }

inline std::filesystem::path source_folder() { return TIRETHERM_SOURCE_DIR; }

}  // namespace tiretherm::input
