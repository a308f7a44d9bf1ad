# Headers that most sources include, parsed once for each target: of the program's build they were four fifths of the time.
# Only what others wrote stands here, so that a change of our own headers compiles what includes them and no more.
set(TIRETHERM_PRECOMPILED
    <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <limits> <map> <memory>
    <optional> <set> <span> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>
    <Eigen/Dense> <Eigen/SparseCore> <fmt/format.h> <fmt/ranges.h>)

# tiretherm_precompile(TARGET [more headers])
function(tiretherm_precompile target)
    target_precompile_headers(${target} PRIVATE ${TIRETHERM_PRECOMPILED} ${ARGN})
endfunction()
