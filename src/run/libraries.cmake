# External packages that only taut_run uses, and what it is told of the build.
target_compile_definitions(
  taut_run PRIVATE TAUT_VERSION="${PROJECT_VERSION}" TAUT_BUILD_TYPE="$<CONFIG>"
                   TAUT_SOURCE_SCENES="${PROJECT_SOURCE_DIR}/scenes")
target_link_options(taut_run INTERFACE -Wl,--build-id)
find_package(nlohmann_json 3.11 REQUIRED)
target_link_libraries(taut_run PRIVATE nlohmann_json::nlohmann_json)
