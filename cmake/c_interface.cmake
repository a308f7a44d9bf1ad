# SPDX-License-Identifier: BSD-3-Clause
# The C interface: tiretherm_session is the solver in real time, tiretherm_cases makes whole calls. With -DBUILD_SHARED_LIBS=ON they are
# shared libraries, which export the functions of their headers alone, each with the version of the library. Before version 1 what they
# export may change with each minor version, and with it the name that the loader looks for.
set(interface_series ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(interface_exports ${PROJECT_BINARY_DIR}/generated/c_interface.map)
file(CONFIGURE OUTPUT ${interface_exports} CONTENT "TIRETHERM_@interface_series@ { global: tiretherm_*; local: *; };\n" @ONLY)

# tiretherm_c_library(TARGET KIND [sources])   KIND: STATIC, SHARED, or empty as BUILD_SHARED_LIBS says
function(tiretherm_c_library target kind)
    add_library(${target} ${kind} ${ARGN})
    set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET default INSTALL_RPATH $ORIGIN:$ORIGIN/tiretherm)
    target_compile_features(${target} PRIVATE cxx_std_20)
    target_compile_definitions(${target} PRIVATE TIRETHERM_VERSION="${PROJECT_VERSION}")
    target_include_directories(${target} INTERFACE
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/interface> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "SHARED_LIBRARY")
        set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${interface_series}
            LINK_DEPENDS ${interface_exports})
        target_link_options(${target} PRIVATE -Wl,--version-script=${interface_exports} -Wl,--exclude-libs,ALL -Wl,-z,defs)
    endif()
endfunction()

# tiretherm_c_libraries(SUFFIX KIND)   both of them
function(tiretherm_c_libraries suffix kind)
    set(folder ${PROJECT_SOURCE_DIR}/interface)
    tiretherm_c_library(tiretherm_session${suffix} "${kind}" ${folder}/session.cpp)
    target_link_libraries(tiretherm_session${suffix} PRIVATE tiretherm_input)
    tiretherm_c_library(tiretherm_cases${suffix} "${kind}" ${folder}/cases.cpp ${folder}/answer.cpp)
    target_link_libraries(tiretherm_cases${suffix} PUBLIC tiretherm_session${suffix} PRIVATE tiretherm_calls)
endfunction()
tiretherm_c_libraries("" "")
foreach(library session cases)
    add_library(tiretherm::${library} ALIAS tiretherm_${library})
    set_target_properties(tiretherm_${library} PROPERTIES EXPORT_NAME ${library})
endforeach()
