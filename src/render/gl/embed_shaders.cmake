# Writes OUTPUT, a C++ file that holds every shader of FOLDER as a string literal. Run with cmake -P.
file(GLOB shaders ${FOLDER}/*.vert ${FOLDER}/*.frag ${FOLDER}/*.glsl)
list(SORT shaders)
set(entries "")
foreach(shader IN LISTS shaders)
  get_filename_component(name ${shader} NAME)
  file(READ ${shader} text)
  string(APPEND entries "      {\"${name}\", R\"shader(${text})shader\"},\n")
endforeach()
file(WRITE ${OUTPUT} "#include \"gl/embedded_shaders.h\"

namespace taut {

std::span<const EmbeddedShader> embedded_shaders() {
  static constexpr EmbeddedShader shaders[] = {
${entries}  };
  return shaders;
}

}  // namespace taut
")
