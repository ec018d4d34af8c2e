#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace taut {

/// Small pictures of how much light from all around reaches parts of surfaces, 0 to 255, beside each other in
/// one.
struct ShadeTiles {
  static constexpr unsigned width = 1024;
  std::vector<std::uint8_t> texels;  ///< row by row

  struct Tile {
    glm::vec2 corner;     ///< its first texel
    std::uint8_t* first;  ///< until another is added

    std::uint8_t& operator[](std::size_t i) const { return first[i]; }
  };
  /// A tile of so many columns and rows.
  Tile add(const glm::uvec2& size);

 private:
  glm::uvec2 next_{0U};
  unsigned height_ = 0;  // of the tiles in the last row of them
};

/// In place of a tile's first texel: nothing is near.
inline constexpr glm::vec2 no_shade{-1.0F};

/// Columns and rows of a rod's tile: around it, the first column again as the last; from tip to tip, with the
/// seams of both halves and the middle of what is between them.
inline constexpr glm::ivec2 rod_tile{13, 7};
/// The same of a trunk's.
inline constexpr glm::ivec2 torso_tile{11, 9};

}  // namespace taut
