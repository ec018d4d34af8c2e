#pragma once

#include <cstddef>
#include <vector>

#include "model/model.h"
#include "relax/vector_room.h"
#include "relax/visit_order.h"

namespace taut {

/// Where the masses of a model lie that a relaxation moves, and how they come there and back.
template <class Real>
struct MassPlaces {
  /// Where a mass lies beside its place among the free ones: a pin's end of one link.
  struct PinEnd {
    Index mass, place;
  };

  Layout layout = Layout::packed;
  std::vector<Index> masses;     ///< the free ones, by place; empty_place where there is none
  std::vector<Index> place;      ///< of each free mass
  std::vector<PinEnd> pin_ends;  ///< a place for each link that ends in a pin: no two write to one
  /// First places of two masses each, one metre apart, between which links lie that fill up a stretch.
  std::vector<std::size_t> fillers;
  std::size_t places = 0;

  /// Gives the free masses their places. There are no others yet.
  void give_places(const Model& model, const std::vector<Index>& order);
  /// A free mass's place, or one that a pin is given for this link alone.
  std::size_t place_of(const Model& model, Index mass);

  /// Room for a vector at each place.
  VectorRoom<Real> room() const;
  /// Vectors, one a mass of the model, rounded into such room, and those of the free masses back.
  void load(const Vectors& from, VectorRoom<Real>& to) const;
  void load_pins(const Vectors& from, VectorRoom<Real>& to) const;
  void give(const VectorRoom<Real>& from, Vectors& to) const;
  /// to = (b − a)·factor, of the free masses.
  void give_difference(const VectorRoom<Real>& a, const VectorRoom<Real>& b, Real factor, Vectors& to) const;
};

extern template struct MassPlaces<double>;
extern template struct MassPlaces<float>;

}  // namespace taut
