# Headers that most sources of a target include, parsed once for each target: of the program's build they were four fifths
# of the time. Only what others wrote stands here, so that a change of our own headers compiles what includes them and no
# more; and only what most sources need, since every source loads all of it.
set(TIRETHERM_PRECOMPILED
    <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <span> <stdexcept>
    <string> <string_view> <utility> <vector> <fmt/format.h>)

# tiretherm_precompile(TARGET [more headers])
function(tiretherm_precompile target)
    target_precompile_headers(${target} PRIVATE ${TIRETHERM_PRECOMPILED} ${ARGN})
endfunction()
