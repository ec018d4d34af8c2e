#pragma once

#include <vector>

#include "geometry/lattice.h"

namespace taut {

/// Arrows of loads at the state's time, their tips at what they push: one a mass, or for a load on many
/// masses one in their middle for the whole force. The length is as the force; that of the largest force
/// there ever is, is a fifth of `size` (m). `gap`: m between a tip and its mass. Nothing for a load that
/// doesn't act yet. Places and forces are in picture space: `turned` gives each load's force there (N).
/// None for what is hidden.
std::vector<RodRecord> load_arrows(const Drawn& drawn, const std::vector<Vec3>& turned, double size,
                                   const std::vector<double>& gap);

}  // namespace taut
