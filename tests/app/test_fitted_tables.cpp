// SPDX-License-Identifier: BSD-3-Clause
// parameters.csv and laws.csv of `tiretherm identify`, read back: what the fit found, with its intervals and bands.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string laser = TIRETHERM_SOURCE_DIR "/cases/laser/";

void replace_once(std::string& text, const std::string& from, const std::string& to) {
    ASSERT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
}

/// The laser's fit on a coarse grid and with the run at 3 W alone: K1(T), K2(T) and the bench.
std::string coarse_fit() {
    std::string text = post::read_text(laser + "identify.toml");
    for (const auto& [from, to] : {std::pair("cells = 20, ratio = 0.5", "cells = 6, ratio = 0.5"),
                                   std::pair("cells = 20, ratio = 4", "cells = 6, ratio = 4"),
                                   std::pair("cells = 18", "cells = 6"), std::pair("cells = 24", "cells = 12")}) {
        replace_once(text, from, to);
    }
    return text.substr(0, text.find("[[run]]")) + "[[run]]\nfile = \"" + laser + "identify_three_watts.csv\"\n";
}

/// Cells of a table, its heads first.
std::vector<std::vector<std::string>> cells_of(const std::filesystem::path& file) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(post::read_text(file));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        rows.emplace_back();
        bool is_open = false;  // a comma in quotes ends no cell
        for (std::string cell; std::getline(cells, cell, ',');) {
            const bool has_quote = std::ranges::count(cell, '"') == 1;
            std::erase(cell, '"');
            if (is_open) {
                rows.back().back() += "," + cell;
            } else {
                rows.back().push_back(cell);
            }
            is_open = is_open != has_quote;
        }
    }
    return rows;
}

/// A column of a table between its rows. @param at in the unit of the first column
double between(const std::vector<std::vector<std::string>>& rows, const std::string& column, double at) {
    const auto head = std::ranges::find(rows.front(), column);
    EXPECT_NE(head, rows.front().end()) << column;
    const auto c = static_cast<std::size_t>(head - rows.front().begin());
    for (std::size_t r = 2; head != rows.front().end() && r < rows.size(); ++r) {
        const double low = std::stod(rows[r - 1][0]);
        const double high = std::stod(rows[r][0]);
        if (low <= at && at <= high) {
            const double share = (at - low) / (high - low);
            return (1.0 - share) * std::stod(rows[r - 1][c]) + share * std::stod(rows[r][c]);
        }
    }
    return std::nan("");
}

}  // namespace

// A law through its values at 40, 90 and 140 degC has at 40 and 90 degC the fitted parameter and its interval: 1.96 standard
// deviations to either side. Rows are 1.5 K apart, between which a parabola of 4e-5 W/mK3 leaves a straight line by 1e-5.
TEST(FittedTables, LawsAndParametersAreReadBackAsTheyWereFitted) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "laser.toml", coarse_fit());
    const Call fit = call("identify laser.toml --out out --json", scratch.path());
    ASSERT_EQ(fit.exit_code, 0) << fit.err << fit.out;
    const Json json = Json::parse(fit.out);

    const auto parameters = cells_of(scratch / "out/parameters.csv");
    ASSERT_EQ(parameters.size(), 1 + json["parameters"].size());
    EXPECT_EQ((std::vector<std::string>(parameters[0].begin(), parameters[0].begin() + 7)),
              (std::vector<std::string>{"parameter", "unit", "fitted", "standard_deviation", "low", "high", "case"}));
    const auto laws = cells_of(scratch / "out/laws.csv");
    ASSERT_EQ(laws.size(), 62u);
    ASSERT_EQ(laws[0].size(), 9u);  // temperature, and four of K1 and of K2
    EXPECT_EQ(laws[0][0], "temperature [degC]");
    int compared = 0;
    for (std::size_t j = 0; j < json["parameters"].size(); ++j) {
        const Json& one = json["parameters"][j];
        const std::vector<std::string>& row = parameters[j + 1];
        ASSERT_GT(row.size(), 10 + j);
        EXPECT_EQ(row[0], one["name"]);
        const double value = one["value"];
        const double deviation = one["standard_deviation"];
        EXPECT_NEAR(std::stod(row[2]), value, 1e-6 * std::abs(value));
        EXPECT_NEAR(std::stod(row[3]), deviation, 1e-6 * deviation);
        EXPECT_NEAR(std::stod(row[10 + j]), 1.0, 1e-6) << "correlation with itself";
        const std::string name = one["name"];
        const std::string law = name.substr(0, 2) + " conductivity";
        if (name.find(".conductivity at ") == std::string::npos || name.ends_with("140 degC")) {
            continue;
        }
        EXPECT_EQ(row[1], "W/(m K)");
        const double at = name.ends_with("40 degC") ? 40.0 : 90.0;
        EXPECT_NEAR(between(laws, law + " [W/(m K)]", at), value, 1e-4) << name;
        const double band = between(laws, law + " high [W/(m K)]", at) - between(laws, law + " low [W/(m K)]", at);
        EXPECT_NEAR(band, 2.0 * 1.959964 * deviation, 0.02 * band) << name;
        ++compared;
    }
    EXPECT_EQ(compared, 4);
    EXPECT_NEAR(between(laws, "K1 conductivity case [W/(m K)]", 90.0), 0.95, 1e-4);
}

// Nothing of the bench's fit is a law of a material: there is no table of laws.
TEST(FittedTables, WithoutAFittedLawThereIsNoTableOfLaws) {
    const sample::Scratch scratch;
    const Call fit =
        call("identify " TIRETHERM_SOURCE_DIR "/cases/practice/two_node_bench.toml --out out", scratch.path());
    ASSERT_EQ(fit.exit_code, 0) << fit.err;
    EXPECT_TRUE(std::filesystem::exists(scratch / "out/parameters.csv"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "out/laws.csv"));
}

}  // namespace tiretherm::app_test
