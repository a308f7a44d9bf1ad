# SPDX-License-Identifier: BSD-3-Clause
# The shared object of an FMU: the session with all that it needs beside glibc, so that it runs on any Linux whose glibc is not older.
# It lies beside the program, which packs it. It exports the functions of the standard alone; two of them in one process, or in a
# program that has tiretherm itself, do not see each other. Neither the sanitizers nor the OpenMP of clang go into it.
#
# Code of a program cannot be put into a shared object, so what a session needs of the core is compiled a second time, most of it in
# batches; effects name their parts alike, and go one by one.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64" AND NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(archives "")
    foreach(name cholmod amd colamd suitesparseconfig)
        find_library(SUITESPARSE_ARCHIVE_${name} lib${name}.a REQUIRED)
        mark_as_advanced(SUITESPARSE_ARCHIVE_${name})
        list(APPEND archives ${SUITESPARSE_ARCHIVE_${name}})
    endforeach()
    set(session_sources ${core_sources})
    list(FILTER session_sources EXCLUDE REGEX "/solver/(hot_spot|sensitivity)/")
    list(APPEND session_sources ${PROJECT_SOURCE_DIR}/solver/sensitivity/free_parameter.cpp)
    set(one_by_one ${session_sources})
    list(FILTER one_by_one INCLUDE REGEX "/physics/effects/|/(field_line|section|tire|block_solver|krylov)[.]cpp$")
    file(GLOB fmu_sources CONFIGURE_DEPENDS interface/fmu/*.cpp)
    set_source_files_properties(${one_by_one} ${fmu_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

    set(fmu_exports ${PROJECT_SOURCE_DIR}/interface/fmu/exports.map)
    add_library(tiretherm_fmu MODULE ${session_sources} ${fmu_sources})
    set_target_properties(tiretherm_fmu PROPERTIES PREFIX "" LINK_DEPENDS ${fmu_exports} SKIP_BUILD_RPATH ON
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_features(tiretherm_fmu PRIVATE cxx_std_20)
    # As the core, but for OpenMP's runtime, in whose place there is one thread.
    target_compile_definitions(tiretherm_fmu PRIVATE EIGEN_DONT_PARALLELIZE)
    target_compile_options(tiretherm_fmu PRIVATE ${OpenMP_CXX_FLAGS})
    target_include_directories(tiretherm_fmu PRIVATE ${PROJECT_SOURCE_DIR})
    target_include_directories(tiretherm_fmu SYSTEM PRIVATE ${CHOLMOD_INCLUDE_DIR})
    target_link_libraries(tiretherm_fmu PRIVATE Eigen3::Eigen ${archives} m)
    target_link_options(tiretherm_fmu PRIVATE -static-libstdc++ -static-libgcc -s -Wl,--gc-sections -Wl,-z,defs
        -Wl,--exclude-libs,ALL -Wl,--version-script=${fmu_exports})
    tiretherm_precompile(tiretherm_fmu)
    tiretherm_batches(tiretherm_fmu)
    add_dependencies(tiretherm_post tiretherm_fmu)
    install(TARGETS tiretherm_fmu LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
