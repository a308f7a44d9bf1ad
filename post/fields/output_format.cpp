// SPDX-License-Identifier: BSD-3-Clause
// The list of the formats of a run.
#include "post/fields/output_format.hpp"

#include <array>

namespace tiretherm::post {

namespace formats {
#define OUTPUT_FORMAT(id) extern const OutputFormat id;
#include "post/fields/output_formats.list"
#undef OUTPUT_FORMAT
}  // namespace formats

std::span<const OutputFormat* const> output_formats() {
    static constexpr std::array all{
#define OUTPUT_FORMAT(id) &formats::id,
#include "post/fields/output_formats.list"
#undef OUTPUT_FORMAT
    };
    return all;
}

}  // namespace tiretherm::post
