// What happens to a run at times that its model names: links break, and pins let go.

#include <algorithm>
#include <iterator>
#include <utility>

#include "energy_guard.h"
#include "methods/breaking.h"
#include "model/measures.h"
#include "motion/run.h"
#include "stops.h"

namespace taut {

void Run::change(const Change& change) {
  std::vector<Index> whole;
  std::ranges::copy_if(change.links, std::back_inserter(whole),
                       [&](Index link) { return !state().broken(link); });
  const std::vector<Index> pins = change.pins;  // the model is about to be another one
  break_links(whole, report_.counts);
  if (!pins.empty()) release(pins);
}

// The model with masses that their pins have let go of.
void Run::let_go_of(const std::vector<Index>& pins) {
  auto next = std::make_unique<Model>(*model_);
  for (const Index pin : pins) next->masses.inverse_mass[pin] = 1.0 / next->masses.mass[pin];
  std::erase_if(next->driven_pins,
                [&](const DrivenPin& driven) { return next->masses.inverse_mass[driven.mass] != 0.0; });
  released_ = std::move(next);
  model_ = released_.get();
}

// From now on another model is stepped. What the masses have that are free now, of energy that counts, was
// given to the scene by their pins.
void Run::release(const std::vector<Index>& pins) {
  if (ledger_.keeps_anything()) ledger_.record(state());
  State now = state();
  break_at_once(*model_, now, {});
  const double before = energy(*model_, now).total();
  Work work = ledger_.work();
  left_behind_ = std::move(stepper_);
  left_model_ = std::move(released_);
  left_at_ = now.time;
  let_go_of(pins);
  work.pins += energy(*model_, now).total() - before;
  stepper_ = method_.make(*model_, settings_, execution_);
  stepper_->load(now);
  ledger_ = WorkLedger(*model_, now, work);
  stepper_->watch(ledger_.watched());
  if (guard_) guard_->go_on_with(*model_);
  if (cuts_at_stops_) touched_ = touched_stops(*model_, now);
}

}  // namespace taut
