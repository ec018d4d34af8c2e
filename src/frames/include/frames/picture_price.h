#pragma once

#include "model/model.h"
#include "render/renderer.h"

namespace taut {

/// What making one picture of a scene costs, in seconds of the clock on two cores of an ordinary machine,
/// from what there is to be drawn and from the picture's size alone: shaping, drawing, compressing. Fitted to
/// whole films of scenes here, and mostly within a factor of two of them.
double predicted_picture_seconds(const Model& model, const RenderSettings& settings);

}  // namespace taut
