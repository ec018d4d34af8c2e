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
#include "relax/line_kernels.h"
#include "relax/lines.h"
#include "relax/mass_places.h"

namespace taut {

/// What Relaxation<double> is, but that a pass solves lines of links at once (lines.h), one line after
/// another: a row of a sheet answers a pull at its end within one pass.
class LineRelaxation {
 public:
  using Number = double;
  using Masses = VectorRoom<double>;

  /// Small models stay on one thread, whatever there are.
  LineRelaxation(const Model& model, const Execution& execution);

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state);

  /// The links that are visited, in the order of the model.
  const std::vector<Index>& links() const { return links_; }
  std::int64_t size() const { return static_cast<std::int64_t>(links_.size()); }

  const MassPlaces<double>& places() const { return places_; }

  /// Its kernels write multipliers in any case.
  static constexpr bool always_keeps = true;

  /// Begins a step of h seconds. `answer` is what a mass moves by beside its inverse mass, as
  /// Relaxation::begin_step() has it.
  void begin_step(double h, double answer);

  /// One pass along the present directions: for each line, link i between masses i and i + 1, with
  /// d_i = x_i − x_{i+1} and n_i = d_i/|d_i|, all Δλ that solve (XPBD, 2016, eq. 18 and 26, for all links of
  /// the line together)
  ///   (answer (w_i + w_{i+1}) + α̃_i/(1 + γ_i)) Δλ_i
  ///       − answer w_i n_{i−1}·n_i Δλ_{i−1} − answer w_{i+1} n_i·n_{i+1} Δλ_{i+1}
  ///     = (l_i − |d_i| − α̃_i λ_i − γ_i n_i·(d_i − d_i⁰)) / (1 + γ_i)
  /// and then x_i ← x_i + answer w_i (Δλ_i n_i − Δλ_{i−1} n_{i−1}), λ_i ← λ_i + Δλ_i. Of a line of one link
  /// that is the formula of Relaxation::pass(), which has the parameters and the result, too.
  /// A straight line of n links between two pins is as long as it is: no masses can be moved along it so that
  /// all of its links come to their lengths, and the system is singular. So the first factor is larger by
  /// 1/(1000 n) of itself in lines between pins: what can't be undone is spread over all links, and next to
  /// straight lines don't leap sideways for it. What passes converge to is the same.
  bool pass(const Masses& start, Masses& position, PassPlace place,
            const FreeMotion<double>* motion = nullptr);

  /// λ of a link that is visited: the sum over the passes of the step.
  double multiplier(Index link) const { return multiplier_[slot_[link]]; }
  /// values[link] = scale·λ, with the sum λ over the passes of the step.
  void give_multipliers(double scale, std::vector<double>& values) const;

 private:
  // Lines one after another.
  struct Lane {
    std::vector<LinkLine> lines;
    std::size_t rows = 0;  // masses of them all
  };

  void add_colour(const LinkLines& lines, const std::vector<LinkLine>& of_colour);
  void add_group(const LinkLines& lines, std::span<const Lane> lanes, LineGroup group);
  void add_lane(const LinkLines& lines, const Lane& lane, std::size_t slot);
  void share_out(std::size_t first_group);
  void settle_special(double h);
  std::span<const LineGroup> groups_of(std::size_t colour, std::size_t part) const;
  template <class Task>
  void for_each_part(const Task& task);
  bool are_all_finite(const Masses& position);

  const Model& model_;
  MassPlaces<double> places_;
  std::shared_ptr<Workers> workers_;
  std::size_t parts_ = 1;     // that a pass is shared out in, each to a thread
  std::vector<Index> links_;  // in the order of the model

  std::vector<LineGroup> groups_;                // colour after colour
  std::vector<std::vector<std::size_t>> begin_;  // of each colour: where a part's groups begin, and the end
  std::vector<std::vector<double>> scratch_;     // of each part

  // One a slot.
  std::vector<Index> mass_, visited_;  // empty_place and no_link where a lane is filled up
  std::vector<std::uint32_t> place_offset_;
  std::vector<double> move_, length_, stiffening_, diagonal_, multiplier_;
  std::vector<std::size_t> special_slot_;  // by special place
  std::vector<double> scaled_, gamma_, damped_;

  std::vector<std::size_t> slot_;              // of each link that is visited
  double settled_h_ = 0, settled_answer_ = 0;  // what moves and diagonals hold for
};

}  // namespace taut
