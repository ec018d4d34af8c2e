# Debian packages by `cpack -G DEB` in a build folder: `taut`, the program, and `libtaut-dev`, what others link.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME taut)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_CONTACT "nobody <packager@localhost>")  # whoever hands packages on says -D CPACK_PACKAGE_CONTACT=…
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES TRUE)
set(CPACK_DEB_COMPONENT_INSTALL TRUE)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "Simulates chains, nets, cloth that tears and ragdolls from scene files, and
draws them without a display into frames, films, charts and tables.
.
Films take ffmpeg, and charts and maps gnuplot.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME taut)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS TRUE)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "ffmpeg, gnuplot-nox")

set(CPACK_COMPONENT_LIBRARY_DESCRIPTION
    "Headers, static libraries and a CMake package: models of masses joined by
links, the methods that move them, runs, and what judges runs.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libtaut-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "g++, pkg-config, libeigen3-dev, libfmt-dev, libhwy-dev")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS cmake)
include(CPack)
