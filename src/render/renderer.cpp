#include "render/renderer.h"

#include <algorithm>
#include <array>

#include "base/failure.h"
#include "frame_block.h"
#include "gl.h"
#include "ground_patch.h"
#include "legend.h"
#include "painters.h"
#include "targets.h"
#include "view_matrices.h"

namespace taut {
namespace {

// Every fourth grid line is a strong one; see shaders/ground.frag.
constexpr float lines_a_period = 4.0F;

bool is_drawn(const Collider& collider) {
  return !std::holds_alternative<HalfSpace>(collider.shape);
}

}  // namespace

/// The OpenGL side of a Renderer. Every call, the destructor's too, needs the context to be current.
class Renderer::Drawing {
 public:
  Drawing(const GlContext& context, const Model& model, const State& start, const Look& look,
          const RenderSettings& settings, const ShaderLibrary& library);
  Image draw(const State& state, const CameraPose& pose);

 private:
  bool casts_shadows() const { return look_.shadows && settings_.shadow_map_size > 0; }
  bool draws_boxes() const { return look_.masses && look_.mass_shape == MassShape::box; }
  bool draws_solids() const {
    return (look_.bones && !model_.bones.empty()) ||
           (look_.colliders && std::ranges::any_of(model_.colliders, is_drawn)) || draws_boxes();
  }
  bool draws_surface() const { return look_.surface && !model_.triangles.empty(); }
  void upload(const State& seen, const Quantity& quantity, const ColourScale& scale);
  SolidMesh solids_of(const State& seen, const PictureSpace& space, const Quantity& quantity,
                      const ColourScale& scale) const;
  void load_block(const FrameBlock& block) const;
  FrameBlock draw_shadow_map(const Bounds& bounds, const PictureSpace& space) const;
  void draw_picture(const FrameBlock& block, const CameraPose& pose, const PictureSpace& space) const;
  void draw_lattice() const;
  void draw_backdrop(const FrameBlock& block, const CameraPose& pose, const PictureSpace& space) const;

