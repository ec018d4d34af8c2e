#pragma once

#include <optional>
#include <string_view>

#include "geometry/lines.h"
#include "painters.h"

namespace taut {

/// Draws solid things that differ by a few numbers: one mesh, once a record.
class MeshPainter {
 public:
  /// Vertices and corners of triangles.
  struct Mesh {
    std::vector<glm::vec4> vertices;
    std::vector<GLuint> triangles;
  };

  /// Each of the meshes has records of its own.
  MeshPainter(const Gl& gl, const ShaderLibrary& library, const PainterShaders& shaders,
              const Defines& defines, const std::vector<Mesh>& meshes, std::size_t record_size,
              std::span<const Attribute> attributes);

  template <typename Record>
  void upload(std::size_t mesh, const std::vector<Record>& records) {
    levels_[mesh].records.upload(std::span(records));
  }
  /// So many of the meshes from the first on, each with its records.
  void draw(Pass pass, std::size_t first, std::size_t count) const;

 private:
  struct Level {
    GlObject array;
    VertexStream vertices, records;
    IndexStream triangles;

    Level(const Gl& gl, const Mesh& mesh, std::size_t record_size, std::span<const Attribute> attributes);
  };

  const Gl* gl_;
  PassPrograms programs_;
  std::vector<Level> levels_;
};

/// Draws ropes, chains, arrows and ghosts. What a picture has none of costs nothing: its shaders are compiled
/// when they are needed first.
class LinesPainter {
 public:
  LinesPainter(const Gl& gl, const ShaderLibrary& library, const Defines& defines)
      : gl_(gl), library_(library), defines_(defines) {}

  /// `pixel`: a pixel's height (m) at a metre from the eye.
  void upload(const Lines& lines, float pixel);
  void draw_shadows() const;
  /// What hides what is behind it: rings and arrows.
  void draw_solid() const;
  /// What may cover a part of a pixel: ropes and ghosts.
  void draw_ribbons() const;

 private:
  void upload_rings(const std::vector<RingRecord>& rings, float pixel);

  const Gl& gl_;
  const ShaderLibrary& library_;
  Defines defines_;
  std::optional<SquarePainter> ropes_, ghosts_;
  std::optional<MeshPainter> rings_, arrows_;
};

}  // namespace taut
