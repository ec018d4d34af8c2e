#pragma once

#include "frames/painter.h"
#include "study/sag.h"

namespace taut {

/// All rest shapes of a study as one picture: a panel each, from where all can be seen whole, with the exact
/// shape drawn behind it and its numbers under it. The settings' size is that of one panel.
Image sag_sheet(const Scene& scene, const SagStudy& study, const PictureSettings& settings);

}  // namespace taut
