#include "backdrop.h"

#include "geometry/picture_space.h"
#include "geometry/view_matrices.h"
#include "layers.h"
#include "patch_uniforms.h"

namespace taut {
namespace {

// Fragments work out how lines and mist blend, so one sample a pixel does.
constexpr int samples = 1;

}  // namespace

Backdrop::Backdrop(const Gl& gl, const ShaderLibrary& library, Size size, bool cut_out, int bits)
    : gl_(&gl),
      library_(&library),
      size_(size),
      cut_out_(cut_out),
      ground_depth_(gl, library, "ground.vert", "nothing.frag"),
      sky_(gl, library, "sky.vert", "sky.frag"),
      no_attributes_(make_vertex_array(gl)),
      target_(gl, size, samples, bits) {}

const std::shared_ptr<const Image>& LitBackdrop::image() {
  if (drawn_) {
    const Image drawn = drawn_->fetch();
    Image image = Image::blank(drawn.size, 3, drawn.bits);
    lay_over(image, 0, 0, drawn);
    image_ = std::make_shared<const Image>(std::move(image));
    drawn_.reset();
  }
  return image_;
}

std::shared_ptr<LitBackdrop> Backdrop::lit(const Geometry& geometry, const FrameBlock& block) {
  if (kept_ && kept_->shows(geometry)) return kept_;
  target_.begin({0, 0, size_.width, size_.height});
  for (const GroundPatch& patch : geometry.grounds) {
    ground(patch, false).use();
    draw(ground(patch, false), patch);
  }
  draw_sky(geometry, block);
  kept_ = std::make_shared<LitBackdrop>(geometry, target_.end());
  return kept_;
}

Readback Backdrop::shaded(const Geometry& geometry, const Region& region, const GroundShades& shades) {
  target_.begin(region);
  for (std::size_t i = 0; i < geometry.grounds.size(); ++i) {
    const GroundPatch& patch = geometry.grounds[i];
    const bool shaded = takes_shadows(patch);
    const Program& program = ground(patch, shaded);
    program.use();
    if (shaded) shades.bind(program, i);
    draw(program, patch);
  }
  return target_.end();
}

void Backdrop::draw_depth(const Geometry& geometry) const {
  gl_->colour_mask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  ground_depth_.use();
  for (const GroundPatch& patch : geometry.grounds) draw(ground_depth_, patch);
  gl_->colour_mask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

const Program& Backdrop::ground(const GroundPatch& patch, bool shadows) {
  const bool solid = patch.solid, tinted = patch.colour.has_value();
  std::optional<Program>& program = grounds_.at((solid ? 1 : 0) + (shadows ? 2 : 0) + (tinted ? 4 : 0));
  if (!program) {
    Defines defines;
    if (solid) defines.emplace_back("SOLID");
    if (shadows) defines.emplace_back("SHADOWS");
    if (tinted) defines.emplace_back("TINTED");
    if (cut_out_) defines.emplace_back("CUT_OUT");
    program.emplace(*gl_, *library_, "ground.vert", "ground.frag", defines);
  }
  return *program;
}

void Backdrop::draw(const Program& program, const GroundPatch& patch) const {
  set_patch(program, patch);
  if (patch.colour)
    program.set("tint", glm::vec3((*patch.colour)[0], (*patch.colour)[1], (*patch.colour)[2]));
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Backdrop::draw_sky(const Geometry& geometry, const FrameBlock& block) const {
  const glm::mat3 axes = glm::transpose(glm::mat3(view_matrix(geometry.pose, PictureSpace(geometry.pose))));
  const float half_height = 0.5F * block.view.x * static_cast<float>(size_.height);
  const float half_width = 0.5F * block.view.x * static_cast<float>(size_.width);
  sky_.use();
  sky_.set("right", axes[0] * half_width);
  sky_.set("down", -axes[1] * half_height);
  gl_->bind_vertex_array(no_attributes_.name());
  gl_->draw_arrays(GL_TRIANGLES, 0, 3);
}

}  // namespace taut
