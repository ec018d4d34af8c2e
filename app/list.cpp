#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/failure.h"
#include "base/nearest.h"
#include "command_line.h"
#include "exit_status.h"
#include "host/scene_folder.h"
#include "host/standard_streams.h"
#include "methods/registry.h"
#include "render/gl_context.h"
#include "scene/scene.h"
#include "verbs.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

struct ListFlags {
  std::string what;
  bool json = false;
};

Json param_to_json(const Param& param) {
  Json json{{"name", param.name}, {"unit", param.unit}};
  if (param.choices.empty()) {
    json["min"] = param.min;
    json["max"] = param.max;
    json["default"] = param.fallback;
    json["whole"] = param.whole;
  } else {
    json["choices"] = param.choices;
    json["default"] = param.choices.front();
  }
  json["help"] = param.help;
  return json;
}

std::string_view name_of(Keeping keeping) {
  switch (keeping) {
    case Keeping::kept:
      return "kept";
    case Keeping::lost_with_step:
      return "lost_with_step";
    case Keeping::within_tolerance:
      return "within_tolerance";
    case Keeping::not_kept:
      break;
  }
  return "not_kept";
}

Json method_to_json(const Method& method) {
  Json params = Json::array();
  for (const Param& param : method.params) params.push_back(param_to_json(param));
  return {{"name", method.name},
          {"title", method.title},
          {"source", method.source},
          {"params", params},
          {"capabilities",
           {{"stiffness", method.can.stiffness},
            {"rigid", method.can.rigid},
            {"ground", method.can.ground},
            {"limits", method.can.limits},
            {"one_sided_links", method.can.one_sided},
            {"bending", method.can.bending},
            {"joints", method.can.joints},
            {"colliders", method.can.colliders},
            {"faces", method.can.faces},
            {"drag", method.can.drag},
            {"break_stretch", method.can.break_stretch},
            {"break_tension", method.can.break_tension},
            {"tension_order", method.can.tension_order}}},
          {"keeps",
           {{"linear_momentum", name_of(method.can.keeps.linear_momentum)},
            {"angular_momentum", name_of(method.can.keeps.angular_momentum)},
            {"energy", name_of(method.can.keeps.energy)}}}};
}

void print_param(const Param& param) {
  if (!param.choices.empty())
    print_result("    {:<18} {} [{}]: {}\n", param.name, fmt::join(param.choices, " | "),
                 param.choices.front(), param.help);
  else
    print_result("    {:<18} {} to {}{}{} [{}]: {}\n", param.name, param.min, param.max,
                 param.unit.empty() ? "" : " ", param.unit, param.fallback, param.help);
}

void list_methods(bool as_json) {
  if (as_json) {
    Json json = Json::array();
    for (const Method& method : all_methods()) json.push_back(method_to_json(method));
    print_result("{}\n", json.dump(2));
    return;
  }
  for (const Method& method : all_methods()) {
    print_result("{}: {}\n    {}\n    {}\n", method.name, method.title, method.source,
                 conservation_text(method.can.keeps));
    for (const Param& param : method.params) print_param(param);
  }
}

Json scene_to_json(const std::filesystem::path& file) {
  Json json{{"name", file.stem().string()}, {"path", file.string()}};
  try {
    const Scene scene = load_scene(file);
    json["title"] = scene.title;
    json["masses"] = scene.model.masses.size();
    json["links"] = scene.model.links.size();
    json["duration"] = scene.duration;
    json["method"] = scene.settings.method;
  } catch (const BadRequest& problem) {
    json["error"] = problem.what();
  }
  return json;
}

void list_scenes(bool as_json) {
  Json scenes = Json::array();
  for (const std::filesystem::path& file : all_scene_files()) scenes.push_back(scene_to_json(file));
  if (as_json) {
    print_result("{}\n", scenes.dump(2));
    return;
  }
  for (const Json& scene : scenes) {
    const std::string name = scene["name"];
    if (scene.contains("error"))
      print_result("{:<26} has errors; `taut check {}` shows them\n", name, scene["path"].get<std::string>());
    else
      print_result("{:<26} {}: {} masses, {} links, {} s\n", name, scene["title"].get<std::string>(),
                   scene["masses"].get<std::size_t>(), scene["links"].get<std::size_t>(),
                   scene["duration"].get<double>());
  }
}

void list_keys(bool as_json) {
  print_result("{}", as_json ? key_reference_json() + "\n" : key_reference());
}

void list_gl(bool as_json) {
  Json json = Json::array();
  for (const GlDevice& device : gl_devices()) {
    json.push_back({{"name", device.name}, {"description", device.description}, {"problem", device.problem}});
    if (!as_json)
      print_result("{:<8} {}\n", device.name, device.problem.empty() ? device.description : device.problem);
  }
  if (as_json) print_result("{}\n", json.dump(2));
}

int list(const ListFlags& flags) {
  constexpr std::array<std::string_view, 4> known{"scenes", "methods", "keys", "gl"};
  if (flags.what == "scenes")
    list_scenes(flags.json);
  else if (flags.what == "methods")
    list_methods(flags.json);
  else if (flags.what == "keys")
    list_keys(flags.json);
  else if (flags.what == "gl")
    list_gl(flags.json);
  else {
    const std::string_view nearest = nearest_name(flags.what, known);
    throw BadRequest(fmt::format("list shows {}, not \"{}\"{}", fmt::join(known, ", "), flags.what,
                                 nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
  }
  return exit_done;
}

}  // namespace

void add_list(CommandLine& program) {
  Verb* verb = program.add_subcommand(
      "list", "What there is: scenes, methods, the keys of a scene file, or ways to draw");
  const auto flags = std::make_shared<ListFlags>();
  verb->add_option("WHAT", flags->what, "scenes, methods, keys or gl")->required();
  verb->add_flag("--json", flags->json, "Print an array of objects as JSON");
  verb->footer("Example:\n  taut list methods --json");
  verb->action([flags] { return list(*flags); });
}

}  // namespace taut
