# External packages that only taut_study uses.
target_link_libraries(taut_study PRIVATE nlohmann_json::nlohmann_json)
target_compile_options(taut_study PRIVATE ${lightly})
target_precompile_headers(taut_study REUSE_FROM taut_json_headers)
