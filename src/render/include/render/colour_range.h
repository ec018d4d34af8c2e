#pragma once

#include <cstdint>
#include <map>

#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

/// Finds the range of colours that suits many states together. The few largest values, of links about to
/// break or at a corner, would leave all others one colour: the top is what 98 % of all values stay below.
class ColourRange {
 public:
  explicit ColourRange(ColourBy by) : by_(by) {}

  /// The values of a state: of its whole structural links, or for speed of its masses. What braces a sheet
  /// against shear and bending stretches far more than its threads, and says less. What the look hides says
  /// nothing.
  void add(const Model& model, const State& state, const Look& look);
  void add(double value);

  /// The next round number at or above what 98 % stay below; 1 where no value is above zero.
  double top() const;

 private:
  ColourBy by_;
  // Counted by size, in steps of one per cent, so that there may be any number of them.
  std::map<int, std::int64_t> counts_;
  std::int64_t count_ = 0;
};

/// The next of …, 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, … at or above a value; 1 for values that aren't
/// positive.
double round_number_above(double value);

}  // namespace taut
