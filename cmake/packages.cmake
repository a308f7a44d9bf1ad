# SPDX-License-Identifier: BSD-3-Clause
# `cpack --preset release`: packages for Debian 12 (tiretherm, libtiretherm-dev, python3-tiretherm) and a tarball that runs from any folder.
set(CPACK_PACKAGE_VENDOR "the tiretherm authors")
set(CPACK_PACKAGE_CONTACT "the tiretherm authors <maintainers@tiretherm.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "temperature field of a rolling tire")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_COMPONENTS_ALL program development)
if(TARGET tiretherm_package)  # build it before
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tiretherm)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Finite-volume solver for the temperature of a rolling tire, through its
thickness and across its shoulders. Beside measured data it shows what the
simulation gets wrong, names the cause, extends the model and measures
the gain.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libopenblas0-serial, python3:any")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "paraview, chromium, python3-openpyxl")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtiretherm-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfmt-dev, libeigen3-dev, libsuitesparse-dev, libtomlplusplus-dev, \
libudunits2-dev, libmuparser-dev, libhdf5-dev, libceres-dev, nlohmann-json3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "tiretherm (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Static libraries, headers and CMake package files: the solver alone, the
readers of cases and logs, the diagnosis, the writers of results, and for C
sessions in real time, runs and fits.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tiretherm)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libopenblas0-serial, python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-matplotlib, python3-pandas, python3-xarray")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Cases, runs with arrays, fits, diagnoses, studies and sessions of tiretherm as
Python objects.")

# What Debian wants of each package: copyright, changelog. The date is that of SOURCE_DATE_EPOCH where it is set.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(folder ${PROJECT_BINARY_DIR}/packages/${package})
    configure_file(packaging/changelog.in ${folder}/changelog @ONLY)
    install(CODE "execute_process(COMMAND gzip -9nkf \"${folder}/changelog\" COMMAND_ERROR_IS_FATAL ANY)"
        COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES ${folder}/changelog.gz packaging/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
        COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

install(FILES packaging/lintian_overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME tiretherm
    COMPONENT program)

# What the program is linked of, in the form of SPDX: Debian's packages of its libraries.
find_program(DPKG_QUERY dpkg-query)
if(DPKG_QUERY)
    set(sbom ${PROJECT_BINARY_DIR}/packages/tiretherm.spdx.json)
    install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/packaging/sbom\" ${PROJECT_VERSION}
            \"$<TARGET_FILE:tiretherm>\" \"$<TARGET_FILE:tiretherm_vtk>\" OUTPUT_FILE \"${sbom}\" COMMAND_ERROR_IS_FATAL ANY)"
        COMPONENT program)
    install(FILES ${sbom} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/tiretherm COMPONENT program)
endif()

# A page of the manual for each command, made by help2man from its help.
find_program(HELP2MAN help2man)
if(HELP2MAN)
    file(STRINGS app/commands.list commands REGEX "^COMMAND")
    list(TRANSFORM commands REPLACE "^COMMAND\\(([a-z]+),.*" "\\1")
    set(pages ${PROJECT_BINARY_DIR}/packages/man)
    install(CODE "execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/packaging/man_pages\" ${PROJECT_VERSION}
            \"$<TARGET_FILE:tiretherm>\" \"${pages}\" ${commands} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
    install(DIRECTORY ${pages}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
endif()
include(CPack)
