# External packages that only taut_render uses, and the shaders it carries inside.
find_package(glm REQUIRED)
find_path(TAUT_STB_INCLUDE stb_truetype.h PATH_SUFFIXES stb REQUIRED)
target_link_libraries(taut_render PRIVATE glm::glm)
target_include_directories(taut_render SYSTEM PRIVATE ${TAUT_STB_INCLUDE})

# Either back end will do; what is missing at build time, or not wanted, is left out and says so at run time.
option(TAUT_WITH_OSMESA "Draw with OSMesa where it is installed" ON)
option(TAUT_WITH_EGL "Draw with EGL where it is installed" ON)
find_path(TAUT_OSMESA_INCLUDE GL/osmesa.h)
find_library(TAUT_OSMESA_LIBRARY OSMesa)
if(TAUT_WITH_OSMESA AND TAUT_OSMESA_INCLUDE AND TAUT_OSMESA_LIBRARY)
  target_compile_definitions(taut_render PRIVATE TAUT_HAS_OSMESA)
  target_link_libraries(taut_render PRIVATE ${TAUT_OSMESA_LIBRARY})
endif()
find_path(TAUT_EGL_INCLUDE EGL/egl.h)
find_library(TAUT_EGL_LIBRARY EGL)
if(TAUT_WITH_EGL AND TAUT_EGL_INCLUDE AND TAUT_EGL_LIBRARY)
  target_compile_definitions(taut_render PRIVATE TAUT_HAS_EGL)
  target_link_libraries(taut_render PRIVATE ${TAUT_EGL_LIBRARY})
endif()

set(taut_shader_folder ${PROJECT_SOURCE_DIR}/shaders)
file(GLOB taut_shaders CONFIGURE_DEPENDS ${taut_shader_folder}/*.vert ${taut_shader_folder}/*.frag
     ${taut_shader_folder}/*.glsl)
set(taut_embedded_shaders ${CMAKE_CURRENT_BINARY_DIR}/embedded_shaders.cpp)
add_custom_command(
  OUTPUT ${taut_embedded_shaders}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${taut_shader_folder} -DOUTPUT=${taut_embedded_shaders} -P
          ${CMAKE_CURRENT_LIST_DIR}/gl/embed_shaders.cmake
  DEPENDS ${taut_shaders} ${CMAKE_CURRENT_LIST_DIR}/gl/embed_shaders.cmake
  COMMENT "Embedding the shaders"
  VERBATIM)
target_sources(taut_render PRIVATE ${taut_embedded_shaders})
target_include_directories(taut_render PRIVATE ${CMAKE_CURRENT_LIST_DIR})

# Each context's own header brings an OpenGL that has other names than glcorearb.h.
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/gl/osmesa_context.cpp ${CMAKE_CURRENT_LIST_DIR}/gl/egl_context.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
