#include <fmt/format.h>

#include <charconv>

#include "section.h"

namespace taut {
namespace {

// A share as a percentage in text: "1%".
struct Accuracy {
  std::string text = Scene{}.accuracy;
};

bool is_percentage(std::string_view text) {
  if (!text.ends_with('%')) return false;
  text.remove_suffix(1);
  double percent = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), percent);
  return error == std::errc{} && end == text.data() + text.size() && percent > 0.0 && percent <= 100.0;
}

}  // namespace

template <>
struct Codec<Accuracy> {
  static std::string type() { return "text such as \"1%\""; }
  static bool read(const Node& node, const KeyInfo& info, Accuracy& out, Reader& reader) {
    const auto* text = node.get<std::string>();
    if (!text || !is_percentage(*text)) {
      reader.unreadable(node.origin, fmt::format("{} must be a text from above \"0%\" to \"100%\", not {}",
                                                 in_quotes(info.name), describe(node)));
      return false;
    }
    out.text = *text;
    return true;
  }
  static std::string write(const Accuracy& value) { return toml_string(value.text); }
};

namespace {

// What [world] holds, which is spread over a Scene.
struct World {
  Vec3 gravity = Description{}.gravity;
  double drag = Description{}.drag;
  double duration = Scene{}.duration;
  Accuracy accuracy;
};

Keys<World> world_keys() {
  return {
      key<World>("gravity", &World::gravity,
                 {.unit = "m/s²", .range = between(-1e6, 1e6), .help = "acceleration of every free mass"}),
      key<World>("duration", &World::duration,
                 {.unit = "s", .range = above_to(0, 3600), .help = "of the run, and of its film"}),
      key<World>("drag", &World::drag,
                 {.unit = "1/s",
                  .range = between(0, 1e6),
                  .help = "force −drag · mass · velocity, which lets a scene come to rest"}),
      key<World>("accuracy", &World::accuracy,
                 {.unit = "of the scene's size", .range = {}, .help = "wanted, where [solve] is left out"}),
  };
}

}  // namespace

Section world_section() {
  Section section{"world", false, "What holds everywhere. SI units.", {{"", infos(world_keys())}}, {}, {}};
  const std::string label = section.label();
  section.read = [label](const Node& node, Scene& scene, Reader& reader) {
    reader.begin_entry("world", 0);
    World world;
    read_table(node, world_keys(), label, TableKind::entry, world, reader);
    scene.description.gravity = world.gravity;
    scene.description.drag = world.drag;
    scene.duration = world.duration;
    scene.accuracy = world.accuracy.text;
  };
  section.write = [label](const Scene& scene) {
    return label + "\n" +
           write_lines(
               world_keys(),
               World{scene.description.gravity, scene.description.drag, scene.duration, {scene.accuracy}});
  };
  return section;
}

Section title_section() {
  const Keys<Scene> keys{
      key<Scene>("title", &Scene::title, {.fallback = "the file's name", .help = "one line, for people"})};
  Section section{"", false, "Above the first section.", {{"", infos(keys)}}, {}, {}};
  section.read = [keys](const Node& node, Scene& scene, Reader& reader) {
    reader.begin_entry("", 0);
    keys.front().read(node, keys.front().info, scene, reader);
  };
  section.write = [keys](const Scene& scene) { return write_lines(keys, scene); };
  return section;
}

}  // namespace taut
