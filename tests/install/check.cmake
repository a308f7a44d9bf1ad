# Installs into a scratch prefix, then configures, builds and runs the consumer against it.
# VTK, HDF5 and the libraries of the case reader are hidden from the consumer: the core must do without them.
set(scratch ${build}/install_check)
file(REMOVE_RECURSE ${scratch})

function(step)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT status EQUAL 0)
        list(JOIN ARGN " " command)
        message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
    endif()
endfunction()

step(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix)
foreach(installed bin/tiretherm include/tiretherm/mesh/mesh.hpp share/tiretherm/cases)
    if(NOT EXISTS ${scratch}/prefix/${installed})
        message(FATAL_ERROR "${installed} was not installed")
    endif()
endforeach()

set(hidden "")
foreach(package VTK HDF5 tomlplusplus UDUNITS2 nlohmann_json CLI11)
    list(APPEND hidden -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
step(${CMAKE_COMMAND} -S ${source} -B ${scratch}/consumer -G ${generator} -DCMAKE_CXX_COMPILER=${compiler}
    -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${scratch}/prefix ${hidden})
step(${CMAKE_COMMAND} --build ${scratch}/consumer)
step(${scratch}/consumer/consumer)
