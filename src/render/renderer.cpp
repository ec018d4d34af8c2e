#include "render/renderer.h"

#include <algorithm>
#include <array>
#include <deque>
#include <optional>
#include <span>

#include "backdrop.h"
#include "blockers.h"
#include "geometry/contact_shade.h"
#include "geometry/frame_block.h"
#include "geometry/palette.h"
#include "geometry/region.h"
#include "gl/frame_uniforms.h"
#include "ground_shades.h"
#include "layers.h"
#include "lines_painter.h"
#include "painters.h"
#include "shade_map.h"

namespace taut {
namespace {

// How far around its true edge a shadow is soft, in texels of its map; see shaders/lighting.glsl.
constexpr float blur_in_texels = 6.0F;

Defines defines_of(const RenderSettings& settings, const Look& look) {
  Defines defines;
  if (settings.samples > 1) defines.emplace_back("MULTISAMPLED");
  if (look.shadows && settings.shadow_map_size > 0) defines.emplace_back("SHADOWS");
  return defines;
}

// The same for bodies and solids.
Defines body_defines(const RenderSettings& settings, const Look& look) {
  Defines defines = defines_of(settings, look);
  if (shows_contact(look) && settings.shadow_map_size > 0) defines.emplace_back("CONTACT");
  return defines;
}

template <typename Vector>
std::string constant(std::string_view name, const Vector& value) {
  std::string text = std::string(name) + " vec" + std::to_string(Vector::length()) + "(";
  for (int i = 0; i < Vector::length(); ++i) text += (i > 0 ? ", " : "") + std::to_string(value[i]);
  return text + ")";
}

glm::vec3 vector_of(const Colour& colour) {
  return {colour[0], colour[1], colour[2]};
}

// Steps of a channel, from none to full.
std::string steps_of(const RenderSettings& settings) {
  return settings.bits == 16 ? "STEPS 65535.0" : "STEPS 255.0";
}

// What shaders take as numbers.
Defines constants_of(const Look& look, const RenderSettings& settings) {
  const Palette colours = palette(look.theme);
  return {steps_of(settings),
          "LIGHT_SPREAD " + std::to_string(light_spread),
          constant("ROD_TILE", glm::vec2(rod_tile - 1)),
          constant("TORSO_TILE", glm::vec2(torso_tile - 1)),
          constant("TO_LIGHT", direction_to_light()),
          constant("LIGHT", colours.light),
          constant("AMBIENT_BELOW", colours.ambient_below),
          constant("AMBIENT_ABOVE", colours.ambient_above),
          constant("HORIZON", colours.horizon),
          constant("SKY", colours.sky),
          constant("GROUND", glm::vec4(colours.ground, colours.grid_strength)),
          constant("FRONT_COLOUR", vector_of(look.surface_colour)),
          constant("BACK_COLOUR", vector_of(look.surface_back_colour))};
}

// Wider by up to so many pixels that it begins and ends on whole tiles of the dither's pattern: else the
// pattern would move with it.
Region on_tiles(const Region& region, Size picture) {
  constexpr int tile = 4;
  const int left = region.left / tile * tile, top = region.top / tile * tile;
  const int right = std::min((region.left + region.width + tile - 1) / tile * tile, picture.width);
  const int bottom = std::min((region.top + region.height + tile - 1) / tile * tile, picture.height);
  return {left, top, right - left, bottom - top};
}

std::vector<Readback> one(Readback readback) {
  std::vector<Readback> readbacks;
  readbacks.push_back(std::move(readback));
  return readbacks;
}

// By how much of a pixel each pass over its samples is shifted: two so that each has its samples between the
// other's.
std::span<const glm::vec2> shifts_of(int passes) {
  static constexpr std::array<glm::vec2, 2> two{glm::vec2(-0.0625F, -0.125F), glm::vec2(0.0625F, 0.125F)};
  static constexpr std::array<glm::vec2, 1> one{glm::vec2(0.0F)};
  return passes == 2 ? std::span<const glm::vec2>(two) : one;
}

}  // namespace

// A frame that OpenGL has been told to draw.
struct Renderer::Submitted {
  std::shared_ptr<LitBackdrop> backdrop;  // absent where the picture is transparent
  struct Part {
    Region region;
    std::vector<Readback> passes;
  };
  std::vector<Part> parts;
  std::optional<ColourScale> scale;  // where the picture has a legend
  GLsync done = nullptr;
};

/// The OpenGL side of a Renderer. Every call, the destructor's too, needs the context to be current.
class Renderer::Drawing {
 public:
  Drawing(const GlContext& context, const Look& look, const RenderSettings& settings,
          const std::filesystem::path& shader_folder);
  void submit(const Geometry& geometry);
  Layers fetch();

