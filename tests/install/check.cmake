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

# The example in C, as its own page says.
step(${CMAKE_COMMAND} -S ${source}/../../examples/four_tires -B ${scratch}/four_tires -G ${generator}
    -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${scratch}/prefix)
step(${CMAKE_COMMAND} --build ${scratch}/four_tires)
step(${scratch}/four_tires/four_tires ${scratch}/prefix/share/tiretherm/cases/two_node/4000N_100kmh.toml 1)

consumer(post)
step(${program} ${scratch}/prefix/share/tiretherm/cases/two_node/4000N_100kmh.toml ${scratch}/out)
