#include "relax/mass_places.h"

namespace taut {
namespace {

template <class Real>
Packed<Real> packed(const Vectors& vectors, Index i) {
  // No −0, which stays as it is only as long as nothing is added.
  constexpr Real nothing = 0;
  return {static_cast<Real>(vectors.x[i]) + nothing, static_cast<Real>(vectors.y[i]) + nothing,
          static_cast<Real>(vectors.z[i]) + nothing, nothing};
}

}  // namespace

template <class Real>
void MassPlaces<Real>::give_places(const Model& model, const std::vector<Index>& order) {
  masses = order;
  places = order.size();
  pin_ends.clear();
  fillers.clear();
  place.assign(model.masses.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] != empty_place) place[order[i]] = static_cast<Index>(i);
}

template <class Real>
std::size_t MassPlaces<Real>::place_of(const Model& model, Index mass) {
  if (!model.masses.pinned(mass)) return place[mass];
  pin_ends.push_back({mass, static_cast<Index>(places)});
  return places++;
}

template <class Real>
VectorRoom<Real> MassPlaces<Real>::room() const {
  VectorRoom<Real> room(places, layout);
  for (const std::size_t first : fillers) room.set(first + 1, {Real(1), Real(0), Real(0), Real(0)});
  return room;
}

template <class Real>
void MassPlaces<Real>::load(const Vectors& from, VectorRoom<Real>& to) const {
  for (std::size_t i = 0; i < masses.size(); ++i)
    to.set(i, masses[i] == empty_place ? Packed<Real>() : packed<Real>(from, masses[i]));
  load_pins(from, to);
}

template <class Real>
void MassPlaces<Real>::load_pins(const Vectors& from, VectorRoom<Real>& to) const {
  for (const PinEnd& end : pin_ends) to.set(end.place, packed<Real>(from, end.mass));
}

template <class Real>
void MassPlaces<Real>::give(const VectorRoom<Real>& from, Vectors& to) const {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const Index mass = masses[i];
    if (mass == empty_place) continue;
    const Packed<Real> at = from.at(i);
    to.x[mass] = static_cast<double>(at.x);
    to.y[mass] = static_cast<double>(at.y);
    to.z[mass] = static_cast<double>(at.z);
  }
}

template <class Real>
void MassPlaces<Real>::give_difference(const VectorRoom<Real>& a, const VectorRoom<Real>& b, Real factor,
                                       Vectors& to) const {
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const Index mass = masses[i];
    if (mass == empty_place) continue;
    const Packed<Real> at_a = a.at(i), at_b = b.at(i);
    to.x[mass] = static_cast<double>((at_b.x - at_a.x) * factor);
    to.y[mass] = static_cast<double>((at_b.y - at_a.y) * factor);
    to.z[mass] = static_cast<double>((at_b.z - at_a.z) * factor);
  }
}

template struct MassPlaces<double>;
template struct MassPlaces<float>;

}  // namespace taut
