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
#include "relax/mass_places.h"
#include "relax/packed.h"

namespace taut {

/// The links that a relaxation pass visits, as data in the order of the visits (visit_order.h), and where the
/// masses lie that it moves: what xpbd (Real: double or float), verlet and shake have in common.
template <class Real>
class Relaxation : public MassPlaces<Real> {
 public:
  using typename MassPlaces<Real>::Masses;

  /// Whether links with stiffness are visited, too.
  enum class Visits { all, rigid };

  /// Small models stay on one thread, whatever there are.
  explicit Relaxation(const Model& model, const Execution& execution, Visits visits = Visits::all);

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state);

  /// The links that are visited, in the order of the model.
  const std::vector<Index>& links() const { return links_; }
  std::int64_t size() const { return static_cast<std::int64_t>(links_.size()); }

  /// Takes the multipliers back to those of the step before, where the passes of this one have failed.
  void take_back() { std::swap(arrays_.multiplier, multiplier_before_); }

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

  /// λ of a link that is visited: the sum over the passes of the step.
  Real multiplier(Index link) const { return arrays_.multiplier[slot_[link]]; }

  /// values[link] = scale·λ, with the sum λ over the passes of the step; after passes along the start, λ
  /// times the link's length.
  void give_multipliers(double scale, std::vector<double>& values) const;
  void give_multipliers_along(double scale, std::vector<double>& values) const;

 protected:
  using MassPlaces<Real>::masses_;
  using MassPlaces<Real>::model_;
  using MassPlaces<Real>::place_;
  using MassPlaces<Real>::room_;

  // Stretches that one thread visits.
  struct Section {
    std::size_t begin, end;
    MassRange masses;
  };

  LinkArrays<Real> arrays();
  std::span<const LinkStretch> stretches_of(const Section& section) const;

  std::vector<Section> sections_;  // of the threads; where there are several, one more for the rest
  std::shared_ptr<Workers> workers_;
  std::vector<Index> visited_;  // link by slot; no_link where a stretch is filled up

  struct Arrays {
    std::vector<std::uint32_t> a, b;                            // as LinkStretch::ends has it
    std::vector<Real> length, multiplier;                       // one a slot
    std::vector<Real> factor, share_a, share_b, scaled, gamma;  // one a special place
  };
  // Whether the masses around where two parts meet are.
  bool unsettled_are_finite(const Masses& position) const;

  Arrays arrays_;
  std::vector<Real> multiplier_before_;  // of the step before
  std::vector<std::uint32_t> slot_;      // of each link that is visited

 private:
  void add_run(const std::vector<Index>& run);
  void add_stretch(const std::vector<Index>& links, LinkStretch stretch);
  void add_strided(std::vector<Index>& links, const LinkStretch& kind);
  void add_slot(Index link, double length, const LinkStretch& stretch);
  std::size_t stride_of(const Index* links) const;
  void add_section(const std::vector<std::vector<Index>>& runs, const MassRange& masses);
  void find_reach(const Section& section);
  void settle(Real h, Real answer);

  Visits visits_;
  double equal_weight_;         // w of all free masses; −1 where they differ
  std::vector<Index> links_;    // in the order of the model
  std::vector<Index> special_;  // link by special place; no_link likewise
  std::vector<LinkStretch> stretches_;
  Real settled_h_ = 0, settled_answer_ = 0;  // what the arrays of special links hold for
};

extern template class Relaxation<double>;
extern template class Relaxation<float>;

}  // namespace taut
