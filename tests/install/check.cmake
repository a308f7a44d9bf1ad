# SPDX-License-Identifier: BSD-3-Clause
# Installs into a scratch prefix, then configures, builds and runs two programs against it: one of the core, from which VTK,
# HDF5 and the libraries of the readers are hidden, and one of all libraries.
set(scratch ${build}/install_check)
file(REMOVE_RECURSE ${scratch})

function(step)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
    endif()
endfunction()

# consumer(NAME [options of cmake]), which sets `program`
function(consumer name)
    step(${CMAKE_COMMAND} -S ${source}/${name} -B ${scratch}/${name} -G ${generator} -DCMAKE_CXX_COMPILER=${compiler}
        -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${scratch}/prefix ${ARGN})
    step(${CMAKE_COMMAND} --build ${scratch}/${name})
    set(program ${scratch}/${name}/consumer PARENT_SCOPE)
endfunction()

step(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix)
foreach(installed bin/tiretherm include/tiretherm/mesh/mesh.hpp share/tiretherm/cases share/tiretherm/tools/spreadsheet_to_case.py
        share/bash-completion/completions/tiretherm share/zsh/site-functions/_tiretherm share/doc/tiretherm/LICENSE)
    if(NOT EXISTS ${scratch}/prefix/${installed})
        message(FATAL_ERROR "${installed} was not installed")
    endif()
endforeach()

set(hidden "")
foreach(package VTK HDF5 tomlplusplus UDUNITS2 muparser Ceres nlohmann_json CLI11)
    list(APPEND hidden -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
consumer(core ${hidden})
step(${program})

# The examples in C, as their own page says.
foreach(example four_tires c_cases)
    step(${CMAKE_COMMAND} -S ${source}/../../examples/${example} -B ${scratch}/${example} -G ${generator}
        -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${scratch}/prefix)
    step(${CMAKE_COMMAND} --build ${scratch}/${example})
endforeach()
set(two_node ${scratch}/prefix/share/tiretherm/cases/two_node)
step(${scratch}/four_tires/four_tires ${two_node}/4000N_100kmh.toml 1)
step(${scratch}/c_cases/run_case ${two_node}/4000N_100kmh.toml ${scratch}/c_out)
if(NOT EXISTS ${scratch}/c_out/field.pvd)
    message(FATAL_ERROR "the example in C wrote no files for ParaView")
endif()
step(${scratch}/c_cases/vary_speed ${two_node}/4000N_100kmh.toml)
step(${scratch}/c_cases/fit_case ${two_node}/identify_saturation.toml)

consumer(post)
step(${program} ${scratch}/prefix/share/tiretherm/cases/two_node/4000N_100kmh.toml ${scratch}/out)
