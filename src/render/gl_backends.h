#pragma once

#include <memory>

#include "render/gl_context.h"

namespace taut {

/// A Mesa off-screen context, drawn by the processor. Throws RunFailure when it can't be made.
std::unique_ptr<GlContext> make_osmesa_context();

/// A surfaceless EGL context. Throws RunFailure when it can't be made.
std::unique_ptr<GlContext> make_egl_context();

}  // namespace taut
