// SPDX-License-Identifier: BSD-3-Clause
// A sound workbook with one worksheet's XML replaced: bytes that a ZIP archive's checksum would keep from the reader.
#pragma once

#include <filesystem>
#include <string_view>

namespace tiretherm::fuzz {

/// The shipped workbook with these bytes as its fourth worksheet. @errors BrokenPromise
[[nodiscard]] std::filesystem::path workbook_with_sheet(std::string_view bytes);

}  // namespace tiretherm::fuzz
