#include "motion/run_report.h"

#include <fmt/format.h>

namespace taut {

std::string halving_sentence(const Model& model, const RunReport& report) {
  if (report.halved_steps == 0) return {};
  std::string where;
  if (report.halved_at_link != no_link)
    where = ", at last at the link " + link_name(model, report.halved_at_link);
  return fmt::format(
      "{} of {} steps could only be made in parts, down to 1/{} of a step, from t = {:.4g} s to {:.4g} s{}",
      report.halved_steps, report.steps, 1 << report.deepest_halving, report.first_halved_at,
      report.last_halved_at, where);
}

}  // namespace taut
