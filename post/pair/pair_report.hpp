// SPDX-License-Identifier: BSD-3-Clause
// Two results on one page: what differs in their inputs, and what follows from it.
#pragma once

#include "post/pair/stored_result.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// Why two results cannot stand beside each other, a sentence without its full stop; empty where they can.
[[nodiscard]] std::string nothing_in_common(const StoredResult& a, const StoredResult& b);

/// Keys of the cases that differ; final value, maximum and mean of each channel; its courses over each other; the hottest
/// places, hot spots and the heat. Differences are B - A. @pre they have something in common
[[nodiscard]] Report pair_report(const StoredResult& a, const StoredResult& b);

}  // namespace tiretherm::post
