#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "scene/scene.h"

namespace taut {

/// What to say of a picture of a state in which masses are below a drawn ground that stops nothing, such as
/// people take for a floor; nothing where none are, where the ground isn't drawn or where the eye, too, is
/// below it. The scene's camera is settled; `seen` says which masses are to be seen (masses_in_view()).
std::optional<std::string> ground_note(const Scene& scene, const std::vector<bool>& seen, const State& state);

/// Looks at what is in a picture and what isn't, of a run as it is drawn.
class PictureNotes {
 public:
  /// `ground`: whether the ground is drawn. The scene's camera is settled, for pictures of that size.
  void see(const Scene& scene, Size size, bool ground, const State& state);

  /// What is odd about the pictures: masses below the ground, at the first time, and how many were outside
  /// the picture, and since when. Nothing where nothing is.
  std::optional<std::string> text() const;

 private:
  std::optional<std::string> ground_;
  double out_since_ = 0.0;                    // s
  std::size_t most_out_ = 0, least_out_ = 0;  // masses
  std::size_t masses_ = 0;                    // of those that are to be seen
  std::vector<bool> seen_masses_;
  bool seen_any_ = false;
};

}  // namespace taut
