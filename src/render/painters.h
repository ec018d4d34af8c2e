#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/frame_block.h"
#include "geometry/geometry.h"
#include "gl/gl_objects.h"
#include "gl/program.h"
#include "gl/targets.h"
#include "view/view.h"

namespace taut {

/// Shaders that draw in colour and into the shadow map.
struct PainterShaders {
  std::string_view vertex, colour, shadow;
  std::string_view shadow_vertex = vertex;
};

/// A program for each kind of pass.
struct PassPrograms {
  Program colour, shadow;

  /// The shadow map's pass knows none of the colour's defines.
  PassPrograms(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
               const Defines& colour_defines);
};

enum class Pass { colour, shadow };

/// Draws squares turned to the eye, one a record: spheres and links.
class SquarePainter {
 public:
  SquarePainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
                const Defines& defines, std::size_t record_size, std::span<const Attribute> attributes);

  template <typename Record>
  void upload(const std::vector<Record>& records) {
    records_.upload(std::span(records));
  }
  void draw(Pass pass) const { draw(pass, records_.count()); }
  /// The first so many records.
  void draw(Pass pass, GLsizei count) const;

 private:
  const Gl* gl_;
  PassPrograms programs_;
  GlObject array_;
  VertexStream records_;
};
SquarePainter sphere_painter(const Gl& gl, const ShaderLibrary& library, const Defines& defines);
SquarePainter link_painter(const Gl& gl, const ShaderLibrary& library, const Defines& defines);

/// Draws cloth. How much light reaches it is worked out once for each place of its sheets, in a map, rather
/// than for each fragment: many of those lie in pixels that others cover, or share them with others.
class SurfacePainter {
 public:
  /// `defines` without those of the look.
  SurfacePainter(const Gl& gl, const ShaderLibrary& library, const Look& look, Defines defines);

  /// What several frames share is uploaded only when it is another.
  void upload(const SurfaceMesh& mesh);
  /// Works out, from the block and the shadow map that are loaded, how much light reaches the cloth, which is
  /// so many pixels a metre large in the picture.
  void draw_light(const SurfaceMesh& mesh, const FrameBlock& block, float pixels_a_metre);
  void draw(Pass pass) const;

 private:
  // What works out how much of it arrives.
  struct Light {
    Program program;
    std::array<GlObject, 3> places;  // taken in turn: the last may still be read from
    GlObject no_attributes;
    LightMap map;
    std::size_t turn = 0;
  };

  const Gl* gl_;
  PassPrograms programs_;
  GlObject array_;
  VertexStream vertices_, places_;
  std::optional<VertexStream> colours_;  // only where the look has any
  std::optional<VertexStream> tints_;    // only where sheets have colours of their own
  IndexStream indices_;
  SharedIndices uploaded_indices_;
  SharedPlaces uploaded_places_;
  std::optional<Light> light_;  // only where there are shadows
};

/// Draws rods and balls. Their roundness follows their size in the picture.
class RodPainter {
 public:
  RodPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines);

  /// `pixel`: a pixel's height (m) at a metre from the eye.
  void upload(const std::vector<TaperedRod>& rods, float pixel);
  void draw(Pass pass) const;

 private:
  // A ball of so many sides, and the rods that are drawn with it.
  struct Round {
    int sides;
    GlObject array;
    VertexStream ball, rods;
    IndexStream triangles;

    Round(const Gl& gl, int round);
  };

  const Gl* gl_;
  PassPrograms programs_;
  std::vector<Round> rounds_;
};

/// Draws the trunks of bodies. Their roundness follows their size in the picture.
class TorsoPainter {
 public:
  TorsoPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines);

  /// `pixel`: a pixel's height (m) at a metre from the eye.
  void upload(const std::vector<TorsoRecord>& torsos, float pixel);
  void draw(Pass pass) const;

 private:
  // A skin of so many sides, and the trunks that are drawn with it.
  struct Skin {
    int sides;
    GlObject array;
    VertexStream skin, torsos;
    IndexStream triangles;

    Skin(const Gl& gl, int round);
  };

  const Gl* gl_;
  PassPrograms programs_;
  Skin for_shadow_;  // a coarse one will do
  std::vector<Skin> skins_;
};

/// Draws solids out of meshes. Each one's mesh is uploaded once.
class SolidPainter {
 public:
  SolidPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines);

  void upload(const std::vector<MeshRecord>& meshes);
  void draw(Pass pass) const;

 private:
  // A mesh as OpenGL has it.
  struct Stored {
    std::shared_ptr<const SolidSurface> surface;
    GlObject array;
    VertexStream vertices;
    IndexStream triangles;

    Stored(const Gl& gl, const std::shared_ptr<const SolidSurface>& surface);
  };

  const Gl* gl_;
  PassPrograms programs_;
  std::vector<Stored> stored_;
  std::vector<MeshRecord> drawn_;
  std::vector<std::size_t> which_;  // of those stored, each that is drawn
};

/// Draws boxes.
class BoxPainter {
 public:
  BoxPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines);

  void upload(const std::vector<BoxRecord>& boxes) { records_.upload(std::span(boxes)); }
  void draw(Pass pass) const;

 private:
  const Gl* gl_;
  PassPrograms programs_;
  GlObject array_;
  VertexStream records_;
};

}  // namespace taut
