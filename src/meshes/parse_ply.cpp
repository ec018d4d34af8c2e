#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "raw_mesh.h"

// Read here, and not by Assimp, which never comes to an end of some damaged files.

namespace taut {
namespace {

constexpr std::string_view between_words = " \t\r\n";

// A type of number: its bytes, and whether it is real or has a sign.
struct PlyType {
  std::string_view name, other_name;
  std::size_t bytes = 0;
  bool real = false, has_sign = false;
};
constexpr std::array<PlyType, 8> ply_types{{{"char", "int8", 1, false, true},
                                            {"uchar", "uint8", 1, false, false},
                                            {"short", "int16", 2, false, true},
                                            {"ushort", "uint16", 2, false, false},
                                            {"int", "int32", 4, false, true},
                                            {"uint", "uint32", 4, false, false},
                                            {"float", "float32", 4, true, true},
                                            {"double", "float64", 8, true, true}}};

struct PlyProperty {
  std::string_view name;
  PlyType type;
  std::optional<PlyType> count;  // of a list
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

class PlyParser {
 public:
  PlyParser(std::string_view bytes, const std::string& called) : bytes_(bytes), called_(called) {}

  RawMesh parse() {
    read_header();
    for (const PlyElement& element : elements_) {
      if (element.properties.empty()) continue;
      for (std::uint64_t i = 0; i < element.count; ++i) read_one(element);
    }
    for (const Index corner : mesh_.corners)
      if (corner >= mesh_.vertices.size())
        fail(fmt::format("a face has vertex {}, counted from 0, and there are {}", corner,
                         mesh_.vertices.size()));
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(std::string_view message) const {
    throw BadRequest(text_ ? fmt::format("{}:{}: {}", called_, line_, message)
                           : fmt::format("{}: {}", called_, message));
  }

  std::vector<std::string_view> header_line() {
    ++line_;
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) fail("the header does not end with \"end_header\"");
    std::string_view line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    std::vector<std::string_view> words;
    for (std::size_t begin = line.find_first_not_of(between_words); begin != std::string_view::npos;
         begin = line.find_first_not_of(between_words)) {
      line.remove_prefix(begin);
      const std::size_t length = std::min(line.find_first_of(between_words), line.size());
      words.push_back(line.substr(0, length));
      line.remove_prefix(length);
    }
    return words;
  }

  void read_header() {
    for (;;) {
      const std::vector<std::string_view> words = header_line();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info" || words[0] == "ply") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format" && words.size() > 1)
        read_format(words[1]);
      else if (words[0] == "element" && words.size() == 3)
        elements_.push_back({words[1], whole(words[2]), {}});
      else if (words[0] == "property" && words.size() >= 3 && !elements_.empty())
        read_property(words);
      else
        fail(fmt::format("{} begins no line of a header", in_quotes(words[0])));
    }
    text_ = !binary_;
    ++line_;  // what follows begins on the next one
  }

  void read_format(std::string_view format) {
    binary_ = format != "ascii";
    swapped_ = format == "binary_big_endian";
    if (binary_ && !swapped_ && format != "binary_little_endian")
      fail(fmt::format("{} is no format of a PLY file", in_quotes(format)));
  }

  std::uint64_t whole(std::string_view word) const {
    std::uint64_t number = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (code != std::errc{} || end != word.data() + word.size())
      fail(fmt::format("an element needs a number, and {} is none", in_quotes(word)));
    return number;
  }

  PlyType type(std::string_view name) const {
    for (const PlyType& each : ply_types)
      if (each.name == name || each.other_name == name) return each;
    fail(fmt::format("{} is no type of a property", in_quotes(name)));
  }

  void read_property(const std::vector<std::string_view>& words) {
    PlyElement& element = elements_.back();
    if (words[1] == "list" && words.size() == 5)
      element.properties.push_back({words[4], type(words[3]), type(words[2])});
    else
      element.properties.push_back({words[2], type(words[1]), std::nullopt});
  }

  // The next number of a text, or of bytes.
  double next(const PlyType& of) { return binary_ ? next_of_bytes(of) : next_of_text(); }

  double next_of_text() {
    for (; at_ < bytes_.size() && between_words.find(bytes_[at_]) != std::string_view::npos; ++at_)
      if (bytes_[at_] == '\n') ++line_;
    const std::size_t end = std::min(bytes_.find_first_of(between_words, at_), bytes_.size());
    const std::string_view word = bytes_.substr(at_, end - at_);
    if (word.empty()) fail("the file ends too soon");
    at_ = end;
    double number = 0.0;
    const auto [last, code] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (code != std::errc{} || last != word.data() + word.size() || !std::isfinite(number))
      fail(fmt::format("{} is no number", in_quotes(word)));
    return number;
  }

  double next_of_bytes(const PlyType& of) {
    if (bytes_.size() - at_ < of.bytes) fail("the file ends too soon");
    std::array<char, 8> raw{};
    std::memcpy(raw.data(), bytes_.data() + at_, of.bytes);
    at_ += of.bytes;
    if (swapped_) std::reverse(raw.data(), raw.data() + of.bytes);
    if (of.real && of.bytes == 8) return as<double>(raw);
    if (of.real) return static_cast<double>(as<float>(raw));
    const double number = static_cast<double>(as<std::uint64_t>(raw));
    const double most = std::ldexp(1.0, static_cast<int>(8 * of.bytes));
    return of.has_sign && number >= 0.5 * most ? number - most : number;
  }

  template <class Number>
  static Number as(const std::array<char, 8>& raw) {
    Number number{};
    std::memcpy(&number, raw.data(), sizeof number);
    return number;
  }

  void read_one(const PlyElement& element) {
    Vec3 place = Vec3::Zero();
    std::vector<Index> corners;
    for (const PlyProperty& property : element.properties) {
      const double many = property.count ? next(*property.count) : 1.0;
      const bool of_face = element.name == "face" && property.count.has_value() &&
                           (property.name == "vertex_indices" || property.name == "vertex_index");
      for (double i = 0.0; i < many; ++i) {
        const double number = next(property.type);
        if (property.name.size() == 1 && property.name >= "x" && property.name <= "z")
          place[property.name[0] - 'x'] = number;
        if (!of_face) continue;
        if (!(number >= 0.0 && number < 4e9) || number != std::floor(number))
          fail(fmt::format("a corner of a face is the number of a vertex, and {} is none", number));
        corners.push_back(static_cast<Index>(number));
      }
    }
    if (element.name == "vertex") {
      mesh_.vertices.push_back(place);
      if (text_) mesh_.vertex_line.push_back(line_);
    } else if (element.name == "face" && corners.size() >= 3) {
      mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
      mesh_.face_begin.push_back(static_cast<Index>(mesh_.corners.size()));
      if (text_) mesh_.face_line.push_back(line_);
    }
  }

  std::string_view bytes_;
  const std::string& called_;
  RawMesh mesh_;
  std::vector<PlyElement> elements_;
  std::size_t at_ = 0, line_ = 0;
  bool text_ = true, binary_ = false, swapped_ = false;
};

}  // namespace

RawMesh parse_ply(const std::string& bytes, const std::string& called) {
  if (!bytes.starts_with("ply"))
    throw BadRequest(fmt::format("{}: not a PLY file, which begins with \"ply\"", called));
  return PlyParser(bytes, called).parse();
}

}  // namespace taut
