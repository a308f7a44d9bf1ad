// SPDX-License-Identifier: BSD-3-Clause
// A zip archive in memory.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tiretherm::post {

/// A file of an archive: its path in it, and what it holds.
using ArchivedFile = std::pair<std::string, std::string>;

/// The bytes of a zip archive, deflated; no file has a date, so that the same files give the same bytes.
/// @errors std::runtime_error when memory runs out
[[nodiscard]] std::string zip(const std::vector<ArchivedFile>& files);

}  // namespace tiretherm::post
