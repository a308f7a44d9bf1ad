// SPDX-License-Identifier: BSD-3-Clause
// Files that pages hold a copy of, as they are in post/page/assets.
#pragma once

#include <string_view>

namespace tiretherm::post::assets {

[[nodiscard]] std::string_view style();
/// The page of a live session, with marks where the style, ECharts and its script go.
[[nodiscard]] std::string_view live();
/// parts.js and live.js.
[[nodiscard]] std::string_view live_script();
/// parts.js, maps_and_bars.js and report.js, one after the other.
[[nodiscard]] std::string_view script();
/// Of a copy of a page from which pictures are made.
[[nodiscard]] std::string_view export_script();
/// Apache ECharts; post/page/assets/README.md says how it is made.
[[nodiscard]] std::string_view charting_library();

}  // namespace tiretherm::post::assets
