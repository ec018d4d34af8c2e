#include <charconv>

#include "measure/planner.h"

namespace taut {
namespace {

struct Unit {
  std::string_view name;
  double factor;
  bool metres;
};
// The longer names first: "mm" ends in "m", too.
constexpr std::array units{Unit{"mm", 1e-3, true}, Unit{"cm", 1e-2, true}, Unit{"m", 1.0, true},
                           Unit{"%", 1e-2, false}};

std::optional<ErrorKind> kind_named(std::string_view name) {
  for (const ErrorKind kind : all_error_kinds)
    if (name_of(kind) == name) return kind;
  return std::nullopt;
}

}  // namespace

std::optional<AccuracyTarget> parse_accuracy(std::string_view text) {
  AccuracyTarget target;
  if (const std::size_t equals = text.find('='); equals != std::string_view::npos) {
    const auto kind = kind_named(text.substr(0, equals));
    if (!kind) return std::nullopt;
    target.kind = *kind;
    text.remove_prefix(equals + 1);
  }
  double factor = 1.0;
  for (const Unit& unit : units)
    if (text.ends_with(unit.name)) {
      factor = unit.factor;
      target.metres = unit.metres;
      text.remove_suffix(unit.name.size());
      break;
    }
  const bool a_length = target.kind == ErrorKind::trajectory || target.kind == ErrorKind::sag;
  if (target.metres && !a_length) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), target.error);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  target.error *= factor;
  if (!(target.error > 0.0 && target.error < infinity)) return std::nullopt;
  return target;
}

}  // namespace taut
