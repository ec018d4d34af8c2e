# External packages that only taut_scene uses.
target_link_libraries(taut_scene PRIVATE nlohmann_json::nlohmann_json)
