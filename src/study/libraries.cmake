# External packages that only taut_study uses.
target_link_libraries(taut_study PRIVATE nlohmann_json::nlohmann_json)
