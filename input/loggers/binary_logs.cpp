// SPDX-License-Identifier: BSD-3-Clause
// The lists of formats.

#include "input/loggers/binary_logs.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/loggers/heading_names.hpp"
#include "input/loggers/iracing_ibt.hpp"
#include "input/loggers/motec_ld.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array binary_logs{BinaryLog{is_motec_ld, read_motec_ld}, BinaryLog{is_iracing_ibt, read_iracing_ibt}};

/// A file that its maker's program alone reads.
struct UnreadLog {
    std::string_view ending;
    std::string_view mark;  ///< its first bytes, whatever the name; empty: the name tells
    std::string_view what;
    std::string_view remedy;
};
constexpr std::string_view of_aim = "a recording of an AiM logger";
constexpr std::string_view by_aim = "export it as CSV in AiM RaceStudio";
constexpr std::array unread_logs{
    UnreadLog{".xrk", "<hCNF", of_aim, by_aim},
    UnreadLog{".xrz", "", of_aim, by_aim},
    UnreadLog{".drk", "", of_aim, by_aim},
    UnreadLog{".ldx", "", "the beacons and the display of a MoTeC recording, without its channels",
              "name the .ld file beside it"},
    UnreadLog{".mlg", "MLVLG", "a binary log of TunerStudio",
              "export it as .msl or CSV in TunerStudio or MegaLogViewer"},
    UnreadLog{".rcz", "", "a session of RaceChrono", "export it as CSV v3 in RaceChrono"},
    UnreadLog{".vbox", "", "a recording of Racelogic's VBOX", "export it as .vbo or CSV in VBOX Test Suite"},
    UnreadLog{".mf4", "MDF ", "a measurement in ASAM MDF",
              "export it as CSV, with asammdf or the program that recorded it"},
    UnreadLog{".mdf", "", "a measurement in ASAM MDF",
              "export it as CSV, with asammdf or the program that recorded it"},
    UnreadLog{".tdms", "TDSm", "a recording of LabVIEW", "export it as CSV in LabVIEW, DIAdem or a spreadsheet"},
    UnreadLog{".mat", "MATLAB 5.0", "a file of MATLAB", "write it as CSV, with writetable"},
    UnreadLog{".dlf", "", "a recording of ATLAS or Pi Toolbox", "export it as CSV there"}};

}  // namespace

const BinaryLog* find_binary_log(std::string_view first_bytes) {
    const auto found =
        std::ranges::find_if(binary_logs, [&](const BinaryLog& log) { return log.recognises(first_bytes); });
    return found == binary_logs.end() ? nullptr : &*found;
}

LogTable table_of_channels(std::vector<TableColumn> channels, LogDescription description) {
    LogTable table{.description = std::move(description), .units = LogTable::Units::by_name_alone};
    table.columns.push_back({.head = {.heading = {"time", "s"}, .place = {.file = 0}}});
    for (TableColumn& channel : channels) {
        channel.head.place = {.file = 0};
        table.columns.push_back(std::move(channel));
    }
    return table;
}

ErrorText unread_log(const std::filesystem::path& path, std::string_view first_bytes) {
    const std::string ending = in_small_letters(path.extension().string());
    const auto found = std::ranges::find_if(unread_logs, [&](const UnreadLog& log) {
        return log.ending == ending || (!log.mark.empty() && first_bytes.starts_with(log.mark));
    });
    return found == unread_logs.end()
               ? ErrorText{}
               : ErrorText{fmt::format("is {}, which is not read", found->what), std::string(found->remedy)};
}

bool is_ending_of_log(std::string_view ending) {
    constexpr std::array<std::string_view, 11> read{".csv",  ".txt", ".tsv", ".dat", ".log", ".h5",
                                                    ".hdf5", ".ld",  ".vbo", ".msl", ".ibt"};
    return std::ranges::find(read, ending) != read.end() ||
           std::ranges::find(unread_logs, ending, &UnreadLog::ending) != unread_logs.end();
}

}  // namespace tiretherm::input
