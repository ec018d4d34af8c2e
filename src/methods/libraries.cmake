# External packages that only taut_methods uses.
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
target_link_libraries(taut_methods PRIVATE PkgConfig::HWY)

# Under sanitizers clang takes many minutes for all the vector kernels; the plain one goes through the same
# memory.
if(TAUT_SANITIZE)
  target_compile_definitions(taut_methods PRIVATE HWY_COMPILE_ONLY_SCALAR)
endif()

# They include themselves, once for every set of vector instructions.
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/methods/direct/link_kernels.cpp
                            ${CMAKE_CURRENT_SOURCE_DIR}/methods/direct/path_kernels.cpp
                            ${CMAKE_CURRENT_SOURCE_DIR}/methods/forces/mass_kernels.cpp
                            ${CMAKE_CURRENT_SOURCE_DIR}/methods/high_order/chain_motion.cpp
                            ${CMAKE_CURRENT_SOURCE_DIR}/methods/high_order/phase_sums.cpp
                            ${CMAKE_CURRENT_SOURCE_DIR}/methods/relax/kernels.cpp
                            ${CMAKE_CURRENT_SOURCE_DIR}/methods/relax/line_kernels.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
