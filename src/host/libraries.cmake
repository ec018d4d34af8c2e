# What taut_host is told of the build.
target_compile_definitions(taut_host PRIVATE TAUT_VERSION="${PROJECT_VERSION}" TAUT_BUILD_TYPE="$<CONFIG>")
target_link_options(taut_host INTERFACE -Wl,--build-id)

# A program in the build folder finds the scenes where an installed one does: relative to itself.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/taut)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/scenes ${PROJECT_BINARY_DIR}/share/taut/scenes SYMBOLIC)

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

# What decides results, as hashes of files (host/versions.h); worked out again when one of them changes.
function(taut_hash_of result)
  set(hashes "")
  foreach(file ${ARGN})
    file(SHA256 ${file} hash)
    string(APPEND hashes ${hash})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  string(SHA256 hash "${hashes}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${result} ${hash} PARENT_SCOPE)
endfunction()
file(GLOB_RECURSE drawing_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/* ${CMAKE_CURRENT_SOURCE_DIR}/render/*
     ${CMAKE_CURRENT_SOURCE_DIR}/view/*)
foreach(name captions colouring exact_shape film_time look_ahead painter panels settled_colours settled_view trail_recorder)
  list(APPEND drawing_files ${CMAKE_CURRENT_SOURCE_DIR}/frames/${name}.cpp)
endforeach()
file(GLOB_RECURSE judging_files CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/measure/*)
taut_hash_of(TAUT_PHYSICS_VERSION ${PROJECT_SOURCE_DIR}/tests/golden/state-hashes.txt)
taut_hash_of(TAUT_DRAWING_VERSION ${drawing_files})
taut_hash_of(TAUT_JUDGING_VERSION ${judging_files})
configure_file(${CMAKE_CURRENT_SOURCE_DIR}/host/versions_of_this_build.h.in
               ${CMAKE_CURRENT_BINARY_DIR}/host/versions_of_this_build.h @ONLY)
target_include_directories(taut_host PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/host)
