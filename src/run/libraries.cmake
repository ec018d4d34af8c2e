# External packages that only taut_run uses, and what it is told of the build.
target_compile_definitions(
  taut_run PRIVATE TAUT_VERSION="${PROJECT_VERSION}" TAUT_BUILD_TYPE="$<CONFIG>"
                   TAUT_SOURCE_SCENES="${PROJECT_SOURCE_DIR}/scenes")
target_link_options(taut_run INTERFACE -Wl,--build-id)
