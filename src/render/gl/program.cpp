#include "gl/program.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "base/failure.h"
#include "gl/embedded_shaders.h"

namespace taut {
namespace {

/// The name in a line #include "name"; empty for any other line.
std::string_view included_name(std::string_view line) {
  constexpr std::string_view start = "#include \"";
  if (!line.starts_with(start)) return {};
  line.remove_prefix(start.size());
  return line.substr(0, line.find('"'));
}

using Lookup = std::function<std::string(std::string_view)>;

void expand(std::string_view name, const Lookup& text_of, std::set<std::string, std::less<>>& seen,
            std::string& out) {
  if (!seen.insert(std::string(name)).second) return;
  std::istringstream lines(text_of(name));
  for (std::string line; std::getline(lines, line);) {
    if (const std::string_view included = included_name(line); !included.empty()) {
      expand(included, text_of, seen, out);
    } else {
      out += line + '\n';
    }
  }
}

std::string shader_log(const Gl& gl, GLuint shader) {
  GLint length = 0;
  gl.get_shader(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.get_shader_log(shader, length, nullptr, log.data());
  return log.c_str();
}

std::string program_log(const Gl& gl, GLuint program) {
  GLint length = 0;
  gl.get_program(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
  gl.get_program_log(program, length, nullptr, log.data());
  return log.c_str();
}

GlObject compile(const Gl& gl, GLenum stage, const std::string& source, std::string_view name) {
  GlObject shader(gl.create_shader(stage), gl.delete_shader);
  const char* text = source.c_str();
  gl.shader_source(shader.name(), 1, &text, nullptr);
  gl.compile_shader(shader.name());
  GLint compiled = GL_FALSE;
  gl.get_shader(shader.name(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    throw RunFailure("shader " + std::string(name) +
                     " doesn't compile (lines counted with its includes in place):\n" +
                     shader_log(gl, shader.name()));
  }
  return shader;
}

}  // namespace

ShaderLibrary::ShaderLibrary(std::filesystem::path folder, Defines constants)
    : folder_(std::move(folder)), constants_(std::move(constants)) {
  if (!folder_.empty() && !std::filesystem::is_directory(folder_)) {
    throw RunFailure("shader folder " + folder_.string() + " is no folder");
  }
}

std::string ShaderLibrary::text(std::string_view name) const {
  if (!folder_.empty()) {
    std::ifstream file(folder_ / name, std::ios::binary);
    if (file) return {std::istreambuf_iterator<char>(file), {}};
  }
  for (const EmbeddedShader& shader : embedded_shaders()) {
    if (shader.name == name) return std::string(shader.text);
  }
  throw RunFailure("there is no shader file " + std::string(name));
}

std::string ShaderLibrary::source(std::string_view name, const Defines& defines) const {
  std::set<std::string, std::less<>> seen;
  std::string out;
  expand(
      name, [this](std::string_view file) { return text(file); }, seen, out);
  std::string lines;
  for (const std::string& define : constants_) lines += "#define " + define + '\n';
  for (const std::string& define : defines) lines += "#define " + define + '\n';
  return out.insert(std::min(out.find('\n'), out.size() - 1) + 1, lines);
}

Program::Program(const Gl& gl, const ShaderLibrary& library, std::string_view vertex,
                 std::string_view fragment, const Defines& defines)
    : gl_(&gl), program_(gl.create_program(), gl.delete_program) {
  const GlObject vertex_shader = compile(gl, GL_VERTEX_SHADER, library.source(vertex, defines), vertex);
  const GlObject fragment_shader =
      compile(gl, GL_FRAGMENT_SHADER, library.source(fragment, defines), fragment);
  gl.attach_shader(program_.name(), vertex_shader.name());
  gl.attach_shader(program_.name(), fragment_shader.name());
  gl.link_program(program_.name());
  GLint linked = GL_FALSE;
  gl.get_program(program_.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    throw RunFailure("shaders " + std::string(vertex) + " and " + std::string(fragment) + " don't link:\n" +
                     program_log(gl, program_.name()));
  }
  const GLuint block = gl.uniform_block_index(program_.name(), "Frame");
  if (block != GL_INVALID_INDEX) gl.uniform_block_binding(program_.name(), block, 0);
  use();
  set("shadow_map", 0);
  set("light_map", 1);
  set("blocker_map", 5);
  set("shade_map", 6);
}

void Program::set(const char* uniform, int value) const {
  gl_->set_integer(gl_->uniform_location(program_.name(), uniform), value);
}

void Program::set(const char* uniform, const glm::vec3& vector) const {
  gl_->set_vector(gl_->uniform_location(program_.name(), uniform), vector.x, vector.y, vector.z);
}

}  // namespace taut
