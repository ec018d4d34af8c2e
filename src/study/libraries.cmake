# External packages that only taut_study uses.
find_package(nlohmann_json 3.11 REQUIRED)
target_link_libraries(taut_study PRIVATE nlohmann_json::nlohmann_json)
