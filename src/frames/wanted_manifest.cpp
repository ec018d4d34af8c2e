#include "wanted_manifest.h"

#include <fmt/format.h>

#include "base/hash.h"
#include "frames/film_frames.h"
#include "frames/panels.h"
#include "host/build_info.h"
#include "host/versions.h"

namespace taut {
namespace {

// The method's name and settings; of several, all names, and before each setting the number of its panel.
void describe_methods(std::span<const Scene> scenes, Manifest& manifest) {
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Settings& settings = scenes[i].settings;
    manifest.method += (i > 0 ? ", " : "") + settings.method;
    for (const auto& [name, value] : settings.values)
      manifest.settings[scenes.size() == 1 ? name : fmt::format("{}.{}", i + 1, name)] = value;
  }
}

// What pictures and motions have in common.
Manifest common_manifest(std::span<const Scene> scenes, const FrameRate& rate, const std::string& plan) {
  const Scene& scene = scenes.front();
  Manifest manifest;
  manifest.scene = scene.name;
  manifest.scene_toml = resolved_toml(scene);
  manifest.folder = scene.folder;
  describe_methods(scenes, manifest);
  manifest.frames_per_second = rate.value();
  manifest.frame_rate = rate.text();
  manifest.frame_count = film_frame_count(scene, rate);
  manifest.plan = plan;
  manifest.physics = physics_version();
  manifest.build = build_info();
  return manifest;
}

}  // namespace

Manifest frames_manifest(std::span<const Scene> scenes, const RenderRequest& request) {
  Manifest manifest = common_manifest(scenes, request.rate, request.plan);
  manifest.size = sheet_size(request.picture.render.size, scenes.size());
  manifest.bits = request.picture.render.bits;
  manifest.picture = settings_text(request.picture);
  manifest.drawing = drawing_version();
  for (const Scene& other : scenes.subspan(1)) manifest.other_tomls.push_back(resolved_toml(other));
  manifest.inputs = inputs_of(manifest);
  return manifest;
}

std::string motion_inputs(const Scene& scene, const FrameRate& rate) {
  Scene seen_alike = scene;
  seen_alike.camera = {};
  seen_alike.look = {};
  seen_alike.look.speed = scene.look.speed;
  seen_alike.expectation = {};
  Hash hash;
  for (const std::string& part : {resolved_toml(seen_alike), physics_version(), rate.text()})
    hash.add(part).add("\n");
  return hash.hex();
}

Manifest motion_manifest(const Scene& scene, const FrameRate& rate, const std::string& plan) {
  Manifest manifest = common_manifest({&scene, 1}, rate, plan);
  manifest.kind = "motion";
  manifest.size = {0, 0};
  manifest.inputs = motion_inputs(scene, rate);
  return manifest;
}

}  // namespace taut
