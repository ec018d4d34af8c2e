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
/// A mass has the mean of its whole links, or its own speed. Empty when the look is plain.
struct Quantity {
  std::vector<double> of_link, of_mass;
};

Quantity quantity(const Model& model, const State& state, ColourBy by);

/// A perceptual colour map from 0 to `top`: equal steps of value look like equal steps of lightness.
struct ColourScale {
  double top = 1.0;
  Theme theme = Theme::light;

  Colour at(double value) const;
};

/// The scale of a look: its own range, or the next round number above the frame's largest value.
ColourScale colour_scale(const Look& look, const Model& model, const State& state, const Quantity& quantity);

/// The next of …, 1, 2, 5, 10, … at or above a value; 1 for values that aren't positive.
double round_number_above(double value);

}  // namespace taut
