// SPDX-License-Identifier: BSD-3-Clause
// Calls the built program as a user does and keeps its output, its messages and its exit status.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include <fmt/format.h>

#include "post/report/file.hpp"
#include "tests/post/scratch.hpp"

/// The real program, called as a user calls it.
namespace tiretherm::app_test {

/// What a call left behind.
struct Call {
    int exit_code = -1;
    std::string out;
    std::string err;
};

/// Runs `tiretherm ARGUMENTS`, given as to a shell, in a directory.
inline Call call(const std::string& arguments, const std::filesystem::path& directory = ".") {
    const sample::Scratch scratch;
    const std::string line =
        fmt::format("cd '{}' && '{}' {} >'{}' 2>'{}' </dev/null", directory.string(), TIRETHERM_PROGRAM, arguments,
                    (scratch / "out").string(), (scratch / "err").string());
    const int status = std::system(line.c_str());
    return {.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
            .out = post::read_text(scratch / "out"),
            .err = post::read_text(scratch / "err")};
}

inline const std::string cases = TIRETHERM_SOURCE_DIR "/cases/";
inline const std::string two_node = cases + "two_node/4000N_100kmh.toml";

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A strip that nothing holds back: 1e12 W/m3 heat it in one step of 50 s far beyond the 1520 degC at which its conductivity
/// falls below zero.
inline const std::string exploding = R"(
title = "A strip that burns"
[mesh]
kind = "layers"
area = "1 m2"
[[mesh.layer]]
name = "tread"
thickness = "10 mm"
cells = 10
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = { at = "20 degC", value = "0.3 W/mK", slope = "-0.0002 W/mK/K" }
[effects.uniform_source]
power_density = "1e12 W/m3"
[effects.radiation]
patches = ["outside"]
[drive]
air_temperature = "23 degC"
[initial]
temperature = "23 degC"
[time]
end = "100 s"
step = "50 s"
[[sensor]]
name = "inside"
kind = "layer"
layer = "tread"
)";

/// The two-node tire at so small a step that the run takes minutes.
inline const std::string slow = "include = [\"" + two_node + R"("]
[time]
end = "1e6 s"
step = "0.01 s"
output = "1 s"
)";

}  // namespace tiretherm::app_test
