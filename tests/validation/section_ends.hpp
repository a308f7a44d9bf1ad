// SPDX-License-Identifier: BSD-3-Clause
// Final bulk and inner liner temperatures of the section cases, as recorded from the program.
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
    SectionEnd{"flat_trac/load_steps_minutes_section", 70.4, 70.2},
    SectionEnd{"flat_trac/load_steps_seconds_section", 29.2, 28.7},
    SectionEnd{"flat_trac/second_test_section", 91.8, 94.4},
    SectionEnd{"flat_trac/speed_and_load_steps_minutes_section", 88.5, 90.5},
    SectionEnd{"flat_trac/speed_and_load_steps_seconds_section", 33.7, 33.0},
    SectionEnd{"flat_trac/speed_steps_minutes_section", 68.6, 68.5},
    SectionEnd{"flat_trac/speed_steps_seconds_section", 28.9, 28.5},
    SectionEnd{"flat_trac/standard_section", 48.7, 47.4},
    SectionEnd{"flat_trac/ten_cycles_falling_section", 51.8, 51.3},
    SectionEnd{"flat_trac/ten_cycles_rising_section", 70.1, 68.8},
    SectionEnd{"flat_trac/warm_up_then_lateral_section", 61.3, 60.6},
    SectionEnd{"handling/panic_stop_section", 65.5, 65.9},
    SectionEnd{"handling/sine_sweep_section", 63.3, 62.7},
    SectionEnd{"handling/steering_pad_section", 64.9, 63.8},
    SectionEnd{"oval_track/laden_140_FR_section", 80.0, 80.8},
    SectionEnd{"oval_track/laden_140_RL_section", 80.5, 81.9},
    SectionEnd{"oval_track/laden_140_RR_section", 83.7, 85.5},
    SectionEnd{"oval_track/laden_80_FR_section", 62.1, 61.1},
    SectionEnd{"oval_track/laden_80_RL_section", 62.8, 62.3},
    SectionEnd{"oval_track/laden_80_RR_section", 65.0, 64.5},
    SectionEnd{"oval_track/unladen_140_FR_section", 76.9, 77.4},
    SectionEnd{"oval_track/unladen_140_RL_section", 63.5, 63.2},
    SectionEnd{"oval_track/unladen_140_RR_section", 65.2, 65.0},
    SectionEnd{"section/4000N_100kmh", 57.9, 57.3},
    SectionEnd{"section/4000N_100kmh_resolved_contact", 55.4, 56.3},
    SectionEnd{"section/7000N_100kmh", 76.6, 77.2},
    SectionEnd{"section/7500N_150kmh", 91.9, 94.6},
};

}  // namespace tiretherm::validation
