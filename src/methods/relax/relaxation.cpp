#include "relax/relaxation.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

#include "model/parts.h"
#include "relax/visit_order.h"
#include "relax/visit_parts.h"

namespace taut {
namespace {

// 1/m of every free mass; −1 where they differ or there is none.
double common_weight(const Model& model) {
  if (!equal_masses(model)) return -1.0;
  for (const double weight : model.masses.inverse_mass)
    if (weight > 0.0) return weight;
  return -1.0;
}

// Fewer are done before it matters how their masses lie.
constexpr std::size_t fewest_to_split = 256;

}  // namespace

template <class Real>
Relaxation<Real>::Relaxation(const Model& model, const Execution& execution, Visits visits)
    : workers_(execution.workers), model_(model), visits_(visits), equal_weight_(common_weight(model)) {}

template <class Real>
void Relaxation<Real>::links_changed(const State& state) {
  if (listed_.empty()) list_links();
  links_.clear();
  for (const Index link : solvable_links(model_))
    if (!state.broken(link) && (visits_ == Visits::all || model_.links.rigid(link))) links_.push_back(link);
  lay_out(state);
  slot_.assign(model_.links.size(), 0);
  for (std::size_t slot = 0; slot < lay_.visited.size(); ++slot)
    if (lay_.visited[slot] != no_link) slot_[lay_.visited[slot]] = static_cast<std::uint32_t>(slot);
  arrays_ = {};
  arrays_.multiplier.assign(lay_.visited.size(), Real(0));
  for (auto* values : {&arrays_.factor, &arrays_.share_a, &arrays_.share_b, &arrays_.scaled, &arrays_.gamma})
    values->assign(lay_.special.size(), Real(0));
  settled_h_ = settled_answer_ = 0;
}

// From the model alone, so that a run that goes on from a state with broken links visits them alike.
template <class Real>
void Relaxation<Real>::list_links() {
  for (const Index link : solvable_links(model_))
    if (visits_ == Visits::all || model_.links.rigid(link)) listed_.push_back(link);
  if (listed_.size() >= fewest_to_split) listed_ = listed_as_in_sheets(model_, std::move(listed_));
}

// How masses lie matters to the time alone: breaks need not change it.
template <class Real>
void Relaxation<Real>::lay_out(const State& state) {
  std::vector<Index> links;
  std::ranges::copy_if(listed_, std::back_inserter(links), [&](Index link) { return !state.broken(link); });
  const auto try_out = [&](Layout layout, std::vector<Index> masses) {
    lay_ = lay_out_links<Real>(model_, visit_order(model_, links, std::move(masses)), layout, equal_weight_,
                               threads_for(workers_.get(), links.size()));
  };
  if (!lay_.masses.empty()) return try_out(lay_.layout, std::move(lay_.masses));
  if (links.size() >= fewest_to_split && follow_each_other(model_, links)) {
    try_out(Layout::split, row_order(model_, links, links_at_once<Real>));
    if (4 * lay_.adjoining >= 3 * links.size()) return;
  }
  try_out(Layout::packed, mass_order(model_, links));
}

// What the formulas have of h, drag, weights and softness together.
template <class Real>
void Relaxation<Real>::begin_step(Real h, Real answer) {
  if (h == settled_h_ && answer == settled_answer_) return;
  settled_h_ = h;
  settled_answer_ = answer;
  for (std::size_t i = 0; i < lay_.special.size(); ++i) {
    if (lay_.special[i] == no_link) continue;
    const Index link = lay_.special[i];
    const double step = static_cast<double>(h), moves = static_cast<double>(answer);
    const double move_a = moves * model_.masses.inverse_mass[model_.links.a[link]],
                 move_b = moves * model_.masses.inverse_mass[model_.links.b[link]];
    const double compliance = model_.links.compliance(link), damping = model_.links.damping[link];
    const double scaled = compliance / (step * step), gamma = compliance * damping / step;
    const double factor = 1.0 / ((1.0 + gamma) * (move_a + move_b) + scaled);
    arrays_.factor[i] = static_cast<Real>(factor);
    arrays_.share_a[i] = static_cast<Real>(move_a * factor);
    arrays_.share_b[i] = static_cast<Real>(move_b * factor);
    arrays_.scaled[i] = static_cast<Real>(scaled);
    arrays_.gamma[i] = static_cast<Real>(gamma);
  }
}

template <class Real>
LinkArrays<Real> Relaxation<Real>::arrays() {
  const double move = static_cast<double>(settled_answer_) * equal_weight_;
  return {lay_.a.data(),
          lay_.b.data(),
          lay_.length.data(),
          arrays_.multiplier.data(),
          static_cast<Real>(0.5 / move),
          arrays_.factor.data(),
          arrays_.share_a.data(),
          arrays_.share_b.data(),
          arrays_.scaled.data(),
          arrays_.gamma.data()};
}

template <class Real>
std::span<const LinkStretch> Relaxation<Real>::stretches_of(const LinkSection& section) const {
  return std::span(lay_.stretches).subspan(section.begin, section.end - section.begin);
}

template <class Real>
bool Relaxation<Real>::pass(const Masses& start, Masses& position, PassPlace place,
                            const FreeMotion<Real>* motion) {
  const LinkArrays<Real> links = arrays();
  const auto visit = [&](std::size_t i, const FreeMotion<Real>* moving) {
    return relax_along_present<Real>(lay_.layout, links, stretches_of(lay_.sections[i]), start.read(), moving,
                                     lay_.sections[i].masses, place, position.view());
  };
  if (lay_.sections.size() == 1) return visit(0, motion);
  std::atomic<bool> finite{true};
  workers_->run([&](int part) {
    if (!visit(static_cast<std::size_t>(part), motion)) finite.store(false);
  });
  visit(lay_.sections.size() - 1, nullptr);
  return finite.load() && (!place.last || unsettled_are_finite(position));
}

template <class Real>
bool Relaxation<Real>::unsettled_are_finite(const Masses& position) const {
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 1 < lay_.sections.size(); ++i) {
    if (!are_finite(lay_.layout, position.read(), begin, lay_.sections[i].masses.settled_begin)) return false;
    begin = lay_.sections[i].masses.settled_end;
  }
  return are_finite(lay_.layout, position.read(), begin, lay_.masses.size());
}

template <class Real>
void Relaxation<Real>::give_multipliers(double scale, std::vector<double>& values) const {
  for (std::size_t slot = 0; slot < lay_.visited.size(); ++slot)
    if (lay_.visited[slot] != no_link)
      values[lay_.visited[slot]] = static_cast<double>(arrays_.multiplier[slot]) * scale;
}

template <class Real>
void Relaxation<Real>::give_multipliers_along(double scale, std::vector<double>& values) const {
  for (std::size_t slot = 0; slot < lay_.visited.size(); ++slot)
    if (lay_.visited[slot] != no_link)
      values[lay_.visited[slot]] = static_cast<double>(arrays_.multiplier[slot] * lay_.length[slot]) * scale;
}

template class Relaxation<double>;
template class Relaxation<float>;

}  // namespace taut
