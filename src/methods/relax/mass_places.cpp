#include "relax/mass_places.h"

#include <cstddef>

#include "relax/visit_order.h"

namespace taut {
namespace {

template <class Real>
Packed<Real> packed(const Vectors& vectors, Index i) {
  return {static_cast<Real>(vectors.x[i]), static_cast<Real>(vectors.y[i]), static_cast<Real>(vectors.z[i]),
          Real(0)};
}

}  // namespace

template <class Real>
void MassPlaces<Real>::give_places(const std::vector<Index>& links) {
  // Where masses lie matters to the caches alone: breaks need not change it.
  if (room_.empty()) masses_ = mass_order(model_, links);
  place_.assign(model_.masses.size(), 0);
  for (std::size_t i = 0; i < masses_.size(); ++i) place_[masses_[i]] = static_cast<Index>(i);
  room_.assign(masses_.size(), {});
  pin_ends_.clear();
}

template <class Real>
Index MassPlaces<Real>::place_of(Index mass) {
  if (!model_.masses.pinned(mass)) return place_[mass];
  const auto place = static_cast<Index>(room_.size());
  room_.push_back({});
  pin_ends_.push_back({mass, place});
  return place;
}

template <class Real>
void MassPlaces<Real>::load(const Vectors& from, Masses& to) const {
  for (std::size_t i = 0; i < masses_.size(); ++i) to[i] = packed<Real>(from, masses_[i]);
  load_pins(from, to);
}

template <class Real>
void MassPlaces<Real>::load_pins(const Vectors& from, Masses& to) const {
  for (const PinEnd& end : pin_ends_) to[end.place] = packed<Real>(from, end.mass);
}

template <class Real>
void MassPlaces<Real>::give(const Masses& from, Vectors& to) const {
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    const Index mass = masses_[i];
    to.x[mass] = static_cast<double>(from[i].x);
    to.y[mass] = static_cast<double>(from[i].y);
    to.z[mass] = static_cast<double>(from[i].z);
  }
}

template <class Real>
void MassPlaces<Real>::give_difference(const Masses& a, const Masses& b, Real factor, Vectors& to) const {
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    const Index mass = masses_[i];
    to.x[mass] = static_cast<double>((b[i].x - a[i].x) * factor);
    to.y[mass] = static_cast<double>((b[i].y - a[i].y) * factor);
    to.z[mass] = static_cast<double>((b[i].z - a[i].z) * factor);
  }
}

template class MassPlaces<double>;
template class MassPlaces<float>;

}  // namespace taut
