// SPDX-License-Identifier: BSD-3-Clause
// A judgement of a measured number in words.
#include <cmath>

#include <fmt/format.h>

#include "post/validation/validation_report.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose judgement is worded here

namespace {

/// What a number that is too large is, and one that is too small.
std::pair<const char*, const char*> words(const std::string& unit) {
    if (unit == "degC") {
        return {"hot", "cold"};
    }
    if (unit == "s") {
        return {"late", "early"};
    }
    return {"large", "small"};
}

}  // namespace

std::string verdict(const ValidationRow& row, std::size_t model) {
    const Judgement judgement = judge(row, model);
    switch (judgement) {
        case Judgement::none:
            return "";
        case Judgement::no_result:
            return "failed";
        case Judgement::not_decidable: {
            const auto circular = std::ranges::find_if(row.inputs, &InputEffect::inferred_from_it);
            return circular != row.inputs.end() ? fmt::format("not decidable ({} inferred from it)", circular->name)
                                                : fmt::format("not decidable ({})", reach(row, model).widest);
        }
        case Judgement::passes:
        case Judgement::fails:
            break;
    }
    if (row.is_open()) {
        return judgement == Judgement::passes ? "holds" : "does not hold";
    }
    const double off = difference(row, model).value();
    const double score = std::abs(off) / total_uncertainty(row, model);
    if (judgement == Judgement::passes) {
        return off == 0.0 ? "within" : fmt::format("within ({:.1f} u)", score);
    }
    const auto [large, small] = words(row.unit);
    return fmt::format("{:.1f} u too {}", score, off > 0.0 ? large : small);
}

}  // namespace tiretherm::post
