#include "relax/relaxation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
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

// Below that, waiting for each other takes longer than the work.
constexpr std::size_t fewest_to_share = 4000;

}  // namespace

template <class Real>
Relaxation<Real>::Relaxation(const Model& model, const Execution& execution, Visits visits)
    : MassPlaces<Real>(model),
      workers_(execution.workers),
      visits_(visits),
      equal_weight_(common_weight(model)) {}

template <class Real>
void Relaxation<Real>::links_changed(const State& state) {
  links_.clear();
  for (const Index link : solvable_links(model_))
    if (!state.broken(link) && (visits_ == Visits::all || model_.links.rigid(link))) links_.push_back(link);
  this->give_places(links_);
  const VisitOrder order = visit_order(model_, links_, masses_);
  visited_.clear();
  special_.clear();
  stretches_.clear();
  arrays_ = {};
  sections_.clear();
  const bool shared = workers_ && links_.size() >= fewest_to_share;
  const VisitParts parts = share_out(model_, order, shared ? static_cast<std::size_t>(workers_->count()) : 1);
  for (const VisitParts::Part& part : parts.parts)
    add_section(part.runs, {part.begin, part.end, part.settled_begin, part.settled_end});
  if (parts.parts.size() > 1) add_section(parts.rest, {});
  slot_.assign(model_.links.size(), 0);
  for (std::size_t slot = 0; slot < visited_.size(); ++slot)
    if (visited_[slot] != no_link) slot_[visited_[slot]] = static_cast<std::uint32_t>(slot);
  arrays_.multiplier.assign(visited_.size(), Real(0));
  multiplier_before_ = arrays_.multiplier;
  for (auto* values : {&arrays_.factor, &arrays_.share_a, &arrays_.share_b, &arrays_.scaled, &arrays_.gamma})
    values->assign(special_.size(), Real(0));
  settled_h_ = settled_answer_ = 0;
}

// Apart by what they lack, so that each kind pays for no more than it has.
template <class Real>
void Relaxation<Real>::add_run(const std::vector<Index>& run) {
  std::array<std::vector<Index>, 6> kinds;
  const auto kind_of = [&](Index link) {
    const Links& links = model_.links;
    const bool weighted = model_.masses.inverse_mass[links.a[link]] != equal_weight_ ||
                          model_.masses.inverse_mass[links.b[link]] != equal_weight_;
    const std::size_t softness = links.rigid(link) ? 0 : links.damping[link] > 0.0 ? 2 : 1;
    return 2 * softness + (weighted ? 1 : 0);
  };
  for (const Index link : run) kinds[kind_of(link)].push_back(link);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind)
    if (!kinds[kind].empty()) {
      LinkStretch stretch;
      stretch.weighted = kind % 2 != 0;
      stretch.soft = kind >= 2;
      stretch.damped = kind >= 4;
      if (!stretch.weighted) add_strided(kinds[kind], stretch);
      if (!kinds[kind].empty()) add_stretch(kinds[kind], stretch);
    }
}

// The distance in bytes at which the ends of so many links as a kernel takes at once follow each other; 0
// where they don't.
template <class Real>
std::size_t Relaxation<Real>::stride_of(const Index* links) const {
  const auto a = [&](std::size_t i) { return std::ptrdiff_t{place_[model_.links.a[links[i]]]}; };
  const auto b = [&](std::size_t i) { return std::ptrdiff_t{place_[model_.links.b[links[i]]]}; };
  const std::ptrdiff_t stride = a(1) - a(0);
  if (stride <= 0) return 0;
  for (std::size_t i = 1; i < links_at_once<Real>; ++i)
    if (a(i) - a(i - 1) != stride || b(i) - b(i - 1) != stride) return 0;
  return static_cast<std::size_t>(stride) * sizeof(Packed<Real>);
}

// Takes out of some links between free masses those that lie at equal distances, as in rows of sheets and in
// chains, and makes stretches of them.
template <class Real>
void Relaxation<Real>::add_strided(std::vector<Index>& links, const LinkStretch& kind) {
  constexpr std::size_t fewest = 4 * links_at_once<Real>;
  std::map<std::size_t, std::vector<Index>> by_stride;
  for (std::size_t i = 0; i < links.size();) {
    const std::size_t stride = i + links_at_once<Real> <= links.size() ? stride_of(&links[i]) : 0;
    const std::size_t count = stride == 0 ? 1 : links_at_once<Real>;
    by_stride[stride].insert(by_stride[stride].end(), &links[i], &links[i] + count);
    i += count;
  }
  links = std::move(by_stride[0]);
  for (const auto& [stride, strided] : by_stride) {
    if (stride == 0) continue;
    if (strided.size() < fewest) {
      links.insert(links.end(), strided.begin(), strided.end());
      continue;
    }
    LinkStretch stretch = kind;
    stretch.stride = stride;
    add_stretch(strided, stretch);
  }
}

