#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "raw_mesh.h"

// Read here, and not by a library, because of what those that there are lose: Assimp gives every face corners
// of its own, so that vertices have no numbers any more, and keeps no lines.

namespace taut {
namespace {

constexpr std::string_view blanks = " \t\r";

// What may begin a line; of these only v, f, g, o and usemtl say anything here.
constexpr std::array<std::string_view, 41> keywords{
    "v",      "f",          "g",      "o",    "usemtl", "vt",     "vn",    "vp",        "s",
    "mtllib", "l",          "p",      "mg",   "usemap", "maplib", "bevel", "c_interp",  "d_interp",
    "lod",    "shadow_obj", "cstype", "deg",  "bmat",   "step",   "curv",  "curv2",     "surf",
    "parm",   "trim",       "hole",   "scrv", "sp",     "end",    "con",   "trace_obj", "call",
    "csh",    "ctech",      "stech",  "res",  "bzp"};

// The first word of a text, which is left with what comes behind it.
std::string_view take_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

class ObjParser {
 public:
  explicit ObjParser(const std::string& called) : called_(called) {}

  RawMesh parse(std::string_view text) {
    std::string joined;  // a line that goes on, as a backslash at its end says
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line_;
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (line.ends_with('\\')) {
        line.remove_suffix(1);
        joined.append(line).push_back(' ');
        continue;
      }
      if (joined.empty()) {
        take(line);
      } else {
        take(joined.append(line));
        joined.clear();
      }
    }
    if (mesh_.vertices.empty()) throw BadRequest(fmt::format("{}: there are no vertices in it", called_));
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw BadRequest(fmt::format("{}:{}: {}", called_, line_, message));
  }

  void take(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::string_view keyword = take_word(line);
    if (keyword.empty()) return;
    if (keyword == "v") {
      take_vertex(line);
    } else if (keyword == "f") {
      take_face(line);
    } else if (keyword == "g") {
      groups_.clear();
      for (std::string_view name = take_word(line); !name.empty(); name = take_word(line))
        groups_.push_back(group(name));
    } else if (keyword == "o") {
      object_ = rest_of(line);
    } else if (keyword == "usemtl") {
      material_ = rest_of(line);
    } else if (std::ranges::find(keywords, keyword) == keywords.end()) {
      fail(fmt::format("{} begins no line of an OBJ file", in_quotes(keyword)));
    }
  }

  // Names of objects and materials may have blanks.
  std::vector<Index> rest_of(std::string_view line) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return {group(line.substr(begin, line.find_last_not_of(blanks) + 1 - begin))};
  }

  Index group(std::string_view name) {
    const auto [known, is_new] =
        group_numbers_.try_emplace(std::string(name), static_cast<Index>(mesh_.groups.size()));
    if (is_new) mesh_.groups.emplace_back(name);
    return known->second;
  }

  void take_vertex(std::string_view line) {
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis) {
      std::string_view word = take_word(line);
      if (word.empty()) fail("a vertex needs three numbers");
      const std::string_view whole = word;
      if (word.starts_with('+')) word.remove_prefix(1);
      const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), place[axis]);
      if (code != std::errc{} || end != word.data() + word.size() || !std::isfinite(place[axis]))
        fail(fmt::format("a vertex needs three numbers, and {} is none", in_quotes(whole)));
    }
    mesh_.vertices.push_back(place);
    mesh_.vertex_line.push_back(line_);
  }

  // A corner is the number of a vertex, from 1, or below 0 back from the last one; behind a slash follow
  // numbers of what is not needed here.
  Index corner(std::string_view word) const {
    const std::string_view digits = word.substr(0, word.find('/'));
    long long number = 0;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (code != std::errc{} || end != digits.data() + digits.size() || number == 0)
      fail(fmt::format("a corner of a face is the number of a vertex, and {} is none", in_quotes(word)));
    const auto count = static_cast<long long>(mesh_.vertices.size());
    const long long place = number > 0 ? number - 1 : count + number;
    if (place < 0 || place >= count)
      fail(fmt::format("the face has vertex {}, and there are {} before it", number, count));
    return static_cast<Index>(place);
  }

  void take_face(std::string_view line) {
    const std::size_t before = mesh_.corners.size();
    for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
      mesh_.corners.push_back(corner(word));
    const std::size_t count = mesh_.corners.size() - before;
    if (count < 3) fail(fmt::format("a face needs three corners, not {}", count));
    const auto face = static_cast<Index>(mesh_.face_count());
    for (const auto* names : {&groups_, &object_, &material_})
      for (const Index name : *names) mesh_.face_groups.push_back({face, name});
    mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
    mesh_.face_line.push_back(line_);
  }

  std::string called_;
  RawMesh mesh_;
  std::unordered_map<std::string, Index> group_numbers_;
  std::vector<Index> groups_, object_, material_;  // that faces are in from here on
  std::size_t line_ = 0;
};

}  // namespace

std::string place_in(std::string_view called, const std::vector<std::size_t>& lines, std::size_t number) {
  return number < lines.size() ? fmt::format("{}:{}", called, lines[number]) : std::string(called);
}

RawMesh parse_obj(std::string_view text, const std::string& called) {
  return ObjParser(called).parse(text);
}

}  // namespace taut
