# External packages that only taut_scene uses. Headers alone: who links taut_scene from an install needs none.
target_link_libraries(taut_scene PRIVATE $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
