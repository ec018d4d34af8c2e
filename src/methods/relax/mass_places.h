#pragma once

#include <vector>

#include "model/model.h"
#include "relax/packed.h"

namespace taut {

/// Where the masses of a model lie that a relaxation moves, and how they come there and back.
template <class Real>
class MassPlaces {
 public:
  using Number = Real;
  using Masses = std::vector<Packed<Real>>;

  /// Room for three-vectors of the masses as passes want them: the free ones first, in an order of their own,
  /// then what else there is.
  Masses room() const { return room_; }
  /// Vectors, one a mass of the model, rounded into such room, and those of the free masses back.
  void load(const Vectors& from, Masses& to) const;
  void load_pins(const Vectors& from, Masses& to) const;
  void give(const Masses& from, Vectors& to) const;
  /// to = (b − a)·factor, of the free masses.
  void give_difference(const Masses& a, const Masses& b, Real factor, Vectors& to) const;

  /// The free masses in the order in which they lie in such room, and where one lies.
  const std::vector<Index>& free_masses() const { return masses_; }
  Index place(Index mass) const { return place_[mass]; }

 protected:
  explicit MassPlaces(const Model& model) : model_(model) {}

  /// Gives the free masses their places, for these links. There are no others yet.
  void give_places(const std::vector<Index>& links);
  /// A free mass's place, or one that a pin is given for this link alone: no two links write to one.
  Index place_of(Index mass);

  const Model& model_;
  std::vector<Index> masses_;  // the free ones, by place
  std::vector<Index> place_;   // of each free mass
  Masses room_;

 private:
  // Where a mass lies beside its place among the free ones: a pin's end of one link.
  struct PinEnd {
    Index mass, place;
  };
  std::vector<PinEnd> pin_ends_;
};

extern template class MassPlaces<double>;
extern template class MassPlaces<float>;

}  // namespace taut
