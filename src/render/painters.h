#pragma once

#include <span>

#include "gl_objects.h"
#include "lattice.h"
#include "model/view.h"
#include "program.h"
#include "solid_mesh.h"
#include "surface_mesh.h"

namespace taut {

/// Draws spheres. Call upload() before the draws of a frame.
class SpherePainter {
 public:
  SpherePainter(const Gl& gl, const ShaderLibrary& library);
  void upload(std::span<const SphereRecord> records) { stream_.upload(records); }
  void draw() const { draw_with(colour_); }
  void draw_shadow() const { draw_with(shadow_); }

 private:
  void draw_with(const Program& program) const;

  const Gl* gl_;
  Program colour_, shadow_;
  VertexStream stream_;
};

/// Draws links. Call upload() before the draws of a frame.
class LinkPainter {
 public:
  LinkPainter(const Gl& gl, const ShaderLibrary& library);
  void upload(std::span<const LinkRecord> records) { stream_.upload(records); }
  void draw() const { draw_with(colour_); }
  void draw_shadow() const { draw_with(shadow_); }

 private:
  void draw_with(const Program& program) const;

  const Gl* gl_;
  Program colour_, shadow_;
  VertexStream stream_;
};

/// Draws cloth. Call upload() before the draws of a frame.
class SurfacePainter {
 public:
  SurfacePainter(const Gl& gl, const ShaderLibrary& library, const Look& look);
  void upload(const SurfaceMesh& mesh);
  void draw() const { draw_with(colour_); }
  void draw_shadow() const { draw_with(shadow_); }

 private:
  void draw_with(const Program& program) const;

  const Gl* gl_;
  Program colour_, shadow_;
  VertexStream stream_;
  GlObject index_buffer_;
  GLsizei index_count_ = 0;
};

/// Draws bones and solids. Call upload() before the draws of a frame.
class SolidPainter {
 public:
  SolidPainter(const Gl& gl, const ShaderLibrary& library);
  void upload(const SolidMesh& mesh);
  void draw() const { draw_with(colour_); }
  void draw_shadow() const { draw_with(shadow_); }

 private:
  void draw_with(const Program& program) const;

  const Gl* gl_;
  Program colour_, shadow_;
  VertexStream stream_;
  GlObject index_buffer_;
  GLsizei index_count_ = 0;
};

/// Draws ground and sky, behind what is there already.
class BackdropPainter {
 public:
  BackdropPainter(const Gl& gl, const ShaderLibrary& library);
  void draw_ground() const;
  /// `right` and `down` as in shaders/sky.frag.
  void draw_sky(const glm::vec3& right, const glm::vec3& down) const;

 private:
  const Gl* gl_;
  Program ground_, sky_;
  GlObject no_attributes_;
};

}  // namespace taut
