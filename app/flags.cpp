#include "flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "choices.h"
#include "estimate.h"
#include "frames/film_time.h"
#include "host/patience.h"
#include "host/scene_folder.h"
#include "host/standard_streams.h"
#include "usage.h"
#include "values.h"

namespace taut {
namespace {

constexpr std::array<std::pair<std::string_view, ColourBy>, 5> colourings{{
    {"plain", ColourBy::plain},
    {"strain", ColourBy::strain},
    {"tension", ColourBy::tension},
    {"speed", ColourBy::speed},
    {"limit", ColourBy::limit},
}};

constexpr std::array<std::string_view, 3> quality_names{"draft", "standard", "fine"};
constexpr std::array<std::string_view, 4> gl_names{"auto", "osmesa", "egl", "egl:0"};

std::vector<std::string_view> colouring_names() {
  std::vector<std::string_view> names;
  names.reserve(colourings.size());
  for (const auto& [name, colouring] : colourings) names.push_back(name);
  return names;
}

Quality parse_quality(const std::string& text) {
  if (text.empty()) return Quality::standard;
  if (const auto quality = quality_named(text)) return *quality;
  not_one_of("--quality", text, quality_names);
}

GlChoice parse_gl(const std::string& text) {
  if (const auto choice = gl_choice_named(text)) return *choice;
  not_one_of("--gl", text, gl_names);
}

}  // namespace

void SceneFlags::add_to(Verb& verb, const std::string& optional) {
  Flag* argument = verb.add_option("SCENE", scene,
                                   "A scene file, or the bare name of one of `taut list scenes`" + optional);
  argument->names_a(ValueKind::scene);
  if (optional.empty()) argument->required();
  add_changes_to(verb);
}

void SceneFlags::add_changes_to(Verb& verb) {
  verb.add_option("--method", method, "Simulate with this method, one of `taut list methods`")
      ->names_a(ValueKind::method);
  add_sets(verb, sets);
}

void add_sets(Verb& verb, std::vector<std::string>& sets, std::string_view of) {
  verb.add_option("--set", sets, fmt::format("Change a key of {}: key=value, any number of times", of))
      ->one_each("KEY=VALUE")
      ->names_a(ValueKind::change);
}

void SceneFlags::add_threads_to(Verb& verb) {
  verb.add_option(
      "--threads", threads,
      "Step large scenes on so many threads, which changes no result [as many as there are cores, but "
      "for what draws or certifies beside]");
}

int SceneFlags::thread_count(int busy) const {
  constexpr int most = 256;
  double count = static_cast<double>(std::thread::hardware_concurrency()) - busy;
  if (!threads.empty()) {
    count = parse_number("--threads", threads);
    if (count < 1.0 || count > most || count != std::floor(count))
      throw BadRequest(fmt::format("--threads is a whole number from 1 to {}, not {}", most, threads));
  }
  return static_cast<int>(std::clamp<double>(count, 1, most));
}

Execution on_threads(int count) {
  if (count < 2) return {};
  return {std::make_shared<Workers>(count)};
}

SceneOverrides SceneFlags::overrides() const {
  return {sets, method.empty() ? std::nullopt : std::optional(method)};
}

void add_shard(Verb& verb, std::string& shard, const std::string& afterwards) {
  verb.add_option(
      "--shard", shard,
      fmt::format("Only part i of n: i/n [SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT]; {}", afterwards));
}

Shard chosen_shard(const std::string& text) {
  return text.empty() ? shard_of_this_task() : parse_shard(text);
}

Scene load(const std::string& argument, const SceneOverrides& overrides, bool quiet) {
  std::error_code error;
  if (argument.find('=') != std::string::npos && !std::filesystem::exists(argument, error))
    throw BadRequest(fmt::format("there is no scene {}; {}", in_quotes(argument), set_hint(argument)));
  const std::filesystem::path file = find_scene(argument);
  const Patience patience(stderr, quiet, fmt::format("building {}", file.string()));
  return load_scene(file, overrides, [&](const Counts& counts) {
    if (const std::string note = size_note(counts); !quiet && !note.empty())
      tell("taut: {}: note: {}\n", file.string(), note);
  });
}

void print_notes(const Scene& scene, bool quiet) {
  if (quiet) return;
  for (const std::string& note : scene.notes) tell("taut: {}\n", note);
}

void add_metrics(Verb& verb, std::string& file) {
  verb.add_option(
          "--metrics", file,
          "Also write what is measured of every frame, energies, strain, sag, breaks, speed and what "
          "each stage took: as .csv, or .jsonl; taut plot draws it; a shard adds its part to the name")
      ->names_a(ValueKind::file);
}

void add_slow(Verb& verb, std::string& slow) {
  verb.add_option("--slow", slow,
                  "Slow motion: a film so many times as long, of so many times as many moments, such as 4");
}

void apply_slow(const std::string& slow, Scene& scene) {
  if (slow.empty()) return;
  const double times = parse_number("--slow", slow);
  if (!(times >= 1e-3 && times <= 1e3))
    throw BadRequest(fmt::format("--slow takes from 0.001 to 1000, not {}", slow));
  slow_down(scene.look, times);
}

void PictureFlags::add_to(Verb& verb) {
  verb.add_option("--size", size, "Width and height in pixels, such as 1280x720, instead of the quality's");
  verb.add_option(
          "--quality", quality,
          "draft (640x360, jagged, no shadows), standard (1280x720) or fine (1920x1080, twice the samples)")
      ->one_of(as_words(quality_names));
  verb.add_option("--color,--colour", colour,
                  "Colour by plain, strain, tension, speed or limit instead of as the scene says")
      ->one_of(as_words(colouring_names()));
  verb.add_flag("--transparent", transparent,
                "Nothing behind the scene: PNG with alpha, and film as .mov, .webm or .webp");
  verb.add_flag("--captions,!--no-captions", captions,
                fmt::format("Below each picture, as a part of its size: title, time, method, figures [{}]",
                            captions ? "on" : "off"));
  verb.add_option(
          "--gl", gl,
          "How to get OpenGL without a display: osmesa, egl, egl:N (a device of `taut list gl`) or auto")
      ->one_of(as_words(gl_names))
      ->capture_default_str();
  verb.add_option("--shaders", shader_folder,
                  "Draw with the shaders of this folder instead of the built-in ones")
      ->names_a(ValueKind::folder);
}

PictureSettings PictureFlags::settings(std::optional<Size> usual) const {
  PictureSettings settings;
  std::optional<Size> wanted = quality.empty() ? usual : std::nullopt;
  if (!size.empty()) wanted = parse_size("--size", size);
  if (wanted) check_size(*wanted);
  settings.render = render_settings_for(parse_quality(quality), wanted);
  settings.render.transparent = transparent;
  settings.captions = captions;
  settings.gl = parse_gl(gl);
  settings.shader_folder = shader_folder;
  return settings;
}

void PictureFlags::apply_to(Scene& scene) const {
  if (colour.empty()) return;
  for (const auto& [name, colouring] : colourings) {
    if (name != colour) continue;
    scene.look.colour_by = colouring;
    return;
  }
  not_one_of("--color", colour, colouring_names());
}

}  // namespace taut
