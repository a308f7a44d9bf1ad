# SPDX-License-Identifier: BSD-3-Clause
# CVODE of SUNDIALS as one target: an independent solution of the same equations, for tests and benchmarks only.
find_package(SUNDIALS REQUIRED COMPONENTS cvode nvecserial
    sunmatrixband sunmatrixdense sunmatrixsparse sunlinsolband sunlinsoldense sunlinsolklu sunlinsolspgmr)
add_library(tiretherm_cvode INTERFACE)
target_link_libraries(tiretherm_cvode INTERFACE SUNDIALS::cvode_shared SUNDIALS::nvecserial_shared
    SUNDIALS::sunlinsolband_shared SUNDIALS::sunlinsoldense_shared SUNDIALS::sunlinsolklu_shared
    SUNDIALS::sunlinsolspgmr_shared)
