// Plain numbers, coordinate by coordinate: packed into vectors of three the loops take a seventh longer. Each
// loop is made once for every set of things that a scene may lack; what is left out would multiply by one, or
// add a zero, so the results are the same, bit for bit.

#include "relax/relaxation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/parts.h"
#include "relax/link_order.h"

namespace taut {
namespace {

// 1/m of every free mass; −1 where they differ or there is none.
double common_weight(const Model& model) {
  if (!equal_masses(model)) return -1.0;
  for (const double weight : model.masses.inverse_mass)
    if (weight > 0.0) return weight;
  return -1.0;
}

}  // namespace

template <class Real>
Relaxation<Real>::Relaxation(const Model& model, Visits visits)
    : model_(model),
      visits_(visits),
      equal_weight_(static_cast<Real>(common_weight(model))),
      equal_inverse_weight_(Real(0.5) / equal_weight_) {}

template <class Real>
void Relaxation<Real>::links_changed(const State& state) {
  const OrderedLinks order = coloured_order(model_, state);
  flat_ = stays_in_plane(model_, state);
  plain_.clear();
  weighted_.clear();
  colours_.clear();
  std::vector<Index> plain, weighted;
  std::size_t next = 0;
  for (const std::size_t end : order.colour_ends) {
    for (; next < end; ++next) {
      const Index link = order.links[next];
      if (visits_ == Visits::rigid && !model_.links.rigid(link)) continue;
      const Index a = model_.links.a[link], b = model_.links.b[link];
      const auto length = static_cast<Real>(model_.links.length[link]);
      const auto weight_a = static_cast<Real>(model_.masses.inverse_mass[a]),
                 weight_b = static_cast<Real>(model_.masses.inverse_mass[b]);
      if (weight_a == equal_weight_ && weight_b == equal_weight_) {
        plain_.push_back({a, b, length});
        plain.push_back(link);
      } else {
        weighted_.push_back({a, b, length, weight_a, weight_b, Real(1) / (weight_a + weight_b)});
        weighted.push_back(link);
      }
    }
    colours_.push_back({plain_.size(), weighted_.size()});
  }
  links_ = std::move(plain);
  links_.insert(links_.end(), weighted.begin(), weighted.end());
  softness_.clear();
  compliant_ = damped_ = false;
  for (const Index link : links_) {
    softness_.push_back(
        {static_cast<Real>(model_.links.compliance(link)), static_cast<Real>(model_.links.damping[link])});
    compliant_ = compliant_ || !model_.links.rigid(link);
    damped_ = damped_ || model_.links.damping[link] > 0.0;
  }
  begin_step();
}

// Calls visit(links, begin, end, first) for each stretch of links of one kind and colour; their multipliers
// begin at `first`.
template <class Real>
template <class Visit>
void Relaxation<Real>::for_each_stretch(const Visit& visit) {
  Colour begin{0, 0};
  for (const Colour& end : colours_) {
    visit(plain_, begin.plain_end, end.plain_end, std::size_t{0});
    visit(weighted_, begin.weighted_end, end.weighted_end, plain_.size());
    begin = end;
  }
}

template <class Real>
void Relaxation<Real>::pass(Real h, Real answer, const Coordinates<const Real>& start,
                            const Coordinates<Real>& position) {
  if (damped_)
    flat_ ? pass_of<true, true, true>(h, answer, start, position)
          : pass_of<true, true, false>(h, answer, start, position);
  else if (compliant_)
    flat_ ? pass_of<true, false, true>(h, answer, start, position)
          : pass_of<true, false, false>(h, answer, start, position);
  else
    flat_ ? pass_of<false, false, true>(h, answer, start, position)
          : pass_of<false, false, false>(h, answer, start, position);
}

template <class Real>
template <bool compliant, bool damped, bool flat>
void Relaxation<Real>::pass_of(Real h, Real answer, [[maybe_unused]] const Coordinates<const Real>& start,
                               const Coordinates<Real>& position) {
  [[maybe_unused]] const Real inverse_h = Real(1) / h;
  const Real inverse_answer = Real(1) / answer;
  Real *const x = position.x, *const y = position.y, *const z = position.z;
  for_each_stretch([&](const auto& links, std::size_t begin, std::size_t end, std::size_t first) {
    Real* const multipliers = multipliers_.data() + first;
    for (std::size_t i = begin; i < end; ++i) {
      const auto& link = links[i];
      const Index a = link.a, b = link.b;
      const Real dx = x[a] - x[b], dy = y[a] - y[b];
      Real dz = 0;
      Real square = dx * dx + dy * dy;
      if constexpr (!flat) {
        dz = z[a] - z[b];
        square += dz * dz;
      }
      const Real distance = std::sqrt(square);
      if (distance == Real(0)) continue;  // no direction to move in
      const Real inverse_distance = Real(1) / distance;
      Real change = link.length - distance;
      if constexpr (compliant) {
        const Softness& soft = softness_[first + i];
        const Real scaled = soft.compliance * inverse_h * inverse_h;
        const Real weight = answer * (weight_a(link) + weight_b(link));
        change -= scaled * multipliers[i];
        if constexpr (damped) {
          const Real gamma = soft.compliance * soft.damping * inverse_h;
          const Real moved = (dx - (start.x[a] - start.x[b])) * dx + (dy - (start.y[a] - start.y[b])) * dy +
                             (dz - (start.z[a] - start.z[b])) * dz;
          change -= gamma * inverse_distance * moved;
          change /= weight * (Real(1) + gamma) + scaled;
        } else {
          change /= weight + scaled;
        }
      } else {
        change *= inverse_weight(link) * inverse_answer;
      }
      multipliers[i] += change;
      const Real shift = answer * change * inverse_distance;
      const Real on_a = weight_a(link) * shift, on_b = weight_b(link) * shift;
      x[a] += on_a * dx;
      y[a] += on_a * dy;
      x[b] -= on_b * dx;
      y[b] -= on_b * dy;
      if constexpr (!flat) {
        z[a] += on_a * dz;
        z[b] -= on_b * dz;
      }
    }
  });
}

template <class Real>
AlongStart Relaxation<Real>::pass_along(const Coordinates<const Real>& direction,
                                        const Coordinates<Real>& position) {
  AlongStart found;
  Real *const x = position.x, *const y = position.y, *const z = position.z;
  for_each_stretch([&](const auto& links, std::size_t begin, std::size_t end, std::size_t first) {
    for (std::size_t i = begin; i < end && !found.lost; ++i) {
      const auto& link = links[i];
      const Index a = link.a, b = link.b;
      const Real squared = link.length * link.length;
      const Real ux = direction.x[first + i], uy = direction.y[first + i], uz = direction.z[first + i];
      const Real dx = x[a] - x[b], dy = y[a] - y[b], dz = z[a] - z[b];
      const Real along = dx * ux + dy * uy + dz * uz;
      if (!(along > Real(0))) {
        found.lost = true;
        found.lost_link = links_[first + i];
        found.lost_along = static_cast<double>(along);
        return;
      }
      const Real excess = dx * dx + dy * dy + dz * dz - squared;
      found.worst = std::max(found.worst, static_cast<double>(std::abs(excess) / squared));
      const Real q = excess * inverse_weight(link) / (Real(2) * along);
      multipliers_[first + i] += q;
      const Real on_a = weight_a(link) * q, on_b = weight_b(link) * q;
      x[a] -= on_a * ux;
      y[a] -= on_a * uy;
      z[a] -= on_a * uz;
      x[b] += on_b * ux;
      y[b] += on_b * uy;
      z[b] += on_b * uz;
    }
  });
  return found;
}

template class Relaxation<double>;
template class Relaxation<float>;

}  // namespace taut
