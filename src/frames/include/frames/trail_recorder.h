#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/trails.h"
#include "scene/scene.h"

namespace taut {

/// Keeps the ways of the masses whose trails a scene's look shows. Their points are at the same times
/// whatever frames are asked for, so that a picture doesn't depend on those before it.
class TrailRecorder {
 public:
  explicit TrailRecorder(const Scene& scene);

  /// The time (s) of the next point; infinity where no trails are wanted.
  double next() const;
  /// Takes the state at that time.
  void add(const State& state);
  /// The trails that end at a state not before the last point. Null where none are wanted.
  std::shared_ptr<const Trails> up_to(const State& now) const;

  /// All that it takes to go on, as bytes.
  std::string save() const;
  /// Goes on from what save() gave for the same scene. Throws BadRequest where it is of another.
  void restore(std::string_view bytes);

 private:
  std::vector<Index> masses_;
  double kept_;  // s, as far back as trails reach
  std::int64_t taken_ = 0;
  Trails trails_;
};

}  // namespace taut
