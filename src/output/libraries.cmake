# External packages that only taut_output uses.
pkg_check_modules(ISAL REQUIRED IMPORTED_TARGET libisal)
target_link_libraries(taut_output PRIVATE PkgConfig::ISAL nlohmann_json::nlohmann_json)
