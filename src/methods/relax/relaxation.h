#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"
#include "relax/kernels.h"
#include "relax/link_layout.h"
#include "relax/vector_room.h"

namespace taut {

/// The links that a relaxation pass visits, as data in the order of the visits (visit_order.h), and where the
/// masses lie that it moves: what xpbd (Real: double or float), verlet and shake have in common.
template <class Real>
class Relaxation {
 public:
  using Number = Real;
  using Masses = VectorRoom<Real>;

  /// Whether links with stiffness are visited, too.
  enum class Visits { all, rigid };

  /// Small models stay on one thread, whatever there are.
  explicit Relaxation(const Model& model, const Execution& execution, Visits visits = Visits::all);

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state);

  /// The links that are visited, in the order of the model.
  const std::vector<Index>& links() const { return links_; }
  std::int64_t size() const { return static_cast<std::int64_t>(links_.size()); }
  /// Where its masses lie: split where links follow each other as those of a sheet do.
  const MassPlaces<Real>& places() const { return lay_; }

  /// Whether multipliers are kept in every pass.
  static constexpr bool always_keeps = false;

  /// Begins a step of h seconds. `answer` is what a mass moves by beside its inverse mass:
  /// 1/(1 + h·drag) where drag is implicit in all forces.
  void begin_step(Real h, Real answer);

  /// One pass along the present directions d = x_a − x_b, n = d/|d|, for each link (XPBD, 2016, eq. 18 and
  /// 26):
  ///   Δλ = (l − |d| − α̃ λ − γ n·(d − d₀)) / ((1 + γ) w + α̃),  w = answer (w_a + w_b)
  ///   x_a ← x_a + answer w_a Δλ n,  x_b ← x_b − answer w_b Δλ n,  λ ← λ + Δλ
  /// with α̃ = α/h², γ = α c/h of its compliance and damping; d₀ is d at `start`, the step's. `motion`:
  /// free masses come to `position` by it first. False when one is not finite, looked at in the last pass.
  bool pass(const Masses& start, Masses& position, PassPlace place, const FreeMotion<Real>* motion = nullptr);

  /// λ of a link that is visited: the sum over the passes of the last step that has kept them.
  Real multiplier(Index link) const { return arrays_.multiplier[slot_[link]]; }

  /// values[link] = scale·λ, with that λ; after passes along the start, λ
  /// times the link's length.
  void give_multipliers(double scale, std::vector<double>& values) const;
  void give_multipliers_along(double scale, std::vector<double>& values) const;

 protected:
  LinkArrays<Real> arrays();
  std::span<const LinkStretch> stretches_of(const LinkSection& section) const;

  LinkLayout<Real> lay_;
  std::shared_ptr<Workers> workers_;

  struct Arrays {
    AlignedVector<Real> multiplier;                               // one a slot
    AlignedVector<Real> factor, share_a, share_b, scaled, gamma;  // one a special place
  };
  // Whether the masses around where two parts meet are.
  bool unsettled_are_finite(const Masses& position) const;

  Arrays arrays_;
  std::vector<std::uint32_t> slot_;  // of each link that is visited

 private:
  void list_links();
  void lay_out(const State& state);

  const Model& model_;
  Visits visits_;
  double equal_weight_;                      // w of all free masses; −1 where they differ
  std::vector<Index> listed_;                // all that may ever be visited, as visit_order() takes them
  std::vector<Index> links_;                 // in the order of the model
  Real settled_h_ = 0, settled_answer_ = 0;  // what the arrays of special links hold for
};

extern template class Relaxation<double>;
extern template class Relaxation<float>;

}  // namespace taut
