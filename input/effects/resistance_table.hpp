#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/text/mistake.hpp"
#include "physics/tire_laws/measured_loss.hpp"

namespace tiretherm::input {

/// A drum's table as it was read.
struct ResistanceFile {
    physics::ResistanceTable table;
    std::vector<std::string> names;  ///< [axes]
};

/// @param mentioned where the case names the file  @returns nothing after a mistake
[[nodiscard]] std::optional<ResistanceFile> read_resistance_table(const std::filesystem::path& path,
                                                                  const Place& mentioned, Mistakes& mistakes);

}  // namespace tiretherm::input
