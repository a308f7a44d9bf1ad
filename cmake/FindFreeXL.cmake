# SPDX-License-Identifier: BSD-3-Clause
# Finds FreeXL, which reads .xls workbooks and which Debian packages without CMake files: target FreeXL::FreeXL.
find_path(FREEXL_INCLUDE_DIR freexl.h)
find_library(FREEXL_LIBRARY freexl)
mark_as_advanced(FREEXL_INCLUDE_DIR FREEXL_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FreeXL REQUIRED_VARS FREEXL_LIBRARY FREEXL_INCLUDE_DIR)

if(FreeXL_FOUND AND NOT TARGET FreeXL::FreeXL)
    add_library(FreeXL::FreeXL UNKNOWN IMPORTED)
    set_target_properties(FreeXL::FreeXL PROPERTIES
        IMPORTED_LOCATION "${FREEXL_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${FREEXL_INCLUDE_DIR}")
endif()
