#pragma once

#include <memory>
#include <optional>

#include "base/image.h"
#include "model/model.h"
#include "model/state.h"
#include "render/camera.h"
#include "render/trails.h"
#include "view/view.h"

namespace taut {

/// What a picture shows of one state, ready to be drawn: see geometry/geometry.h.
struct Geometry;

/// Where a picture is taken from, and its size in pixels.
struct Sight {
  CameraPose pose;
  Size size;
};

/// Works out what pictures of one model show. Knows nothing of OpenGL, and may run in another thread than
/// what draws.
class GeometryMaker {
 public:
  /// Refers to the model from then on. How finely cloth is drawn follows from how large it is in the first
  /// picture, and stays; without a sight it is as coarse as its masses. `exact`: a state that is drawn as a
  /// ghost beside all others; none where there is none.
  GeometryMaker(const Model& model, const State& start, const Look& look,
                const std::optional<Sight>& sight = {}, const std::optional<State>& exact = {});
  ~GeometryMaker();
  GeometryMaker(const GeometryMaker&) = delete;
  GeometryMaker& operator=(const GeometryMaker&) = delete;

  /// What is seen of a state from a place, with trails where there are any.
  std::shared_ptr<const Geometry> make(const State& state, const CameraPose& pose,
                                       const Trails* trails = nullptr);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace taut
