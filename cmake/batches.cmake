# SPDX-License-Identifier: BSD-3-Clause
# tiretherm_batches(SIZE TARGET ...)      SIZE sources of a target are compiled together, in the order of their names
# What they share of headers and templates (Eigen, JSON, the command line) is compiled once for all of them: a build takes
# less than half the time. Names at file scope then meet: where two of them clash, the one that says less gets the better
# name. A local name may be that of another file's constant, so that -Wshadow compares local names alone, which only g++ can;
# and g++ takes a batch for a header, in which a type without linkage would be a fault.
function(tiretherm_batches size)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${size})
    foreach(target IN LISTS ARGN)
        target_compile_options(${target} PRIVATE -Wno-shadow
            "$<$<CXX_COMPILER_ID:GNU>:-Wshadow=local;-Wno-subobject-linkage>")
    endforeach()
endfunction()
