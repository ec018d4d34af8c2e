#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "model/description.h"

namespace taut {

/// A Model and its start while they grow, mass by mass and link by link.
class Builder {
 public:
  /// Adds a mass and returns its index.
  Index add_mass(std::string name, const Vec3& position, const Vec3& velocity, double mass, bool pinned);
  /// Adds a link and returns its index.
  Index add_link(Index a, Index b, double length, const LinkProperties& properties);
  /// Drives a pinned mass, which is put where the motion begins; a spec that names no motion does nothing.
  void drive(Index mass, const MotionSpec& motion);
  void drive(Index mass, Motion motion);

  Model model;
  State start;
};

/// Adds all of a valid chain.
void add_chain(Builder& builder, const ChainSpec& spec);

/// Adds all of a valid sheet.
void add_sheet(Builder& builder, const SheetSpec& spec);

/// Masses and links a sheet has, as real numbers so that no count overflows.
struct Counts {
  double masses = 0.0, links = 0.0, triangles = 0.0;
};
Counts count(const SheetSpec& spec);
Counts count(const ChainSpec& spec);

/// Everything wrong with a description that shows without building it: numbers, names and counts.
std::vector<Problem> find_problems(const Description& description);

}  // namespace taut