  Gl gl_;
  const Model& model_;
  std::optional<State> start_;  // only where orientations are drawn
  Vec3 fixed_place_;            // m, what texels of the shadow map keep to: one that no camera moves
  Look look_;
  RenderSettings settings_;
  Radii radii_;
  std::vector<glm::vec2> pattern_;
  std::optional<Font> font_;
  PictureTarget target_;
  ShadowMap shadow_map_;
  ShadowMap no_shadow_map_;  // bound while the real one is drawn into, or when there is none
  GlObject frame_buffer_;
  SpherePainter spheres_;
  LinkPainter links_;
  SurfacePainter surface_;
  std::optional<SolidPainter> solids_;  // only where there are any
  BackdropPainter backdrop_;
};

Renderer::Drawing::Drawing(const GlContext& context, const Model& model, const State& start, const Look& look,
                           const RenderSettings& settings, const ShaderLibrary& library)
    : gl_(context),
      model_(model),
      fixed_place_(start.position.size() > 0 ? start.position.at(0) : Vec3(Vec3::Zero())),
      look_(look),
      settings_(settings),
      radii_(radii(model, look)),
      pattern_(pattern_positions(model, look.pattern)),
      target_(gl_, settings.size, settings.samples),
      shadow_map_(gl_, casts_shadows() ? settings.shadow_map_size : 1),
      no_shadow_map_(gl_, 1),
      frame_buffer_(make_buffer(gl_)),
      spheres_(gl_, library),
      links_(gl_, library),
      surface_(gl_, library, look),
      backdrop_(gl_, library) {
  if (look.colour_by != ColourBy::plain) font_ = Font::load();
  if (draws_solids()) solids_.emplace(gl_, library);
  if (draws_boxes()) start_ = start;
}

Image Renderer::Drawing::draw(const State& state, const CameraPose& pose) {
  const Quantity values = quantity(model_, state, look_.colour_by);
  const ColourScale scale = colour_scale(look_, model_, state, values);
  const PictureSpace space(pose);
  const State seen = space.seen(state);
  upload(seen, values, scale);

  Bounds bounds = bounds_of(seen, radii_.mass);
  if (solids_) {
    const SolidMesh mesh = solids_of(seen, space, values, scale);
    solids_->upload(mesh);
    bounds = with_mesh(bounds, mesh);
  }
  FrameBlock block = camera_block(pose, space, settings_.size, settings_.samples, bounds, look_);
  gl_.enable(GL_DEPTH_TEST);
  gl_.depth_function(GL_LEQUAL);
  // The picture is drawn upside down, which turns triangles round.
  gl_.front_face(GL_CW);
  if (casts_shadows()) add_shadow(block, draw_shadow_map(bounds, space));
  draw_picture(block, pose, space);

  Image image = target_.read(settings_.transparent ? 4 : 3);
  if (font_) draw_legend(image, *font_, look_.colour_by, scale);
  return image;
}

void Renderer::Drawing::upload(const State& seen, const Quantity& values, const ColourScale& scale) {
  spheres_.upload(std::span<const SphereRecord>(sphere_records(model_, seen, look_, radii_, values, scale)));
  links_.upload(std::span<const LinkRecord>(link_records(model_, seen, look_, radii_, values, scale)));
  if (draws_surface()) surface_.upload(surface_mesh(model_, seen, pattern_, values, scale));
}

SolidMesh Renderer::Drawing::solids_of(const State& seen, const PictureSpace& space, const Quantity& values,
                                       const ColourScale& scale) const {
  SolidMesh mesh;
  if (look_.colliders)
    for (const Collider& collider : model_.colliders)
      add_shape(mesh, space.seen(collider.shape), look_.collider_colour);
  if (look_.bones) add_bones(mesh, model_, seen, look_, values, scale);
  if (start_) add_mass_boxes(mesh, model_, space.seen(*start_), seen, look_, radii_.mass, values, scale);
  return mesh;
}

void Renderer::Drawing::load_block(const FrameBlock& block) const {
  gl_.bind_buffer_base(GL_UNIFORM_BUFFER, 0, frame_buffer_.name());
  gl_.buffer_data(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
}

FrameBlock Renderer::Drawing::draw_shadow_map(const Bounds& bounds, const PictureSpace& space) const {
  const FrameBlock block = light_block(bounds, shadow_map_.size(), space.place(fixed_place_));
  load_block(block);
  no_shadow_map_.bind_for_reading();
  shadow_map_.bind();
  gl_.clear(GL_DEPTH_BUFFER_BIT);
  gl_.enable(GL_POLYGON_OFFSET_FILL);
  gl_.polygon_offset(1.5F, 2.0F);
  // The shadow of a dense lattice is all moiré; the cloth's own triangles say the same, cleanly.
  if (draws_surface()) {
    surface_.draw_shadow();
  } else {
    spheres_.draw_shadow();
    links_.draw_shadow();
  }
  if (solids_) solids_->draw_shadow();
  gl_.disable(GL_POLYGON_OFFSET_FILL);
  return block;
}

void Renderer::Drawing::draw_picture(const FrameBlock& block, const CameraPose& pose,
                                     const PictureSpace& space) const {
  load_block(block);
  (casts_shadows() ? shadow_map_ : no_shadow_map_).bind_for_reading();
  target_.bind();
  gl_.clear_colour(0.0F, 0.0F, 0.0F, 0.0F);
  gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (draws_surface()) surface_.draw();
  if (solids_) solids_->draw();
  draw_lattice();
  if (!settings_.transparent) draw_backdrop(block, pose, space);
}

void Renderer::Drawing::draw_lattice() const {
  if (settings_.samples > 1) {
    gl_.enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    // Coverage has then done its work; what is covered is opaque.
    gl_.enable(GL_SAMPLE_ALPHA_TO_ONE);
  }
  spheres_.draw();
  links_.draw();
  gl_.disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  gl_.disable(GL_SAMPLE_ALPHA_TO_ONE);
}

void Renderer::Drawing::draw_backdrop(const FrameBlock& block, const CameraPose& pose,
                                      const PictureSpace& space) const {
  const double period = static_cast<double>(block.fog.z * lines_a_period);
  for (const Ground& ground : drawn_grounds(model_, look_, pose.up)) {
    const GroundPatch patch = ground_patch(ground, space, period);
    // From below there is no ground in the way of the scene.
    if (patch.height > 0.0F) backdrop_.draw_ground(patch);
  }
  const glm::mat3 axes = glm::transpose(glm::mat3(view_matrix(pose, space)));
  const float half_height = 0.5F * block.view.x * static_cast<float>(settings_.size.height);
  const float half_width = 0.5F * block.view.x * static_cast<float>(settings_.size.width);
  backdrop_.draw_sky(axes[0] * half_width, -axes[1] * half_height);
}

Renderer::Renderer(GlContext& context, const Model& model, const State& start, const Look& look,
                   const RenderSettings& settings, const std::filesystem::path& shader_folder)
    : context_(context) {
  const CurrentContext current(context_);
  drawing_ = std::make_unique<Drawing>(context, model, start, look, settings, ShaderLibrary(shader_folder));
}

Renderer::~Renderer() {
  const CurrentContext current(context_);
  drawing_.reset();
}

Image Renderer::draw(const State& state, const CameraPose& pose) {
  const CurrentContext current(context_);
  return drawing_->draw(state, pose);
}

}  // namespace taut
