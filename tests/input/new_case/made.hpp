// SPDX-License-Identifier: BSD-3-Clause
// New cases as the tests make them, written to a folder of their own and read as a user's.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "input/measurements/experiment.hpp"
#include "input/new_case/new_case.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

/// A new case of a size, or of a log in the folder `written`, as its file case.toml.
inline NewCase make(const Written& written, std::string_view size, const std::string& mesh = "section",
                    const std::string& log = "", std::vector<GivenUnit> units = {}) {
    NewCaseRequest request{
        .size = std::get<TireSize>(read_tire_size(size)), .mesh = mesh, .target = written.folder() / "case.toml"};
    request.units = std::move(units);
    if (!log.empty()) {
        request.log = written.folder() / log;
    }
    return make_new_case(request);
}

/// The errors as the user sees them, without the folder's path.
inline std::string errors_of(const NewCase& made, const Written& written) {
    std::string text;
    for (const InputError& error : made.errors) {
        text += render(error);
    }
    const std::string folder = written.folder().generic_string() + "/";
    for (std::size_t at = 0; (at = text.find(folder, at)) != std::string::npos;) {
        text.erase(at, folder.size());
    }
    return text;
}

inline std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// The column of a heading; fails the test when there is none.
inline LogColumn column_of(const NewCase& made, std::string_view heading) {
    if (made.log) {
        for (const LogColumn& column : made.log->columns) {
            if (column.heading.name == heading) {
                return column;
            }
        }
    }
    ADD_FAILURE() << "no column " << heading;
    return {};
}

}  // namespace tiretherm::input
