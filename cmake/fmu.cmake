# SPDX-License-Identifier: BSD-3-Clause
# The shared object of an FMU: the session with all that it needs beside glibc, so that it runs on any Linux whose glibc is not older.
# It lies beside the program, which packs it. It exports the functions of the standard alone; two of them in one process, or in a
# program that has tiretherm itself, do not see each other. Neither the sanitizers nor the OpenMP of clang go into it.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(archives "")
    foreach(name cholmod amd colamd suitesparseconfig)
        find_library(SUITESPARSE_ARCHIVE_${name} lib${name}.a REQUIRED)
        mark_as_advanced(SUITESPARSE_ARCHIVE_${name})
        list(APPEND archives ${SUITESPARSE_ARCHIVE_${name}})
    endforeach()
    file(GLOB fmu_sources CONFIGURE_DEPENDS interface/fmu/*.cpp)

    set(fmu_exports ${PROJECT_SOURCE_DIR}/interface/fmu/exports.map)
    add_library(tiretherm_fmu MODULE ${fmu_sources})
    add_dependencies(tiretherm_fmu tiretherm_core)  # its archive alone, without the shared libraries that it asks for
    set_target_properties(tiretherm_fmu PROPERTIES PREFIX "" LINK_DEPENDS "${fmu_exports};$<TARGET_FILE:tiretherm_core>" SKIP_BUILD_RPATH ON)
    target_compile_features(tiretherm_fmu PRIVATE cxx_std_20)
    # As the core, but for OpenMP's runtime, in whose place there is one thread.
    target_compile_definitions(tiretherm_fmu PRIVATE EIGEN_DONT_PARALLELIZE)
    target_compile_options(tiretherm_fmu PRIVATE ${OpenMP_CXX_FLAGS})
    target_include_directories(tiretherm_fmu PRIVATE ${PROJECT_SOURCE_DIR})
    target_include_directories(tiretherm_fmu SYSTEM PRIVATE ${CHOLMOD_INCLUDE_DIR})
    target_link_libraries(tiretherm_fmu PRIVATE Eigen3::Eigen $<TARGET_FILE:tiretherm_core> ${archives} m)
    target_link_options(tiretherm_fmu PRIVATE -static-libstdc++ -static-libgcc -s -Wl,--gc-sections -Wl,-z,defs
        -Wl,--exclude-libs,ALL -Wl,--version-script=${fmu_exports})
    add_dependencies(tiretherm_post tiretherm_fmu)
    install(TARGETS tiretherm_fmu LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/tiretherm COMPONENT program)
endif()
