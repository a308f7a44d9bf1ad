# SPDX-License-Identifier: BSD-3-Clause
# Cases of the library that the program carries along: `tiretherm new` writes its cases from their text, `diagnose` chooses the next
# experiment from the manoeuvres.
set(TIRETHERM_SHIPPED_CASES
    section/common.toml section/4000N_100kmh.toml section/all_heat_paths.toml
    section/literature_conductivities.toml
    layers/common.toml layers/two_conductivities.toml
    two_node/common.toml two_node/4000N_100kmh.toml
    laser/common.toml laser/one_watt.toml
    manoeuvres.toml)

# tiretherm_shipped_cases(SOURCE): writes the source that holds them, anew whenever one of them has changed.
function(tiretherm_shipped_cases source)
    set(CASES "")
    foreach(case IN LISTS TIRETHERM_SHIPPED_CASES)
        set(path ${PROJECT_SOURCE_DIR}/cases/${case})
        file(READ ${path} text)
        string(APPEND CASES "    ShippedCase{\"${case}\", R\"toml(${text})toml\"},\n")
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    endforeach()
    list(LENGTH TIRETHERM_SHIPPED_CASES CASE_COUNT)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/shipped_cases.cpp.in ${source} @ONLY)
endfunction()
