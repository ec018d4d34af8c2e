// For vertices: how bright light from all around makes a place of a body or solid past what is near it.

// CONTACT: where that is shown.
#ifdef CONTACT
uniform sampler2D shade_map;

out float open;

/// At a place of a tile, in texels from its first one; 1 for what has no tile.
float openness(vec2 tile, vec2 place) {
  return tile.x < 0.0 ? 1.0 : textureLod(shade_map, (tile + place + 0.5) / vec2(textureSize(shade_map, 0)), 0.0).r;
}
#endif
