# What only taut_meshes uses.
find_path(TAUT_ASSIMP_INCLUDE assimp/Importer.hpp REQUIRED)
find_library(TAUT_ASSIMP assimp REQUIRED)
target_include_directories(taut_meshes SYSTEM PRIVATE ${TAUT_ASSIMP_INCLUDE})
target_link_libraries(taut_meshes PRIVATE ${TAUT_ASSIMP})
