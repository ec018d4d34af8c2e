#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Where many three-vectors begin, coordinate by coordinate.
template <class Real>
struct Coordinates {
  Real *x, *y, *z;
};

inline Coordinates<double> coordinates(Vectors& vectors) {
  return {vectors.x.data(), vectors.y.data(), vectors.z.data()};
}
inline Coordinates<const double> coordinates(const Vectors& vectors) {
  return {vectors.x.data(), vectors.y.data(), vectors.z.data()};
}

/// What a pass along the directions at the start of a step found.
struct AlongStart {
  double worst = 0.0;         ///< largest ||d|² − l²|/l² that it met
  bool lost = false;          ///< a link has turned by 90° or more, or is not finite: the pass ended there
  Index lost_link = no_link;  ///< that link …
  double lost_along = 0.0;    ///< … and its d·d₀ (m²)
};

/// The links that a relaxation pass visits, as data in the order of the visits, and the plain kernels that
/// visit them: what xpbd (Real: double or float), verlet and shake have in common. Links go colour by colour
/// (coloured_order()), within a colour those between two of many equal masses first: they have no weights to
/// be read.
template <class Real>
class Relaxation {
 public:
  /// Whether links with stiffness are visited, too.
  enum class Visits { all, rigid };

  explicit Relaxation(const Model& model, Visits visits = Visits::all);

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state);

  /// Links of the model in the order of multipliers().
  const std::vector<Index>& links() const { return links_; }
  std::int64_t size() const { return static_cast<std::int64_t>(links_.size()); }

  /// To be called at the start of a step: no multiplier yet.
  void begin_step() { multipliers_.assign(links_.size(), Real(0)); }

  /// One pass along the present directions d = x_a − x_b, n = d/|d|, for each link (XPBD, 2016, eq. 18 and
  /// 26):
  ///   Δλ = (l − |d| − α̃ λ − γ n·(d − d₀)) / ((1 + γ) w + α̃),  w = answer (w_a + w_b)
  ///   x_a ← x_a + answer w_a Δλ n,  x_b ← x_b − answer w_b Δλ n,  λ ← λ + Δλ
  /// with α̃ = α/h², γ = α c/h of its compliance and damping; d₀ is d at `start`, the step's. `answer` is what
  /// a mass moves by beside its inverse mass: 1/(1 + h·drag) where drag is implicit in all forces.
  void pass(Real h, Real answer, const Coordinates<const Real>& start, const Coordinates<Real>& position);

  /// One pass of rigid links along the directions d₀ at the start of the step, one a link in the order of
  /// links() (SHAKE):
  ///   q = (|d|² − l²) / (2 (w_a + w_b) d·d₀),  x_a ← x_a − w_a q d₀,  x_b ← x_b + w_b q d₀,  λ ← λ + q
  AlongStart pass_along(const Coordinates<const Real>& direction, const Coordinates<Real>& position);

  /// λ of each link: the sum over the passes of the step.
  const std::vector<Real>& multipliers() const { return multipliers_; }

 private:
  // What a pass reads of each link between two of many equal masses …
  struct PlainLink {
    Index a, b;
    Real length;  // m
  };
  // … and of every other.
  struct WeightedLink {
    Index a, b;
    Real length;              // m
    Real weight_a, weight_b;  // 1/kg
    Real inverse_weight;      // 1/(w_a + w_b)
  };
  // The ends of a colour among the plain and the weighted links.
  struct Colour {
    std::size_t plain_end, weighted_end;
  };
  struct Softness {
    Real compliance;  // m/N
    Real damping;     // N s/m
  };

  Real weight_a(const PlainLink&) const { return equal_weight_; }
  Real weight_b(const PlainLink&) const { return equal_weight_; }
  Real inverse_weight(const PlainLink&) const { return equal_inverse_weight_; }
  static Real weight_a(const WeightedLink& link) { return link.weight_a; }
  static Real weight_b(const WeightedLink& link) { return link.weight_b; }
  static Real inverse_weight(const WeightedLink& link) { return link.inverse_weight; }

  template <class Visit>
  void for_each_stretch(const Visit& visit);
  template <bool compliant, bool damped, bool flat>
  void pass_of(Real h, Real answer, const Coordinates<const Real>& start, const Coordinates<Real>& position);

  const Model& model_;
  Visits visits_;
  Real equal_weight_, equal_inverse_weight_;  // w of all free masses, 1/(2 w); −1 where they differ
  std::vector<PlainLink> plain_;              // colour by colour
  std::vector<WeightedLink> weighted_;        // the rest of each colour: at pins, or where masses differ
  std::vector<Colour> colours_;
  std::vector<Index> links_;        // the plain ones, then the weighted ones
  std::vector<Softness> softness_;  // of each of them
  bool compliant_ = false, damped_ = false, flat_ = false;
  std::vector<Real> multipliers_;
};

extern template class Relaxation<double>;
extern template class Relaxation<float>;

}  // namespace taut
