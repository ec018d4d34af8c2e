#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "raw_mesh.h"

// Read here, and not by Assimp, which never comes to an end of some damaged files of text.

namespace taut {
namespace {

constexpr std::size_t header = 80, counted = 84, facet = 50;  // bytes of a file of bytes

// How many facets a file of bytes says it has; nothing where its length is another.
std::optional<std::uint32_t> facets_in(std::string_view bytes) {
  if (bytes.size() < counted) return std::nullopt;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header, sizeof count);
  if (bytes.size() < counted + std::size_t{count} * facet) return std::nullopt;
  return count;
}

void add_facet(RawMesh& mesh, const std::array<Vec3, 3>& corners) {
  for (const Vec3& corner : corners) {
    mesh.corners.push_back(static_cast<Index>(mesh.vertices.size()));
    mesh.vertices.push_back(corner);
  }
  mesh.face_begin.push_back(static_cast<Index>(mesh.corners.size()));
}

// Of each facet a normal, three corners and two bytes more.
RawMesh parse_bytes(std::string_view bytes, std::uint32_t count) {
  RawMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), bytes.data() + counted + std::size_t{i} * facet, sizeof numbers);
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = Vec3(numbers[3 * k + 3], numbers[3 * k + 4], numbers[3 * k + 5]);
    add_facet(mesh, corners);
  }
  return mesh;
}

class StlText {
 public:
  StlText(std::string_view text, const std::string& called) : text_(text), called_(called) {}

  RawMesh parse() {
    std::array<Vec3, 3> corners;
    std::size_t known = 0;
    for (std::string_view line = next_line(); !at_end_; line = next_line()) {
      const std::string_view word = take_word(line);
      if (word == "solid") begin_solid(line);
      if (word == "facet") known = 0;
      if (word == "vertex") {
        if (known == 3) fail("a facet has three corners");
        corners[known++] = place(line);
      }
      if (word != "endfacet") continue;
      if (known != 3) fail(fmt::format("a facet has three corners, not {}", known));
      if (in_solid_)
        mesh_.face_groups.push_back(
            {static_cast<Index>(mesh_.face_count()), static_cast<Index>(mesh_.groups.size() - 1)});
      mesh_.face_line.push_back(line_);
      mesh_.vertex_line.insert(mesh_.vertex_line.end(), 3, line_);
      add_facet(mesh_, corners);
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw BadRequest(fmt::format("{}:{}: {}", called_, line_, message));
  }
  std::string_view next_line() {
    at_end_ = text_.empty();
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    return line;
  }
  static std::string_view take_word(std::string_view& line) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
    const std::size_t end = std::min(line.find_first_of(" \t\r", begin), line.size());
    const std::string_view word = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return word;
  }
  void begin_solid(std::string_view line) {
    const std::string_view name = take_word(line);
    in_solid_ = !name.empty();
    if (in_solid_) mesh_.groups.emplace_back(name);
  }
  Vec3 place(std::string_view line) const {
    Vec3 made;
    for (int axis = 0; axis < 3; ++axis) {
      std::string_view word = take_word(line);
      const std::string_view whole = word;
      if (word.starts_with('+')) word.remove_prefix(1);
      const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), made[axis]);
      if (code != std::errc{} || end != word.data() + word.size() || !std::isfinite(made[axis]))
        fail(fmt::format("a corner needs three numbers, and {} is none", in_quotes(whole)));
    }
    return made;
  }

  std::string_view text_;
  const std::string& called_;
  RawMesh mesh_;
  std::size_t line_ = 0;
  bool in_solid_ = false, at_end_ = false;
};

}  // namespace

RawMesh parse_stl(std::string_view bytes, const std::string& called) {
  const std::optional<std::uint32_t> count = facets_in(bytes);
  const bool text = bytes.starts_with("solid") && bytes.find("facet") != std::string_view::npos;
  if (!text && !count)
    throw BadRequest(fmt::format("{}: not a whole STL file: it is {} bytes long, and says it has more",
                                 called, bytes.size()));
  return text ? StlText(bytes, called).parse() : parse_bytes(bytes, *count);
}

}  // namespace taut
