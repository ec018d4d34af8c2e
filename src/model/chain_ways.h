#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/description.h"

namespace taut {

class Checker;
struct Spool;

/// The solid that a winding goes around, as wide as the middle of the chain lies off its axis (m); nothing
/// where the scene has no sphere or capsule of that name, or of that section and number ("sphere.0",
/// "capsule.1").
std::optional<Spool> spool_of(const ChainSpec& chain, const Description& description);

/// The names that a winding may go around.
std::vector<std::string> spool_names(const Description& description);

/// Where the masses of a chain that is laid along points or around a solid are, all links of one length;
/// nothing where it turns too sharply for so few links. The chain is sound but for that.
std::optional<std::vector<Vec3>> laid_out_chain(const ChainSpec& chain, const Description& description);

/// Adds what is wrong with where chains lie.
void check_chain_ways(Checker& check, const Description& description);

}  // namespace taut