template <class Real>
void Relaxation<Real>::add_stretch(const std::vector<Index>& links, LinkStretch stretch) {
  stretch.begin = visited_.size();
  stretch.special = special_.size();
  stretch.ends = arrays_.a.size();
  const auto add_ends = [&](std::size_t a, std::size_t b) {
    arrays_.a.push_back(place_offset<Real>(a));
    arrays_.b.push_back(place_offset<Real>(b));
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (stretch.stride == 0 || i % links_at_once<Real> == 0)
      add_ends(this->place_of(model_.links.a[links[i]]), this->place_of(model_.links.b[links[i]]));
    add_slot(links[i], model_.links.length[links[i]], stretch);
  }
  if (visited_.size() % links_at_once<Real> != 0) {
    // Filled up with links between two masses of the stretch's own that are one metre apart and stay so.
    const std::size_t place = room_.size();
    room_.resize(place + 2);
    room_.back().x = Real(1);
    while (visited_.size() % links_at_once<Real> != 0) {
      add_ends(place, place + 1);
      add_slot(no_link, 1.0, stretch);
    }
  }
  stretch.end = visited_.size();
  stretches_.push_back(stretch);
}

template <class Real>
void Relaxation<Real>::add_slot(Index link, double length, const LinkStretch& stretch) {
  arrays_.length.push_back(static_cast<Real>(length));
  visited_.push_back(link);
  if (stretch.weighted || stretch.soft) special_.push_back(link);
}

template <class Real>
void Relaxation<Real>::add_section(const std::vector<std::vector<Index>>& runs, const MassRange& masses) {
  const std::size_t begin = stretches_.size();
  for (const std::vector<Index>& run : runs) add_run(run);
  sections_.push_back({begin, stretches_.size(), masses});
  find_reach(sections_.back());
}

// What each stretch of a section, and those before and after it, may touch of the free masses.
template <class Real>
void Relaxation<Real>::find_reach(const Section& section) {
  std::size_t begun = section.masses.begin, done = section.masses.end;
  const auto visit_free = [&](const LinkStretch& stretch, const auto& visit) {
    for (std::size_t slot = stretch.begin; slot < stretch.end; ++slot)
      for (const auto* ends : {arrays_.a.data(), arrays_.b.data()})
        if (const std::size_t place = end_offset<Real>(ends, stretch, slot) / sizeof(Packed<Real>);
            place < masses_.size())
          visit(place);
  };
  for (std::size_t i = section.begin; i < section.end; ++i) {
    visit_free(stretches_[i], [&](std::size_t place) { begun = std::max(begun, place + 1); });
    stretches_[i].begun = begun;
  }
  for (std::size_t i = section.end; i-- > section.begin;) {
    stretches_[i].done = done;
    visit_free(stretches_[i], [&](std::size_t place) { done = std::min(done, place); });
  }
}

// What the formulas have of h, drag, weights and softness together.
template <class Real>
void Relaxation<Real>::settle(Real h, Real answer) {
  if (h == settled_h_ && answer == settled_answer_) return;
  settled_h_ = h;
  settled_answer_ = answer;
  for (std::size_t i = 0; i < special_.size(); ++i) {
    if (special_[i] == no_link) continue;
    const Index link = special_[i];
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
  return {arrays_.a.data(),
          arrays_.b.data(),
          arrays_.length.data(),
          arrays_.multiplier.data(),
          static_cast<Real>(0.5 / move),
          arrays_.factor.data(),
          arrays_.share_a.data(),
          arrays_.share_b.data(),
          arrays_.scaled.data(),
          arrays_.gamma.data()};
}

template <class Real>
void Relaxation<Real>::begin_step(Real h, Real answer) {
  settle(h, answer);
  std::swap(arrays_.multiplier, multiplier_before_);
}

template <class Real>
std::span<const LinkStretch> Relaxation<Real>::stretches_of(const Section& section) const {
  return std::span(stretches_).subspan(section.begin, section.end - section.begin);
}

template <class Real>
bool Relaxation<Real>::pass(const Masses& start, Masses& position, PassPlace place,
                            const FreeMotion<Real>* motion) {
  const LinkArrays<Real> links = arrays();
  const auto visit = [&](std::size_t i, const FreeMotion<Real>* moving) {
    return relax_along_present<Real>(links, stretches_of(sections_[i]), start.data(), moving,
                                     sections_[i].masses, place, position.data());
  };
  if (sections_.size() == 1) return visit(0, motion);
  std::atomic<bool> finite{true};
  workers_->run([&](int part) {
    if (!visit(static_cast<std::size_t>(part), motion)) finite.store(false);
  });
  visit(sections_.size() - 1, nullptr);
  return finite.load() && (!place.last || unsettled_are_finite(position));
}

template <class Real>
bool Relaxation<Real>::unsettled_are_finite(const Masses& position) const {
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 1 < sections_.size(); ++i) {
    if (!are_finite(position.data(), begin, sections_[i].masses.settled_begin)) return false;
    begin = sections_[i].masses.settled_end;
  }
  return are_finite(position.data(), begin, masses_.size());
}

template <class Real>
void Relaxation<Real>::give_multipliers(double scale, std::vector<double>& values) const {
  for (std::size_t slot = 0; slot < visited_.size(); ++slot)
    if (visited_[slot] != no_link)
      values[visited_[slot]] = static_cast<double>(arrays_.multiplier[slot]) * scale;
}

template <class Real>
void Relaxation<Real>::give_multipliers_along(double scale, std::vector<double>& values) const {
  for (std::size_t slot = 0; slot < visited_.size(); ++slot)
    if (visited_[slot] != no_link)
      values[visited_[slot]] = static_cast<double>(arrays_.multiplier[slot] * arrays_.length[slot]) * scale;
}

template class Relaxation<double>;
template class Relaxation<float>;

}  // namespace taut
