// SPDX-License-Identifier: BSD-3-Clause
// Writes one CSV row for each snapshot and registers the output format "csv".

#include "post/fields/csv_writer.hpp"

#include <iterator>
#include <string>

#include <fmt/format.h>

namespace tiretherm::post {

CsvWriter::CsvWriter(const std::filesystem::path& path, const solver::Problem& problem) : path_(path), file_(path) {
    std::string header = "time [s]";
    for (const solver::Channel& channel : problem.channels) {
        header += fmt::format(",{} [{}]", channel.name, solver::shown_unit(channel.quantity).name);
        units_.push_back(solver::shown_unit(channel.quantity));
    }
    file_.append(header + "\n");
}

void CsvWriter::take(const solver::Snapshot& snapshot) {
    std::string row = fmt::format("{:.12g}", snapshot.time);
    for (std::size_t c = 0; c < units_.size(); ++c) {
        fmt::format_to(std::back_inserter(row), ",{:.4f}", units_[c].value(snapshot.channels[c]));
    }
    file_.append(row + "\n");
}

namespace formats {

extern const OutputFormat csv;
const OutputFormat csv{
    .name = "csv",
    .use = OutputFormat::Use::always,
    .help = "channels.csv: the channels, a row for each output time",
    .open = [](const RunTarget& target) -> std::unique_ptr<RunOutput> {
        return std::make_unique<CsvWriter>(target.directory / "channels.csv", target.problem);
    },
    .names_in = [](const std::filesystem::path&) -> std::vector<std::string> { return {"channels.csv"}; }};

}  // namespace formats

}  // namespace tiretherm::post
