#pragma once

#include <span>
#include <string_view>

#include "gl_objects.h"
#include "ground_patch.h"
#include "lattice.h"
#include "program.h"
#include "solid_mesh.h"
#include "surface_mesh.h"
#include "view/view.h"

namespace taut {

/// Files of shaders: the vertex shader of both draws, and the fragment shader of each.
struct PainterShaders {
  std::string_view vertex, colour, shadow;
};

/// Draws a square for each record, in colour and into the shadow map.
class InstancePainter {
 public:
  void draw() const { draw_with(colour_); }
  void draw_shadow() const { draw_with(shadow_); }

 protected:
  InstancePainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                  std::size_t record_size, std::span<const Attribute> attributes);
  VertexStream& stream() { return stream_; }

 private:
  void draw_with(const Program& program) const;

  const Gl* gl_;
  Program colour_, shadow_;
  VertexStream stream_;
};

/// Draws spheres. Call upload() before the draws of a frame.
class SpherePainter : public InstancePainter {
 public:
  SpherePainter(const Gl& gl, const ShaderLibrary& library);
  void upload(std::span<const SphereRecord> records) { stream().upload(records); }
};

/// Draws links. Call upload() before the draws of a frame.
class LinkPainter : public InstancePainter {
 public:
  LinkPainter(const Gl& gl, const ShaderLibrary& library);
  void upload(std::span<const LinkRecord> records) { stream().upload(records); }
};

/// Draws a mesh, in colour and into the shadow map.
class MeshPainter {
 public:
  void draw() const { draw_with(colour_); }
  void draw_shadow() const { draw_with(shadow_); }

 protected:
  MeshPainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
              std::size_t vertex_size, std::span<const Attribute> attributes);
  const Program& colour() const { return colour_; }

  template <typename Vertex>
  void upload(std::span<const Vertex> vertices, std::span<const Index> indices) {
    stream_.upload(vertices);
    upload_indices(indices);
  }

 private:
  void upload_indices(std::span<const Index> indices);
  void draw_with(const Program& program) const;

  const Gl* gl_;
  Program colour_, shadow_;
  VertexStream stream_;
  GlObject index_buffer_;
  GLsizei index_count_ = 0;
};

/// Draws cloth. Call upload() before the draws of a frame.
class SurfacePainter : public MeshPainter {
 public:
  SurfacePainter(const Gl& gl, const ShaderLibrary& library, const Look& look);
  void upload(const SurfaceMesh& mesh) { MeshPainter::upload(std::span(mesh.vertices), mesh.indices); }
};

/// Draws bones and solids. Call upload() before the draws of a frame.
class SolidPainter : public MeshPainter {
 public:
  SolidPainter(const Gl& gl, const ShaderLibrary& library);
  void upload(const SolidMesh& mesh) { MeshPainter::upload(std::span(mesh.vertices), mesh.indices); }
};

/// Draws ground and sky, behind what is there already.
class BackdropPainter {
 public:
  BackdropPainter(const Gl& gl, const ShaderLibrary& library);
  void draw_ground(const GroundPatch& patch) const;
  /// `right` and `down` as in shaders/sky.frag.
  void draw_sky(const glm::vec3& right, const glm::vec3& down) const;

 private:
  const Gl* gl_;
  Program ground_, sky_;
  GlObject no_attributes_;
};

}  // namespace taut
