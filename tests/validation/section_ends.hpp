// SPDX-License-Identifier: BSD-3-Clause
// Final bulk and inner liner temperatures of the section cases that support/section_thesis.hpp does not cover, as recorded
// from the program: no proof of them, but a change must be meant.
#pragma once

#include <array>
#include <string_view>

namespace tiretherm::validation {

/// Where the bulk and the inner liner of a case on the section end.
struct SectionEnd {
    std::string_view name;
    double final_bulk;   ///< degC
    double final_liner;  ///< degC
};

inline constexpr std::array section_ends{
    SectionEnd{"drum/205_55_R16_run_flat_section", 72.1, 80.9},
    SectionEnd{"drum/225_50_R17_spec_1_section", 82.3, 84.0},
    SectionEnd{"drum/225_50_R17_spec_2_section", 82.3, 84.0},
    SectionEnd{"drum/235_45_R17_section", 83.5, 84.2},
    SectionEnd{"drum/245_40_R18_section", 83.0, 83.2},
    SectionEnd{"drum/265_65_R16C_section", 72.2, 97.2},
    SectionEnd{"section/4000N_100kmh_all_heat_paths", 48.2, 46.1},
    SectionEnd{"section/4000N_100kmh_resolved_contact", 55.3, 56.2},
    SectionEnd{"section/4000N_100kmh_rotating_disk", 57.5, 55.6},
};

}  // namespace tiretherm::validation
