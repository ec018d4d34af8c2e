#include "frames/painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>

#include "base/failure.h"
#include "base/hash.h"
#include "base/memory.h"
#include "frames/captions.h"
#include "frames/exact_shape.h"
#include "render/camera.h"

namespace taut {
namespace {

RenderSettings drawn(const PictureSettings& settings) {
  RenderSettings render = settings.render;
  render.size = settings.drawn_size();
  return render;
}

// A size that is so many times as large, for people; encoders want sides to be even.
std::string of_that_shape(Size size, double times) {
  const auto side = [&](int pixels) { return static_cast<int>(0.5 * times * pixels + 1e-9) * 2; };
  return fmt::format("{}x{} of that shape", side(size.width), side(size.height));
}

// Before anything is drawn or written: OpenGL says so only when it is too late.
void check_memory(const RenderSettings& settings) {
  const double bytes = picture_bytes(settings);
  if (bytes < 0.8 * usable_memory()) return;
  throw BadRequest(fmt::format(
      "pictures of {}x{} with {} samples a pixel need about {}, and there are {}; there is room for {}, and "
      "--quality draft needs less",
      settings.size.width, settings.size.height, settings.samples, format_bytes(bytes),
      format_bytes(usable_memory()), of_that_shape(settings.size, std::sqrt(0.8 * usable_memory() / bytes))));
}

// Shaders decide what a picture looks like as much as a scene does.
std::string shaders_text(const std::filesystem::path& folder) {
  if (folder.empty()) return "built in";
  std::error_code error;
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::ifstream in(entry.path(), std::ios::binary);
    contents[entry.path().filename().string()].assign(std::istreambuf_iterator<char>(in), {});
  }
  if (error)
    throw BadRequest(fmt::format("can't read the shader folder {}: {}", folder.string(), error.message()));
  Hash hash;
  for (const auto& [name, text] : contents) hash.add(name).add(text);
  return hash.hex();
}

}  // namespace

void check_size(Size size) {
  constexpr int least = 16, most = 16384;
  const auto fits = [&](int side) { return side >= least && side <= most; };
  if (fits(size.width) && fits(size.height)) return;
  const double largest = std::max(size.width, size.height), smallest = std::min(size.width, size.height);
  const bool has_its_shape = largest > most && smallest * most / largest >= least;
  throw BadRequest(fmt::format(
      "pictures are from {} to {} pixels wide and high; {}x{} is not{}", least, most, size.width, size.height,
      has_its_shape ? fmt::format(", and {} is the largest", of_that_shape(size, most / largest)) : ""));
}

double picture_bytes(const RenderSettings& settings) {
  const double bytes_of_colour = 4.0 * settings.bits / 8.0;
  const double bytes_per_sample = bytes_of_colour + 4.0;  // colour and depth
  const double bytes_per_pixel = 6.0 * bytes_of_colour;  // fetched, laid together, and on their way to a file
  constexpr int most_samples_at_once = 4;
  const double pixels = static_cast<double>(settings.size.width) * settings.size.height;
  return pixels * (bytes_per_sample * std::min(settings.samples, most_samples_at_once) + bytes_per_pixel);
}

Size PictureSettings::drawn_size() const {
  return captions ? Size{render.size.width, render.size.height - caption_height(render.size)} : render.size;
}

std::string settings_text(const PictureSettings& settings) {
  const RenderSettings& render = settings.render;
  return fmt::format("{}x{}{}{}, {} samples, shadows {}, {}, gl {}, shaders {}", render.size.width,
                     render.size.height, settings.captions ? " with captions" : "",
                     render.bits == 16 ? " of 16 bits" : "", render.samples, render.shadow_map_size,
                     render.transparent ? "transparent" : "opaque", settings.gl.name(),
                     shaders_text(settings.shader_folder));
}

struct Painter::Tools {
  std::unique_ptr<GlContext> context;
  GeometryMaker maker;
  Renderer renderer;

  Tools(std::unique_ptr<GlContext> made, const Scene& scene, const PictureSettings& settings)
      : context(std::move(made)),
        maker(scene.model, scene.start, scene.look,
              Sight{camera_pose(scene.camera, scene.model, scene.start, scene.start), settings.drawn_size()},
              exact_shape(scene)),
        renderer(*context, scene.look, drawn(settings), settings.shader_folder) {}
};

Painter::Painter(const Scene& scene, const PictureSettings& settings) : scene_(scene) {
  check_memory(settings.render);
  tools_ = std::make_unique<Tools>(make_gl_context(settings.gl), scene, settings);
}

Painter::~Painter() = default;

std::shared_ptr<const Geometry> Painter::shape(const Pose& pose) {
  const State& state = *pose.state;
  return tools_->maker.make(state, camera_pose(scene_.camera, scene_.model, scene_.start, state),
                            pose.trails);
}

void Painter::submit(const Geometry& geometry) {
  tools_->renderer.submit(geometry);
}

std::shared_ptr<const Layers> Painter::fetch() {
  return tools_->renderer.fetch();
}

Image Painter::draw(const State& state, const Trails* trails, bool with_legend) {
  submit(*shape({&state, trails}));
  return flatten(*fetch(), with_legend);
}

std::string Painter::drawn_by() const {
  return tools_->context->description();
}

}  // namespace taut
