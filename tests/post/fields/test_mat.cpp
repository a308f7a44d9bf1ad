// SPDX-License-Identifier: BSD-3-Clause
// channels.mat is read back as the format says, by a reader that shares nothing with the writer.
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>

#include <gtest/gtest.h>

#include "post/fields/output_format.hpp"
#include "post/report/file.hpp"
#include "post/run/run_files.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

struct Matrix {
    std::int32_t rows = 0;
    std::int32_t columns = 0;
    bool is_text = false;
    std::vector<double> values;  ///< column by column

    [[nodiscard]] std::string row(std::size_t index) const {
        std::string text;
        for (std::size_t column = 0; column < static_cast<std::size_t>(columns); ++column) {
            text += static_cast<char>(values.at(column * static_cast<std::size_t>(rows) + index));
        }
        return text;
    }
};

/// Level 4: type (thousands: byte order, tens: number format, ones: 1 for text), rows, columns, imaginary, name length.
std::map<std::string, Matrix> read_mat(const std::string& bytes) {
    std::map<std::string, Matrix> variables;
    for (std::size_t at = 0; at < bytes.size();) {
        std::int32_t header[5];
        std::memcpy(header, bytes.substr(at, sizeof header).c_str(), sizeof header);
        at += sizeof header;
        if ((header[0] != 0 && header[0] != 1) || header[3] != 0) {
            throw std::runtime_error("no little-endian real doubles");
        }
        const std::string name = bytes.substr(at, static_cast<std::size_t>(header[4]));
        if (name.empty() || name.back() != '\0') {
            throw std::runtime_error("a name without its end");
        }
        at += name.size();
        Matrix matrix{.rows = header[1], .columns = header[2], .is_text = header[0] == 1, .values = {}};
        matrix.values.resize(static_cast<std::size_t>(header[1]) * static_cast<std::size_t>(header[2]));
        const std::string data = bytes.substr(at, matrix.values.size() * sizeof(double));
        if (data.size() != matrix.values.size() * sizeof(double)) {
            throw std::runtime_error("cut off");
        }
        std::memcpy(matrix.values.data(), data.data(), data.size());
        at += data.size();
        variables[name.c_str()] = matrix;
    }
    return variables;
}

TEST(Mat, ChannelsAreVectorsInTheUnitsOfTheCsv) {
    const sample::Scratch scratch;
    solver::Problem problem = sample::problem();
    problem.channels[1].name = "2nd liner";
    const Provenance provenance;
    RunFiles files(scratch.path(), problem, provenance, {"vtk", "mat"});
    files.take(sample::Moment(problem, 0.0, {296.15, 250.0}, true).snapshot);
    files.take(sample::Moment(problem, 30.5, {353.15, 303.123456}, true).snapshot);
    files.finish({});
    EXPECT_EQ(files.written().back(), scratch / "channels.mat");
    const std::map<std::string, Matrix> read = read_mat(read_text(scratch / "channels.mat"));
    ASSERT_EQ(read.size(), 5u);
    EXPECT_EQ(read.at("time").columns, 1);
    EXPECT_EQ(read.at("time").values, (std::vector<double>{0.0, 30.5}));
    EXPECT_DOUBLE_EQ(read.at("spot").values.at(1), 80.0);
    EXPECT_DOUBLE_EQ(read.at("c_2nd_liner").values.at(1), 303.123456 - 273.15);  // every digit, unlike the CSV
    EXPECT_TRUE(read.at("variable").is_text);
    EXPECT_EQ(read.at("variable").row(2), "c_2nd_liner");
    EXPECT_EQ(read.at("unit").row(0), "s   ");
    EXPECT_EQ(read.at("unit").row(2), "degC");
}

TEST(Mat, IsWrittenOnRequestAndNeverLeftFromAnEarlierRun) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    const Provenance provenance;
    replace_file(scratch / "channels.mat", "of an earlier run");
    RunFiles files(scratch.path(), problem, provenance, {"vtk", "report"});
    files.take(sample::Moment(problem, 0.0, {296.15, 250.0}, true).snapshot);
    files.finish({});
    EXPECT_EQ(files.written().size(), 2u);
    EXPECT_FALSE(std::filesystem::exists(scratch / "channels.mat"));
}

}  // namespace
}  // namespace tiretherm::post
