# SPDX-License-Identifier: BSD-3-Clause
# `cmake --install`: program, libraries, headers, licence, case library and the package files of find_package(tiretherm).
# Each library has its own export, so that whoever asks for the core alone needs neither VTK nor HDF5.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/tiretherm)

install(TARGETS tiretherm COMPONENT program)
install(TARGETS tiretherm_vtk LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/tiretherm COMPONENT program)
install(FILES interface/tiretherm.h interface/tiretherm_cases.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
foreach(part IN LISTS TIRETHERM_PARTS ITEMS session cases)
    install(TARGETS tiretherm_${part} EXPORT tiretherm_${part} COMPONENT development)
    install(EXPORT tiretherm_${part} NAMESPACE tiretherm:: FILE tiretherm_${part}.cmake DESTINATION ${package_dir}
        COMPONENT development)
endforeach()
install(DIRECTORY mesh physics solver input diagnosis post calls DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/tiretherm COMPONENT development
    FILES_MATCHING PATTERN "*.hpp" PATTERN "*.list")  # a header may include a list
install(FILES LICENSE docs/licences.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY cases/ DESTINATION ${CMAKE_INSTALL_DATADIR}/tiretherm/cases COMPONENT program USE_SOURCE_PERMISSIONS)
install(PROGRAMS tools/spreadsheet_to_case.py DESTINATION ${CMAKE_INSTALL_DATADIR}/tiretherm/tools
    COMPONENT program)

# Completion of the command line, written by the program itself from the options that it has.
set(completion ${PROJECT_BINARY_DIR}/completion)
foreach(shell bash zsh)
    install(CODE "file(MAKE_DIRECTORY \"${completion}\")
        execute_process(COMMAND \"$<TARGET_FILE:tiretherm>\" completion ${shell} OUTPUT_FILE \"${completion}/${shell}\"
            COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)
endforeach()
install(FILES ${completion}/bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME tiretherm
    COMPONENT program)
install(FILES ${completion}/zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions RENAME _tiretherm
    COMPONENT program)

configure_package_config_file(cmake/tirethermConfig.cmake.in ${PROJECT_BINARY_DIR}/tirethermConfig.cmake
    INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tirethermConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tirethermConfig.cmake ${PROJECT_BINARY_DIR}/tirethermConfigVersion.cmake
    cmake/FindCHOLMOD.cmake cmake/FindUDUNITS2.cmake
    DESTINATION ${package_dir} COMPONENT development)