 private:
  bool casts_shadows() const { return shadow_map_.has_value(); }
  void upload(const Geometry& geometry);
  void draw_shadow_map(const Geometry& geometry);
  void draw_casters(const Geometry& geometry) const;
  FrameBlock camera(const Geometry& geometry, const glm::vec2& shift = glm::vec2(0.0F)) const;
  std::vector<Readback> passes(const Geometry& geometry, const Region& region);
  void draw_opaque(const Geometry& geometry) const;
  void draw_lattice() const;
  Region shadows_on_grounds(const Geometry& geometry) const;
  Readback shaded_grounds(const Geometry& geometry, const Region& region);

  Gl gl_;
  ShaderLibrary library_;
  Look look_;
  RenderSettings settings_;
  std::optional<Font> font_;
  FrameUniforms uniforms_;
  PictureTarget target_;
  std::optional<ShadowMap> shadow_map_;
  std::optional<Blockers> blockers_;           // where there are shadows
  std::optional<GroundShades> ground_shades_;  // the same
  FrameBlock light_;                           // of the shadow map
  SquarePainter spheres_, links_;
  SurfacePainter surface_;
  RodPainter rods_;
  TorsoPainter torsos_;
  BoxPainter boxes_;
  SolidPainter meshes_;
  ShadeMap shade_map_;
  LinesPainter lines_;
  Backdrop backdrop_;
  std::deque<Submitted> submitted_;  // and not fetched yet
};

Renderer::Drawing::Drawing(const GlContext& context, const Look& look, const RenderSettings& settings,
                           const std::filesystem::path& shader_folder)
    : gl_(context),
      library_(shader_folder, constants_of(look, settings)),
      look_(look),
      settings_(settings),
      uniforms_(gl_),
      target_(gl_, settings.size, samples_at_once(gl_, settings.samples), settings.bits),
      spheres_(sphere_painter(gl_, library_, defines_of(settings, look))),
      links_(link_painter(gl_, library_, defines_of(settings, look))),
      surface_(gl_, library_, look, defines_of(settings, look)),
      rods_(gl_, library_, body_defines(settings, look)),
      torsos_(gl_, library_, body_defines(settings, look)),
      boxes_(gl_, library_, body_defines(settings, look)),
      meshes_(gl_, library_, body_defines(settings, look)),
      shade_map_(gl_),
      lines_(gl_, library_, defines_of(settings, look)),
      backdrop_(gl_, library_, settings.size, settings.transparent, settings.bits) {
  if (look.colour_by != ColourBy::plain) font_ = Font::load();
  if (look.shadows && settings.shadow_map_size > 0) {
    shadow_map_.emplace(gl_, settings.shadow_map_size);
    blockers_.emplace(gl_, library_, settings.shadow_map_size);
    ground_shades_.emplace(gl_, library_, settings.shadow_map_size);
  }
}

void Renderer::Drawing::submit(const Geometry& geometry) {
  gl_.enable(GL_DEPTH_TEST);
  gl_.depth_function(GL_LEQUAL);
  // The picture is drawn upside down, which turns triangles round.
  gl_.front_face(GL_CW);
  upload(geometry);
  if (casts_shadows()) draw_shadow_map(geometry);

  Submitted frame;
  if (geometry.legend) frame.scale = geometry.scale;
  const FrameBlock block = camera(geometry);
  uniforms_.load(block);
  if (!settings_.transparent) frame.backdrop = backdrop_.lit(geometry, block);
  if (const Region region = shadows_on_grounds(geometry); !region.empty())
    frame.parts.push_back({region, one(shaded_grounds(geometry, region))});
  if (const Region region = drawn_region(geometry, settings_.size); !region.empty())
    frame.parts.push_back({region, passes(geometry, region)});
  frame.done = gl_.fence(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl_.flush();
  submitted_.push_back(std::move(frame));
}

Layers Renderer::Drawing::fetch() {
  const Submitted frame = std::move(submitted_.front());
  submitted_.pop_front();
  // Reading at once would wait for whatever has been submitted since, too.
  gl_.wait_for_fence(frame.done, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
  gl_.delete_fence(frame.done);
  Layers layers{settings_.size, {}, {}, {}, settings_.bits};
  if (frame.backdrop) layers.backdrop = frame.backdrop->image();
  for (const Submitted::Part& part : frame.parts) {
    Layer& layer = layers.parts.emplace_back(Layer{part.region, {}});
    for (const Readback& pass : part.passes) layer.passes.push_back(pass.fetch());
  }
  if (font_ && frame.scale) layers.legend = {*font_, look_.colour_by, *frame.scale};
  return layers;
}

void Renderer::Drawing::upload(const Geometry& geometry) {
  spheres_.upload(geometry.spheres);
  links_.upload(geometry.links);
  if (geometry.surface.indices) surface_.upload(geometry.surface);
  rods_.upload(geometry.bodies.rods, pixel_height(geometry.pose, settings_.size));
  torsos_.upload(geometry.bodies.torsos, pixel_height(geometry.pose, settings_.size));
  boxes_.upload(geometry.bodies.boxes);
  meshes_.upload(geometry.bodies.meshes);
  if (!geometry.bodies.shades.texels.empty()) shade_map_.upload(geometry.bodies.shades);
  lines_.upload(geometry.lines, pixel_height(geometry.pose, settings_.size));
}

void Renderer::Drawing::draw_shadow_map(const Geometry& geometry) {
  light_ = light_block(geometry, shadow_map_->size());
  uniforms_.load(light_);
  shadow_map_->bind();
  gl_.clear(GL_DEPTH_BUFFER_BIT);
  gl_.enable(GL_POLYGON_OFFSET_FILL);
  gl_.polygon_offset(1.5F, 2.0F);
  draw_casters(geometry);
  gl_.disable(GL_POLYGON_OFFSET_FILL);
  shadow_map_->bind_for_reading();
  // All else is too small to show how wide the edge of a shadow is.
  if (!geometry.surface.vertices.empty() || !geometry.bodies.empty() || !geometry.lines.arrows.empty())
    blockers_->draw(*shadow_map_);
  if (geometry.surface.vertices.empty()) return;
  const FrameBlock block = camera(geometry);
  uniforms_.load(block);
  surface_.draw_light(geometry.surface, block,
                      1.0F / (reach_of(geometry.pose) * pixel_height(geometry.pose, settings_.size)));
}

void Renderer::Drawing::draw_casters(const Geometry& geometry) const {
  // The shadow of a dense lattice is all moiré; the cloth's own triangles say the same, cleanly.
  if (geometry.surface.vertices.empty()) {
    spheres_.draw(Pass::shadow);
    links_.draw(Pass::shadow);
    lines_.draw_shadows();
  } else {
    surface_.draw(Pass::shadow);
    spheres_.draw(Pass::shadow, static_cast<GLsizei>(geometry.sphere_shadows));
    links_.draw(Pass::shadow, static_cast<GLsizei>(geometry.link_shadows));
    if (geometry.line_shadows) lines_.draw_shadows();
  }
  rods_.draw(Pass::shadow);
  torsos_.draw(Pass::shadow);
  boxes_.draw(Pass::shadow);
  meshes_.draw(Pass::shadow);
}

FrameBlock Renderer::Drawing::camera(const Geometry& geometry, const glm::vec2& shift) const {
  FrameBlock block = camera_block(geometry, settings_.size, shift);
  if (casts_shadows()) add_shadow(block, light_);
  return block;
}

std::vector<Readback> Renderer::Drawing::passes(const Geometry& geometry, const Region& region) {
  // Edges of spheres and links are as smooth as there are samples, and only theirs are not the driver's.
  const bool shared = target_.samples() > 1 &&
                      !(geometry.spheres.empty() && geometry.links.empty() && geometry.lines.empty());
  const bool hidden =
      !settings_.transparent && std::ranges::any_of(geometry.grounds, [&](const GroundPatch& ground) {
        return may_hide(ground, geometry);
      });
  std::vector<Readback> drawn;
  for (const glm::vec2& shift : shifts_of(settings_.samples / target_.samples())) {
    uniforms_.load(camera(geometry, shift));
    target_.begin(region, shared ? Alpha::share : Alpha::cover);
    if (hidden) backdrop_.draw_depth(geometry);
    draw_opaque(geometry);
    draw_lattice();
    drawn.push_back(target_.end());
  }
  return drawn;
}

void Renderer::Drawing::draw_opaque(const Geometry& geometry) const {
  if (!geometry.surface.vertices.empty()) surface_.draw(Pass::colour);
  gl_.enable(GL_CULL_FACE);
  rods_.draw(Pass::colour);
  torsos_.draw(Pass::colour);
  boxes_.draw(Pass::colour);
  meshes_.draw(Pass::colour);
  lines_.draw_solid();
  gl_.disable(GL_CULL_FACE);
}

void Renderer::Drawing::draw_lattice() const {
  if (target_.samples() > 1) gl_.enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  spheres_.draw(Pass::colour);
  links_.draw(Pass::colour);
  lines_.draw_ribbons();
  gl_.disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

Region Renderer::Drawing::shadows_on_grounds(const Geometry& geometry) const {
  Region region;
  if (!casts_shadows()) return region;
  for (const GroundPatch& ground : geometry.grounds)
    region =
        around(region, shadow_region(geometry, ground, settings_.size, blur_in_texels * light_.shadow.z));
  return region.empty() ? region : on_tiles(region, settings_.size);
}

Readback Renderer::Drawing::shaded_grounds(const Geometry& geometry, const Region& region) {
  const FrameBlock block = camera(geometry);
  for (std::size_t i = 0; i < geometry.grounds.size(); ++i) {
    const GroundPatch& ground = geometry.grounds[i];
    if (!takes_shadows(ground)) continue;
    std::optional<FrameBlock> contact;
    if (ground.solid && is_near(ground, geometry)) {
      const ShadowMap& map = ground_shades_->contact_map();
      contact = contact_block(geometry, ground, map.size());
      uniforms_.load(*contact);
      map.bind();
      gl_.clear(GL_DEPTH_BUFFER_BIT);
      draw_casters(geometry);
    }
    uniforms_.load(block);
    ground_shades_->draw(geometry, i, region, settings_.size, block, *shadow_map_, contact);
  }
  return backdrop_.shaded(geometry, region, *ground_shades_);
}

Renderer::Renderer(GlContext& context, const Look& look, const RenderSettings& settings,
                   const std::filesystem::path& shader_folder)
    : context_(context) {
  const CurrentContext current(context_);
  drawing_ = std::make_unique<Drawing>(context, look, settings, shader_folder);
}

Renderer::~Renderer() {
  const CurrentContext current(context_);
  drawing_.reset();
}

void Renderer::submit(const Geometry& geometry) {
  const CurrentContext current(context_);
  drawing_->submit(geometry);
}

std::shared_ptr<const Layers> Renderer::fetch() {
  const CurrentContext current(context_);
  return std::make_shared<const Layers>(drawing_->fetch());
}

std::shared_ptr<const Layers> Renderer::draw(const Geometry& geometry) {
  submit(geometry);
  return fetch();
}

}  // namespace taut
