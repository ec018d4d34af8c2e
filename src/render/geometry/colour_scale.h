#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "model/state.h"
#include "view/view.h"

namespace taut {

using Rgba = std::array<std::uint8_t, 4>;

Rgba opaque(const Colour& colour);

/// The quantity that a Look colours by: one value a link and one a mass (strain: 1, tension: N, speed: m/s).
/// A mass has the mean of its whole structural links, or its own speed. Empty when the look is plain.
struct Quantity {
  std::vector<double> of_link, of_mass;
};

Quantity quantity(const Model& model, const State& state, ColourBy by);

/// A perceptual colour map up to `top`: equal steps of value, or of its logarithm, look like equal steps of
/// lightness.
struct ColourScale {
  double top = 1.0;
  Theme theme = Theme::light;
  ColourSteps steps = ColourSteps::linear;
  bool open = true;  ///< whether there may be values above the top

  Colour at(double value) const;
  /// The value at a share of the way to the top.
  double value_at(double share) const;
};

/// The scale of a look: its own range, or where that is open, that of the one state.
ColourScale colour_scale(const Look& look, const Model& model, const State& state);

}  // namespace taut
