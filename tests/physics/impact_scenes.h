#pragma once

#include "model/description.h"

namespace taut::test {

/// A slanting chain falls on smooth ground and lies down on it, mass by mass.
inline Description landing_chain() {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {0.0, 0.1, 0.0};
  chain.to = {0.3, 0.55, 0.1};
  chain.links = 5;
  description.chains = {chain};
  PlaneSpec ground;
  ground.friction = 0.0;
  description.planes = {ground};
  return description;
}

/// A slack string, and a ball that falls onto its middle from straight above.
inline Description string_and_ball() {
  Description description;
  ChainSpec string;
  string.name = "along";
  string.from = {-0.5, 0.0, 0.0};
  string.to = {0.5, 0.0, 0.0};
  string.links = 6;
  string.length = 1.15;
  string.mass = 0.7;
  string.pinned = {"first", "last"};
  string.radius = 0.02;
  string.collides = true;
  MassSpec ball;
  ball.name = "ball";
  ball.position = {0.0, 0.2, 0.0};
  ball.radius = 0.1;
  ball.collides = true;
  description.chains = {string};
  description.masses = {ball};
  return description;
}

}  // namespace taut::test
