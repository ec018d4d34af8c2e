#include "stages.h"

#include <fmt/format.h>

namespace taut {

nlohmann::ordered_json stages_to_json(const StageSeconds& stages) {
  nlohmann::ordered_json json;
  for (const StageTime& stage : stages) json[std::string(stage.name)] = stage.seconds;
  return json;
}

std::string stages_text(const StageSeconds& stages, std::size_t frames) {
  std::string text = "milliseconds of a processor a frame:";
  double sum = 0.0;
  for (const StageTime& stage : stages) {
    const double milliseconds = 1000.0 * stage.seconds / static_cast<double>(frames);
    sum += milliseconds;
    if (milliseconds >= 0.05) text += fmt::format(" {} {:.1f}", stage.name, milliseconds);
  }
  return text + fmt::format(", all {:.1f}", sum);
}

}  // namespace taut
