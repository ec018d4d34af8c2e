# External packages that only taut_output uses.
pkg_check_modules(ISAL REQUIRED IMPORTED_TARGET libisal)
pkg_check_modules(TIFF REQUIRED IMPORTED_TARGET libtiff-4)
pkg_check_modules(ARCHIVE REQUIRED IMPORTED_TARGET libarchive)
find_path(TAUT_STB_WRITE_INCLUDE NAMES stb_image_write.h stb_image.h PATH_SUFFIXES stb REQUIRED)
target_link_libraries(taut_output PRIVATE PkgConfig::ISAL PkgConfig::TIFF PkgConfig::ARCHIVE nlohmann_json::nlohmann_json)
target_include_directories(taut_output SYSTEM PRIVATE ${TAUT_STB_WRITE_INCLUDE})

# stb brings its own names and settings.
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/output/png.cpp ${CMAKE_CURRENT_SOURCE_DIR}/output/png_read.cpp
                            PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Beside loops over pixels, the files of templates that would take long to optimise.
set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/output/manifest.cpp ${CMAKE_CURRENT_SOURCE_DIR}/output/export/glb.cpp
                            PROPERTIES COMPILE_OPTIONS "${lightly}" SKIP_PRECOMPILE_HEADERS ON)
