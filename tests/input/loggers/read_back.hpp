// SPDX-License-Identifier: BSD-3-Clause
// Reads columns of a written file, as a measured run does.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "input/tables/data_file.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

/// A file of a logger that has been opened, and all that is wrong with it.
class ReadBack {
public:
    ReadBack(const std::string& name, std::string_view content)
        : file_(DataFile::open(written_.add(name, content), {}, errors_)) {}

    [[nodiscard]] bool is_open() const { return file_.has_value(); }
    DataFile& file() { return *file_; }
    InputErrors& errors() { return errors_; }
    [[nodiscard]] std::string messages() const {
        std::string text;
        for (const InputError& error : errors_.in_order()) {
            text += error.what + " | " + error.remedy + "\n";
        }
        return text;
    }
    /// The values of a column in a unit; empty after an error, which is a failure of the test.
    std::vector<double> column(std::string_view name, std::string_view unit, Purpose purpose = Purpose::measured) {
        const int index = file_ ? file_->find(name) : -1;
        if (index < 0) {
            ADD_FAILURE() << "no column " << name << "\n" << messages();
            return {};
        }
        auto read = file_->read(
            {{.column = index, .name = std::string(name), .spec = {.unit = unit}, .purpose = purpose}}, errors_);
        if (read.empty()) {
            ADD_FAILURE() << name << "\n" << messages();
            return {};
        }
        return read.front();
    }

private:
    Written written_;
    InputErrors errors_;
    std::optional<DataFile> file_;
};

}  // namespace tiretherm::input
