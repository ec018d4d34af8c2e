#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/failure.h"
#include "base/json_text.h"
#include "choices.h"
#include "command_line.h"
#include "exit_status.h"
#include "host/scene_folder.h"
#include "host/standard_streams.h"
#include "methods/registry.h"
#include "output/export.h"
#include "render/gl_context.h"
#include "scene/scene.h"
#include "verbs.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> listed{"scenes", "methods", "keys", "formats", "gl"};

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
    print_result("{}\n", json_text(json, 2));
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
    print_result("{}\n", json_text(scenes, 2));
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
  if (as_json) print_result("{}\n", json_text(json, 2));
}

std::string_view layout_text(ExportLayout layout) {
  switch (layout) {
    case ExportLayout::one_file:
      return "one file";
    case ExportLayout::file_a_frame:
      return "a file a frame";
    case ExportLayout::folder:
      break;
  }
  return "a folder";
}

void list_formats(bool as_json) {
  Json json = Json::array();
  for (const ExportFormat& format : export_formats()) {
    json.push_back({{"name", format.name},
                    {"ending", format.ending},
                    {"files", layout_text(format.layout)},
                    {"carries", format.carries},
                    {"summary", format.summary},
                    {"tables", format.tables},
                    {"shows_breaks", format.shows_breaks}});
    if (!as_json)
      print_result("{:<5} {}\n      {}: {}{}\n", format.name, format.summary, layout_text(format.layout),
                   format.carries, format.shows_breaks ? "" : "; what breaks doesn't show");
  }
  if (as_json) print_result("{}\n", json_text(json, 2));
}

int list(const ListFlags& flags) {
  if (flags.what == "scenes")
    list_scenes(flags.json);
  else if (flags.what == "methods")
    list_methods(flags.json);
  else if (flags.what == "keys")
    list_keys(flags.json);
  else if (flags.what == "formats")
    list_formats(flags.json);
  else if (flags.what == "gl")
    list_gl(flags.json);
  else
    not_one_of("what list shows", flags.what, listed);
  return exit_done;
}

}  // namespace

void add_list(CommandLine& program) {
  Verb* verb = program.add_subcommand(
      "list", "What there is: scenes, methods, the keys of a scene file, formats to export, or ways to draw");
  const auto flags = std::make_shared<ListFlags>();
  verb->add_option("WHAT", flags->what, "scenes, methods, keys, formats or gl")
      ->one_of(as_words(listed))
      ->required();
  verb->add_flag("--json", flags->json, "Print an array of objects as JSON");
  verb->footer("Example:\n  taut list methods --json");
  verb->action([flags] { return list(*flags); });
}

}  // namespace taut
