// SPDX-License-Identifier: BSD-3-Clause
// The assembler takes the files of post/page/assets into the program; the build says where they are.
#include "post/page/assets.hpp"

#define TIRETHERM_ASSET(name, files)                                          \
    asm(".section .rodata\n"                                                  \
        ".global tiretherm_asset_" #name                                      \
        "\n"                                                                  \
        "tiretherm_asset_" #name ":\n" files ".global tiretherm_asset_" #name \
        "_end\n"                                                              \
        "tiretherm_asset_" #name                                              \
        "_end:\n"                                                             \
        ".byte 0\n"                                                           \
        ".previous\n");                                                       \
    extern "C" const char tiretherm_asset_##name[];                           \
    extern "C" const char tiretherm_asset_##name##_end[]

#define TIRETHERM_FILE(file) ".incbin \"" TIRETHERM_ASSETS "/" file "\"\n"

TIRETHERM_ASSET(style, TIRETHERM_FILE("report.css"));
TIRETHERM_ASSET(live, TIRETHERM_FILE("live.html"));
TIRETHERM_ASSET(live_script, TIRETHERM_FILE("parts.js") TIRETHERM_FILE("live.js"));
TIRETHERM_ASSET(script, TIRETHERM_FILE("parts.js") TIRETHERM_FILE("maps_and_bars.js") TIRETHERM_FILE("fields.js")
                            TIRETHERM_FILE("images.js") TIRETHERM_FILE("report.js"));
TIRETHERM_ASSET(export_script, TIRETHERM_FILE("export.js"));
TIRETHERM_ASSET(charting_library, TIRETHERM_FILE("echarts.min.js"));

namespace tiretherm::post::assets {

std::string_view style() { return {tiretherm_asset_style, tiretherm_asset_style_end}; }
std::string_view live() { return {tiretherm_asset_live, tiretherm_asset_live_end}; }
std::string_view live_script() { return {tiretherm_asset_live_script, tiretherm_asset_live_script_end}; }
std::string_view script() { return {tiretherm_asset_script, tiretherm_asset_script_end}; }
std::string_view export_script() { return {tiretherm_asset_export_script, tiretherm_asset_export_script_end}; }
std::string_view charting_library() { return {tiretherm_asset_charting_library, tiretherm_asset_charting_library_end}; }

}  // namespace tiretherm::post::assets
