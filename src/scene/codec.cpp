#include "codec.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/diagnostic.h"
#include "base/nearest.h"
#include "colour_names.h"

namespace taut {
namespace {

constexpr double unbounded = std::numeric_limits<double>::max();

bool wrong_type(const Node& node, const KeyInfo& info, std::string_view type, Reader& reader) {
  reader.unreadable(node.origin, fmt::format("{} must be {}{}, not {}", in_quotes(info.name), type,
                                             in_unit(info), describe(node)));
  return false;
}

// Reports a number that is not finite or too near 0 to be divided by (then false), or out
// of its range (then true: it is known).
bool accept(double x, const Node& node, const KeyInfo& info, Reader& reader) {
  if (!std::isfinite(x)) {
    reader.unreadable(node.origin, fmt::format("{} must be finite, not {}", in_quotes(info.name), x));
    return false;
  }
  if (info.range.divides() && x > 0.0 && x < smallest_divisor) {
    reader.unreadable(node.origin, fmt::format("{} must not be so near 0: {} is smaller than {}",
                                               in_quotes(info.name), describe(node), smallest_divisor));
    return false;
  }
  if (!info.range.contains(x))
    reader.bad_value(node.origin, fmt::format("{} must be {}, not {}", in_quotes(info.name),
                                              range_words(info.range, info.unit), describe(node)));
  return true;
}

void check_choice(const std::string& word, const Node& node, const KeyInfo& info, Reader& reader) {
  if (info.choices.empty() || std::ranges::find(info.choices, word) != info.choices.end()) return;
  std::string list;
  for (const std::string_view choice : info.choices)
    list += fmt::format("{}\"{}\"",
                        list.empty()                    ? ""
                        : choice == info.choices.back() ? " or "
                                                        : ", ",
                        choice);
  reader.bad_value(node.origin,
                   fmt::format("{} must be {}, not {}", in_quotes(info.name), list, in_quotes(word)),
                   did_you_mean(nearest_name(word, info.choices)));
}

// A limit for people: 1e12 in place of 1000000000000.
std::string short_number(double x) {
  std::string text = fmt::format("{}", x);
  if (std::abs(x) < 1e5) return text;
  text = fmt::format("{:.15g}", x);
  const std::string power = fmt::format("{:e}", x);
  const std::size_t e = power.find('e');
  std::string digits = power.substr(0, e);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.ends_with('.')) digits.pop_back();
  const std::string exponential = fmt::format("{}e{}", digits, std::stoi(power.substr(e + 1)));
  return std::stod(exponential) == x ? exponential : text;
}

// A colour as in web pages: #rrggbb.
bool read_web_colour(const std::string& text, Colour& out) {
  const auto is_hex = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  };
  if (text.size() != 7 || text[0] != '#' || !std::all_of(text.begin() + 1, text.end(), is_hex)) return false;
  for (std::size_t i = 0; i < 3; ++i) out[i] = std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
  return true;
}

}  // namespace

std::string range_words(const Range& range, std::string_view unit) {
  const std::string suffix = unit.empty() ? "" : fmt::format(" {}", unit);
  const std::string min = short_number(range.min), max = short_number(range.max);
  const bool low = range.min > -unbounded, high = range.max < unbounded;
  if (low && high && !range.min_excluded) return fmt::format("between {} and {}{}", min, max, suffix);
  if (low && high) return fmt::format("above {} and at most {}{}", min, max, suffix);
  if (low) return fmt::format("{} {}{}", range.min_excluded ? "above" : "at least", min, suffix);
  return high ? fmt::format("at most {}{}", max, suffix) : std::string();
}

std::string range_signs(const Range& range) {
  const std::string min = short_number(range.min), max = short_number(range.max);
  const bool low = range.min > -unbounded, high = range.max < unbounded;
  if (low && high && !range.min_excluded) return fmt::format("{} … {}", min, max);
  std::string out = low ? fmt::format("{} {}", range.min_excluded ? ">" : "≥", min) : "";
  if (high) out += fmt::format("{}≤ {}", low ? ", " : "", max);
  return out;
}

