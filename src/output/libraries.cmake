# External packages that only taut_output uses.
pkg_check_modules(ISAL REQUIRED IMPORTED_TARGET libisal)
target_link_libraries(taut_output PRIVATE PkgConfig::ISAL nlohmann_json::nlohmann_json)

# Beside loops over pixels, the one file of templates that would take long to optimise.
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/output/manifest.cpp
                            PROPERTIES COMPILE_OPTIONS "${lightly}" SKIP_PRECOMPILE_HEADERS ON)
