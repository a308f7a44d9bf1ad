// SPDX-License-Identifier: BSD-3-Clause
// Made-up files in which every table stands once. They are read, not run: what is missing in them is no matter.
#pragma once

#include <string_view>
#include <vector>

namespace tiretherm::input {

struct MadeUpFile {
    std::string_view name;
    std::string_view text;
};
[[nodiscard]] const std::vector<MadeUpFile>& files_of_every_kind();

}  // namespace tiretherm::input