std::string in_unit(const KeyInfo& info) {
  return info.unit.empty() ? std::string() : " in " + info.unit;
}

std::string toml_number(double x) {
  std::string text = fmt::format("{}", x);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (code < 0x20 || code == 0x7F) {
      out += fmt::format("\\u{:04X}", code);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

bool Codec<double>::read(const Node& node, const KeyInfo& info, double& out, Reader& reader) {
  double number = 0.0;
  if (!is_number(node, number)) return wrong_type(node, info, type(), reader);
  if (!accept(number, node, info, reader)) return false;
  out = number;
  return true;
}

bool Codec<int>::read(const Node& node, const KeyInfo& info, int& out, Reader& reader) {
  double number = 0.0;
  if (!is_number(node, number)) return wrong_type(node, info, type(), reader);
  if (std::isfinite(number) && number != std::floor(number)) return wrong_type(node, info, type(), reader);
  if (!accept(number, node, info, reader)) return false;
  if (std::abs(number) > std::numeric_limits<int>::max()) {
    if (info.range.contains(number)) return wrong_type(node, info, "a smaller whole number", reader);
    return false;  // out of range, and said so
  }
  out = static_cast<int>(number);
  return true;
}

bool Codec<bool>::read(const Node& node, const KeyInfo& info, bool& out, Reader& reader) {
  const auto* truth = node.get<bool>();
  if (!truth) return wrong_type(node, info, type(), reader);
  out = *truth;
  return true;
}

bool Codec<std::string>::read(const Node& node, const KeyInfo& info, std::string& out, Reader& reader) {
  const auto* text = node.get<std::string>();
  if (!text) return wrong_type(node, info, type(), reader);
  check_choice(*text, node, info, reader);
  out = *text;
  return true;
}

bool Codec<std::vector<std::string>>::read(const Node& node, const KeyInfo& info,
                                           std::vector<std::string>& out, Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list) return wrong_type(node, info, type(), reader);
  std::vector<std::string> texts;
  for (const Node& element : *list)
    if (!Codec<std::string>::read(element, info, texts.emplace_back(), reader)) return false;
  out = std::move(texts);
  return true;
}

std::string Codec<std::vector<std::string>>::write(const std::vector<std::string>& value) {
  return write_list(value, toml_string);
}

bool read_numbers(const Node& node, const KeyInfo& info, std::string_view type, std::span<double> out,
                  Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list || list->size() != out.size()) return wrong_type(node, info, type, reader);
  for (std::size_t i = 0; i < out.size(); ++i) {
    double number = 0.0;
    if (!is_number((*list)[i], number)) return wrong_type((*list)[i], info, type, reader);
    if (!accept(number, (*list)[i], info, reader)) return false;
    out[i] = number;
  }
  return true;
}

std::string write_numbers(std::span<const double> numbers) {
  return write_list(numbers, toml_number);
}

bool Codec<Vec3>::read(const Node& node, const KeyInfo& info, Vec3& out, Reader& reader) {
  return read_numbers(node, info, type(), {out.data(), 3}, reader);
}

std::string Codec<Vec3>::write(const Vec3& value) {
  return write_numbers({value.data(), 3});
}

bool Codec<std::array<double, 2>>::read(const Node& node, const KeyInfo& info, std::array<double, 2>& out,
                                        Reader& reader) {
  return read_numbers(node, info, type(), out, reader);
}

