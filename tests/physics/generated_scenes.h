#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace taut::test {

/// Numbers from a seed, the same with every standard library.
class Draw {
 public:
  explicit Draw(std::uint32_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }

 private:
  std::mt19937 engine_;
};

/// Scenes without [solve], four of each of ten kinds, as people write their first ones: what they are is
/// drawn from a seed.
struct GeneratedScene {
  std::string name, text;
};

inline std::string world(double duration, double drag) {
  return fmt::format("[world]\nduration = {:.2f}\ndrag = {:.3f}\n", duration, drag);
}

inline std::string chain_text(Draw& draw, const std::string& more) {
  const double length = draw.between(0.5, 3.0);
  return fmt::format(
      "[[chain]]\nname = \"rope\"\nfrom = [0.0, 3.0, 0.0]\nto = [{:.4f}, {:.4f}, 0.0]\nlinks = {}\nmass = "
      "{:.4f}\n{}",
      length, 3.0 - draw.between(0.0, 0.5) * length, draw.whole(3, 40), draw.between(0.05, 2.0), more);
}

inline std::string sheet_text(Draw& draw, const std::string& more) {
  const double width = draw.between(0.4, 2.0);
  return fmt::format(
      "[[sheet]]\nname = \"cloth\"\nrows = {}\ncolumns = {}\nfrom = [0.0, 3.0, 0.0]\nto = [{:.4f}, 3.0, "
      "0.0]\ndown = [0.0, {:.4f}, "
      "{:.4f}]\nmass = {:.4f}\n{}",
      draw.whole(4, 14), draw.whole(4, 14), width, draw.between(-1.0, -0.2), draw.between(0.1, 0.8),
      draw.between(0.1, 1.0), more);
}

inline std::vector<GeneratedScene> generated_scenes(std::uint32_t seed) {
  Draw draw(seed);
  std::vector<GeneratedScene> scenes;
  const auto add = [&](const std::string& kind, int place, const std::string& text) {
    scenes.push_back({fmt::format("{}-{}", kind, place), text});
  };
  for (int i = 1; i <= 4; ++i) {
    add("chain", i,
        world(draw.between(1.0, 4.0), draw.between(0.0, 2.0)) + chain_text(draw, "pinned = [\"first\"]\n"));
    add("net", i,
        world(draw.between(1.0, 3.0), draw.between(0.3, 2.0)) +
            sheet_text(draw, i % 2 == 0 ? "pinned = [\"top\"]\n"
                                        : "pinned = [\"top-left\", \"top-right\"]\ndiagonals = true\n"));
    add("springs", i,
        world(draw.between(1.0, 4.0), draw.between(0.0, 1.0)) +
            chain_text(draw, fmt::format("pinned = [\"first\"]\nstiffness = {:.1f}\ndamping = {:.4f}\n",
                                         std::pow(10.0, draw.between(1.5, 4.5)), draw.between(0.0, 0.05))));
    add("mixed", i,
        world(draw.between(1.0, 3.0), draw.between(0.2, 2.0)) +
            sheet_text(draw, fmt::format("pinned = [\"top\"]\ndiagonals = {{ stiffness = {:.1f} }}\n",
                                         std::pow(10.0, draw.between(1.0, 3.5)))));
    const int joint = draw.whole(1, 2);
    add("stops", i,
        world(draw.between(1.0, 3.0), draw.between(0.2, 2.0)) + chain_text(draw, "pinned = [\"first\"]\n") +
            fmt::format(
                "[[angle]]\nmasses = [\"rope.{}\", \"rope.{}\", \"rope.{}\"]\nmin = {:.1f}\nmax = 180\n",
                joint - 1, joint, joint + 1, draw.between(100.0, 170.0)));
    add("ground", i,
        world(draw.between(1.0, 2.5), draw.between(0.1, 1.0)) + chain_text(draw, "radius = 0.02\n") +
            fmt::format("[[plane]]\npoint = [0.0, {:.3f}, 0.0]\nfriction = {:.2f}\n", draw.between(0.5, 2.0),
                        draw.between(0.0, 0.8)));
    add("ball", i,
        world(draw.between(1.0, 3.0), 0.0) +
            fmt::format("[[mass]]\nname = \"ball\"\nposition = [0.0, {:.3f}, 0.0]\nvelocity = [{:.3f}, 0.0, "
                        "0.0]\nmass = 1.0\nradius = "
                        "{:.3f}\n[[plane]]\nrestitution = {:.2f}\n",
                        draw.between(0.5, 3.0), draw.between(-1.0, 1.0), draw.between(0.05, 0.2),
                        draw.between(0.0, 0.9)));
    add("tip", i,
        world(draw.between(1.0, 3.0), draw.between(0.0, 1.0)) +
            chain_text(draw,
                       fmt::format("pinned = [\"first\"]\nlast_mass = {:.3f}\n", draw.between(0.5, 20.0))));
    add("driven", i,
        world(draw.between(1.0, 3.0), draw.between(0.2, 2.0)) +
            chain_text(draw, fmt::format(
                                 "pinned = [\"first\"]\nfirst_motion = {{ amplitude = [{:.3f}, 0.0, {:.3f}], "
                                 "angular_frequency = {:.2f} }}\n",
                                 draw.between(0.02, 0.3), draw.between(0.0, 0.1), draw.between(2.0, 15.0))));
    add("wind", i,
        world(draw.between(1.0, 2.5), draw.between(0.1, 1.0)) + sheet_text(draw, "pinned = [\"left\"]\n") +
            fmt::format("[wind]\nvelocity = [{:.2f}, 0.0, {:.2f}]\ngust = 0.3\nseed = {}\n",
                        draw.between(1.0, 6.0), draw.between(-1.0, 1.0), i));
  }
  return scenes;
}

}  // namespace taut::test
