# What taut_host is told of the build.
target_compile_definitions(
  taut_host PRIVATE TAUT_VERSION="${PROJECT_VERSION}" TAUT_BUILD_TYPE="$<CONFIG>"
                   TAUT_SOURCE_SCENES="${PROJECT_SOURCE_DIR}/scenes")
target_link_options(taut_host INTERFACE -Wl,--build-id)

# The commit stands beside what was measured; looked up again when the repository moves.
find_package(Git QUIET)
set(commit unknown)
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${PROJECT_SOURCE_DIR} rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE found_commit OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE no_commit ERROR_QUIET)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${PROJECT_SOURCE_DIR} rev-parse --path-format=absolute --git-path logs/HEAD
                  OUTPUT_VARIABLE head_log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT no_commit)
    set(commit ${found_commit})
    if(EXISTS "${head_log}")
      set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${head_log})
    endif()
  endif()
endif()
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}} -ffp-contract=off" flags)
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/host/machine.cpp
                            PROPERTIES COMPILE_DEFINITIONS "TAUT_COMMIT=\"${commit}\";TAUT_FLAGS=\"${flags}\"")

if(TAUT_SANITIZE)
  target_compile_definitions(taut_host PRIVATE TAUT_SANITIZED)
endif()