bool Codec<Colour>::read(const Node& node, const KeyInfo& info, Colour& out, Reader& reader) {
  const auto* text = node.get<std::string>();
  if (!text) return read_numbers(node, info, type(), out, reader);
  if (read_web_colour(*text, out)) return true;
  if (const std::optional<Colour> named = colour_named(*text)) {
    out = *named;
    return true;
  }
  reader.bad_value(
      node.origin,
      text->starts_with('#')
          ? fmt::format("{} must have six digits from 0 to f after #, as \"#cc8c33\" has, not {}",
                        in_quotes(info.name), in_quotes(*text))
          : fmt::format("{} names no colour: {}; there are {}, \"#rrggbb\" and [red, green, blue]",
                        in_quotes(info.name), in_quotes(*text), fmt::join(colour_names(), ", ")),
      did_you_mean(nearest_name(*text, colour_names())));
  return false;
}

bool Codec<std::vector<Knot>>::read(const Node& node, const KeyInfo& info, std::vector<Knot>& out,
                                    Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list) return wrong_type(node, info, type(), reader);
  std::vector<Knot> knots;
  for (const Node& element : *list) {
    std::array<double, 4> numbers{};
    if (!read_numbers(element, info, type(), numbers, reader)) return false;
    knots.push_back({numbers[0], Vec3(numbers[1], numbers[2], numbers[3])});
  }
  out = std::move(knots);
  return true;
}

std::string Codec<std::vector<Knot>>::write(const std::vector<Knot>& value) {
  return write_list(value, [](const Knot& knot) {
    return write_numbers(std::array{knot.time, knot.position.x(), knot.position.y(), knot.position.z()});
  });
}

bool Codec<std::vector<Vec3>>::read(const Node& node, const KeyInfo& info, std::vector<Vec3>& out,
                                    Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list) return wrong_type(node, info, type(), reader);
  std::vector<Vec3> places;
  for (const Node& element : *list)
    if (!read_numbers(element, info, type(), {places.emplace_back().data(), 3}, reader)) return false;
  out = std::move(places);
  return true;
}

bool Codec<std::vector<int>>::read(const Node& node, const KeyInfo& info, std::vector<int>& out,
                                   Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list) return wrong_type(node, info, type(), reader);
  std::vector<int> numbers;
  for (const Node& element : *list)
    if (!Codec<int>::read(element, info, numbers.emplace_back(), reader)) return false;
  out = std::move(numbers);
  return true;
}

std::string Codec<std::vector<int>>::write(const std::vector<int>& value) {
  return write_list(value, [](int number) { return Codec<int>::write(number); });
}

std::string Codec<std::vector<Vec3>>::write(const std::vector<Vec3>& value) {
  return write_list(value, [](const Vec3& place) { return Codec<Vec3>::write(place); });
}

bool Codec<std::vector<std::array<double, 2>>>::read(const Node& node, const KeyInfo& info,
                                                     std::vector<std::array<double, 2>>& out,
                                                     Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list) return wrong_type(node, info, type(), reader);
  std::vector<std::array<double, 2>> pairs;
  for (const Node& element : *list)
    if (!read_numbers(element, info, type(), pairs.emplace_back(), reader)) return false;
  out = std::move(pairs);
  return true;
}

std::string Codec<std::vector<std::array<double, 2>>>::write(
    const std::vector<std::array<double, 2>>& value) {
  return write_list(value, [](const std::array<double, 2>& pair) { return write_numbers(pair); });
}

bool Codec<std::array<Vec3, 2>>::read(const Node& node, const KeyInfo& info, std::array<Vec3, 2>& out,
                                      Reader& reader) {
  const auto* list = node.get<Node::List>();
  if (!list || list->size() != 2) return wrong_type(node, info, type(), reader);
  return read_numbers((*list)[0], info, type(), {out[0].data(), 3}, reader) &&
         read_numbers((*list)[1], info, type(), {out[1].data(), 3}, reader);
}

std::string Codec<std::array<Vec3, 2>>::write(const std::array<Vec3, 2>& value) {
  return write_list(value, [](const Vec3& corner) { return Codec<Vec3>::write(corner); });
}

}  // namespace taut
