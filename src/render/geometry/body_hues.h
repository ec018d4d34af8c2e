#pragma once

#include <vector>

#include "view/view.h"

namespace taut {

/// Colours for so many bodies: the seed itself for one, else hues of its lightness that lie apart, also for
/// eyes that don't tell red from green. Those of neighbours lie far apart; beyond a dozen they come again.
std::vector<Colour> body_hues(const Colour& seed, std::size_t count);

/// Lightness (0 black, 1 white), and how green or red and how blue or yellow a colour is, in steps that look
/// alike: Ottosson, A perceptual color space for image processing (Oklab), 2020.
struct Oklab {
  double lightness = 0.0, green_red = 0.0, blue_yellow = 0.0;
};
Oklab oklab(const Colour& colour);
/// Cut off where a display can't show it.
Colour colour_of(const Oklab& lab);

}  // namespace taut
