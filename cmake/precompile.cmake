# SPDX-License-Identifier: BSD-3-Clause
# Headers that most sources include, parsed once and not by each: without this they are four fifths of the time of a build.
# Only what others wrote stands here, so that a change of our own headers compiles what includes them and no more; and only
# what most sources need, since every source loads all of it.
set(TIRETHERM_PRECOMPILED
    <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <span> <stdexcept>
    <string> <string_view> <utility> <vector> <fmt/format.h>)

# tiretherm_precompile(TARGET [more headers])           TARGET parses them
# tiretherm_precompile(TARGET REUSE_FROM OTHER)         TARGET takes what OTHER has parsed: with the same options only
function(tiretherm_precompile target)
    if("${ARGV1}" STREQUAL REUSE_FROM)
        target_precompile_headers(${target} REUSE_FROM ${ARGV2})
    else()
        target_precompile_headers(${target} PRIVATE ${TIRETHERM_PRECOMPILED} ${ARGN})
    endif()
endfunction()
