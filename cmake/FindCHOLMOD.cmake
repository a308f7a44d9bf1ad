# SPDX-License-Identifier: BSD-3-Clause
# Finds CHOLMOD of SuiteSparse, which Debian packages without CMake files: target SuiteSparse::CHOLMOD (the name that
# SuiteSparse's own package files use from version 7 on), CHOLMOD_VERSION.
find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse)
find_library(CHOLMOD_LIBRARY cholmod)
mark_as_advanced(CHOLMOD_INCLUDE_DIR CHOLMOD_LIBRARY)

# The version numbers moved between these two headers over the years.
foreach(header cholmod_core.h cholmod.h)
    if(CHOLMOD_INCLUDE_DIR AND NOT CHOLMOD_VERSION AND EXISTS ${CHOLMOD_INCLUDE_DIR}/${header})
        set(numbers "")
        foreach(part MAIN SUB SUBSUB)
            file(STRINGS ${CHOLMOD_INCLUDE_DIR}/${header} line REGEX "define CHOLMOD_${part}_VERSION +[0-9]+")
            if(line MATCHES "([0-9]+)$")
                list(APPEND numbers ${CMAKE_MATCH_1})
            endif()
        endforeach()
        list(JOIN numbers "." CHOLMOD_VERSION)
    endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CHOLMOD
    REQUIRED_VARS CHOLMOD_LIBRARY CHOLMOD_INCLUDE_DIR VERSION_VAR CHOLMOD_VERSION)

if(CHOLMOD_FOUND AND NOT TARGET SuiteSparse::CHOLMOD)
    add_library(SuiteSparse::CHOLMOD UNKNOWN IMPORTED)
    set_target_properties(SuiteSparse::CHOLMOD PROPERTIES
        IMPORTED_LOCATION ${CHOLMOD_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${CHOLMOD_INCLUDE_DIR})
endif()
