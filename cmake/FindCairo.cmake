# SPDX-License-Identifier: BSD-3-Clause
# Finds Cairo, which draws the pictures and which Debian packages without CMake files: target Cairo::Cairo.
find_path(CAIRO_INCLUDE_DIR cairo/cairo.h)
find_library(CAIRO_LIBRARY cairo)
if(CAIRO_INCLUDE_DIR)
    file(READ "${CAIRO_INCLUDE_DIR}/cairo/cairo-version.h" text)
    string(REGEX REPLACE ".*VERSION_MAJOR ([0-9]+).*VERSION_MINOR ([0-9]+).*VERSION_MICRO ([0-9]+).*" "\\1.\\2.\\3" Cairo_VERSION "${text}")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Cairo REQUIRED_VARS CAIRO_LIBRARY CAIRO_INCLUDE_DIR VERSION_VAR Cairo_VERSION)
mark_as_advanced(CAIRO_INCLUDE_DIR CAIRO_LIBRARY)
if(Cairo_FOUND AND NOT TARGET Cairo::Cairo)
    add_library(Cairo::Cairo UNKNOWN IMPORTED)
    set_target_properties(Cairo::Cairo PROPERTIES
        IMPORTED_LOCATION "${CAIRO_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${CAIRO_INCLUDE_DIR}")
endif()
