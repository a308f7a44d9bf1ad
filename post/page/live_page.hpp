// SPDX-License-Identifier: BSD-3-Clause
// The page that a live session shows in a browser.
#pragma once

#include <string>

namespace tiretherm::post {

/// One HTML file with its style, scripts and charting library; it asks /events of the host that it came from for hello and
/// frames (docs/live.md).
[[nodiscard]] std::string live_page();

}  // namespace tiretherm::post
