#include "measure/plan.h"

#include <fmt/format.h>

#include <array>
#include <charconv>

#include "base/digits.h"
#include "methods/registry.h"
#include "model/measures.h"

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

double wanted_error(const AccuracyTarget& target, const Model& model, const State& start) {
  return target.metres ? target.error / scene_size(model, start) : target.error;
}

std::string settings_text(const Settings& settings) {
  std::string text = fmt::format("{} {}", settings.method, pace_text(settings));
  const Settings usual = complete_settings({settings.method, {}});
  for (const auto& [name, value] : settings.values) {
    if (name == "passes") {
      const double passes = std::get<double>(value);
      text += fmt::format(", {} {}", passes, passes == 1.0 ? "pass" : "passes");
    }
    const auto* word = std::get_if<std::string>(&value);
    if (word != nullptr && *word != usual.choice(name)) text += fmt::format(", {} {}", name, *word);
  }
  return text;
}

bool reaches_the_end(double until, double duration) {
  return until >= duration - std::min(1.0 / 60.0, 0.02 * duration);
}

std::string accuracy_sentence(const Plan& plan) {
  if (!plan.estimated_error) return "how far off it will be can't be judged: no two runs agree on the motion";
  const bool place = plan.kind == ErrorKind::trajectory || plan.kind == ErrorKind::sag;
  const std::string error =
      place ? fmt::format("{} of the size, {:.2g} m of {:.3g} m across", percent(*plan.estimated_error),
                          *plan.estimated_error * plan.size, plan.size)
            : fmt::format("{:.2g}", *plan.estimated_error);
  const std::string wanted = place ? percent(plan.wanted) : fmt::format("{:.2g}", plan.wanted);
  const std::string span =
      plan.judged_to_the_end()
          ? fmt::format("over all of its {:.3g} s", plan.duration)
          : fmt::format("over the first {:.3g} s of {:.3g} s ({:.0f} %); beyond that nothing is promised",
                        plan.judged_until, plan.duration, 100.0 * plan.judged_share());
  return fmt::format("{} error estimated at {} ({} wanted), {}", name_of(plan.kind), error, wanted, span);
}

}  // namespace taut
