#include "post/csv_writer.hpp"

#include <iterator>
#include <string>

#include <fmt/format.h>

#include "post/celsius.hpp"

namespace tiretherm::post {

CsvWriter::CsvWriter(const std::filesystem::path& path, const solver::Problem& problem) : file_(path) {
    std::string header = "time [s]";
    for (const solver::Channel& channel : problem.channels) {
        header += fmt::format(",{} [degC]", channel.name);
    }
    file_.append(header + "\n");
}

void CsvWriter::take(const solver::Snapshot& snapshot) {
    std::string row = fmt::format("{:.12g}", snapshot.time);
    for (const double kelvin : snapshot.channels) {
        fmt::format_to(std::back_inserter(row), ",{:.4f}", celsius(kelvin));
    }
    file_.append(row + "\n");
}

}  // namespace tiretherm::post
