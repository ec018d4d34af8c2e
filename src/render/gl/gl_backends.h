#pragma once

#include <memory>
#include <optional>

#include "render/gl_context.h"

namespace taut {

/// A Mesa off-screen context, drawn by the processor. Throws RunFailure when it can't be made.
std::unique_ptr<GlContext> make_osmesa_context();

/// An EGL context without a surface, on one of its devices or on Mesa's surfaceless platform, or where that
/// is missing on the first device that works. Throws RunFailure when it can't be made.
std::unique_ptr<GlContext> make_egl_context(std::optional<int> device);

/// How many devices EGL knows: 0 where it knows of none.
int count_egl_devices();

}  // namespace taut
