#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <unordered_set>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "base/memory.h"
#include "base/nearest.h"
#include "changes.h"
#include "key_paths.h"
#include "methods/registry.h"
#include "read_files.h"
#include "scene/scene.h"
#include "section.h"
#include "toml_text.h"

namespace taut {
namespace {

// A top-level entry that is no section and no key: say so in the brackets it was written with.
void report_unknown_section(const Entry& entry, const std::vector<Section>& sections, Reader& reader) {
  reader.begin_entry("", 0);
  std::vector<std::string_view> names;
  for (const Section& section : sections)
    if (!section.name.empty()) names.push_back(section.name);
  names.push_back("title");
  const std::string_view nearest = nearest_name(entry.key, names);
  const auto meant = std::ranges::find(sections, nearest, &Section::name);
  std::string hint = did_you_mean(nearest);
  if (!nearest.empty() && meant != sections.end()) hint = "did you mean " + meant->label() + "?";
  if (hint.empty()) hint = reader.home_hint(entry.key);
  const auto* list = entry.node.get<Node::List>();
  const bool tables = list && !list->empty() && list->front().get<Node::Table>();
  const bool section = tables || entry.node.get<Node::Table>();
  if (section)
    reader.unreadable(entry.origin, fmt::format("unknown section {}", in_quotes(entry.key)), hint);
  else
    reader.bad_value(entry.origin, fmt::format("unknown key {}", in_quotes(entry.key)), hint);
}

// Keys of a single method are left out: [solve] has a message of its own for them.
Reader::Homes homes_of(const std::vector<Section>& sections) {
  Reader::Homes homes;
  for (const Section& section : sections)
    if (!section.name.empty())
      for (const KeyInfo& info : section.groups.front().keys) homes.emplace(info.name, section.label());
  return homes;
}

Scene read_document(const Node& document, const std::vector<Section>& sections, Reader& reader) {
  Scene scene;
  for (const Entry& entry : *document.get<Node::Table>()) {
    if (reader.full()) break;
    const std::string name = entry.key == "title" ? "" : entry.key;
    const auto found = std::ranges::find(sections, name, &Section::name);
    if (found == sections.end() || entry.key.empty())
      report_unknown_section(entry, sections, reader);
    else
      found->read(entry.node, scene, reader);
  }
  if (!scene.solve_given) scene.settings = default_settings();
  return scene;
}

// Where a key of an entry was written; where the entry was, when it does not have the key.
Origin origin_of(const Node& document, const Problem& problem) {
  const Entry* section = find_entry(document, problem.section);
  if (!section) return {};
  const auto* list = section->node.get<Node::List>();
  if (list && list->empty()) return section->node.origin;
  const Node* node = list ? &list->at(std::min(problem.index, list->size() - 1)) : &section->node;
  Origin origin = node->origin;
  std::string_view rest = problem.key;
  while (!rest.empty()) {
    const std::size_t dot = std::min(rest.find('.'), rest.size());
    const Entry* entry = find_entry(*node, rest.substr(0, dot));
    if (!entry) break;
    origin = entry->origin;
    node = &entry->node;
    rest.remove_prefix(std::min(dot + 1, rest.size()));
  }
  return origin;
}

void report_problems(const Node& document, const std::vector<Problem>& problems, Reader& reader) {
  for (const Problem& problem : problems)
    if (!reader.follows_from_reported(problem))
      reader.plain(origin_of(document, problem), problem.message, did_you_mean(problem.suggestion));
}

// The line of a note names its place as an error does.
void keep_notes(const Node& document, const std::vector<Problem>& notes, const Reader& reader, Scene& scene) {
  for (const Problem& note : notes) {
    const Diagnostic where = reader.located(origin_of(document, note), "note: " + note.message);
    scene.notes.push_back(one_line(where));
  }
}

void check_camera(const Node& document, const Camera& camera, Reader& reader) {
  const auto nothing = [](const Vec3& way) { return way.norm() < smallest_divisor; };
  if (camera.eye && camera.target && nothing(*camera.eye - *camera.target))
    reader.plain(origin_of(document, {"camera", 0, "eye", {}, {}}),
                 "\"eye\" and \"target\" of [camera] are the same point");
  if (camera.up && nothing(*camera.up))
    reader.plain(origin_of(document, {"camera", 0, "up", {}, {}}), "\"up\" of [camera] must not be zero");
  if (nothing(camera.direction))
    reader.plain(origin_of(document, {"camera", 0, "direction", {}, {}}),
                 "\"direction\" of [camera] must not be zero");
}

void check_look(const Node& document, const Look& look, Reader& reader) {
  const auto report = [&](const std::string& problem) {
    reader.plain(origin_of(document, {"look", 0, "speed", {}, {}}), problem);
  };
  for (std::size_t i = 0; i < look.speed.size(); ++i) {
    const auto& [time, speed] = look.speed[i];
    if (!(speed >= 1e-3 && speed <= 1e3))
      return report("a speed in \"speed\" of [look] must be from 0.001 to 1000, not " + toml_number(speed));
    if (i > 0 && !(time > look.speed[i - 1][0]))
      return report("times in \"speed\" of [look] must rise: " + toml_number(time) + " s comes after " +
                    toml_number(look.speed[i - 1][0]) + " s");
  }
}

using Names = std::vector<std::string>;

void check_follow(const Node& document, const Scene& scene, const Names& names, Reader& reader) {
  const std::string& follow = scene.camera.follow;
  if (follow.empty() || std::ranges::find(names, follow) != names.end()) return;
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  reader.plain(origin_of(document, {"camera", 0, "follow", {}, {}}),
               fmt::format("\"follow\" names no mass: {}", in_quotes(follow)),
               did_you_mean(nearest_name(follow, candidates)));
}

// Every picture on its way to a file has trails of its own.
void check_trail_memory(const Node& document, const Scene& scene, Reader& reader) {
  constexpr double bytes_per_point = 32.0, pictures_on_their_way = 6.0;
  const double seconds =
      scene.look.trail_time > 0.0 ? std::min(scene.look.trail_time, scene.duration) : scene.duration;
  const double bytes = static_cast<double>(scene.look.trails.size()) * seconds * trail_points_a_second *
                       bytes_per_point * pictures_on_their_way;
  if (bytes < 0.8 * usable_memory()) return;
  reader.plain(
      origin_of(document, {"look", 0, "trails", {}, {}}),
      fmt::format("{} trails of {:.4g} s need about {}, and there are {}; a shorter trail_time or fewer "
                  "masses need less",
                  scene.look.trails.size(), seconds, format_bytes(bytes), format_bytes(usable_memory())));
}

void check_trails(const Node& document, const Scene& scene, const Names& names, Reader& reader) {
  constexpr std::size_t enough = 50, most_names = 2'000'000;  // names to compare with, all trails together
  if (scene.look.trails.empty()) return;
  check_trail_memory(document, scene, reader);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  const std::unordered_set<std::string_view> known(names.begin(), names.end());
  for (const std::string& trail : scene.look.trails) {
    if (known.contains(trail)) continue;
    const bool compare = reader.count() < enough && reader.count() * names.size() < most_names;
    reader.plain(origin_of(document, {"look", 0, "trails", {}, {}}),
                 fmt::format("\"trails\" names no mass: {}", in_quotes(trail)),
                 did_you_mean(compare ? nearest_name(trail, candidates) : std::string_view()));
  }
}

// Makes the model; reports what is wrong with the entries as they stand to one another. What needs masses, or
// only their names, is checked where there are some to trust, whatever else is wrong.
void build_scene(const Node& document, Scene& scene, Reader& reader) {
  Built built = reader.masses_readable() ? build(scene.description) : build_names(scene.description);
  report_problems(document, built.problems, reader);
  check_camera(document, scene.camera, reader);
  check_look(document, scene.look, reader);
  if (built.names_known && reader.names_complete()) {
    const Names& names = built.model.masses.name;
    if (names.empty())
      reader.plain({},
                   "the scene has no masses: it needs a [[chain]], a [[sheet]], a [[mesh]] or a [[mass]]");
    check_follow(document, scene, names, reader);
    check_trails(document, scene, names, reader);
  }
  const Method* method = find_method(scene.settings.method);
  if (!built.problems.empty() || !reader.model_readable() || method == nullptr) return;
  scene.model = std::move(built.model);
  scene.start = std::move(built.start);
  keep_notes(document, built.notes, reader, scene);
  if (reader.count() == 0) scene.settings = complete_settings(scene.settings);
  for (const std::string& problem : capability_problems(scene.model, *method))
    reader.plain(origin_of(document, {"solve", 0, "method", {}, {}}), problem);
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file, const SceneOverrides& overrides,
                  const BeforeBuilding& before_building) {
  constexpr std::size_t most_shown = 50;  // errors
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::string_view body = text;
  if (body.starts_with(byte_order_mark)) body.remove_prefix(byte_order_mark.size());
  if (body.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw BadRequest(file + ": the file is empty");

  std::optional<SyntaxError> error;
  Node document = parse_toml(body, error);
  if (error) {
    const Diagnostic syntax{file, error->origin.line, error->origin.column, error->message, {}};
    throw BadScene(to_text(syntax, body), {syntax});
  }

  std::vector<Diagnostic> diagnostics = apply_changes(overrides, document);
  const std::vector<Section> sections = all_sections();
  Reader reader(file, change_names(overrides), homes_of(sections));
  Scene scene = read_document(document, sections, reader);
  std::vector<Problem> file_notes;
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  for (const Problem& problem : read_files(scene.description, folder, file_notes)) {
    if (reader.follows_from_reported(problem)) continue;
    reader.begin_entry(problem.section, problem.index);
    reader.unreadable(origin_of(document, problem), problem.message);
  }
  if (!scene.description.meshes.empty() || !scene.description.points.empty() ||
      !scene.description.mesh_solids.empty())
    scene.folder = std::filesystem::absolute(folder / ".").lexically_normal().string();
  if (before_building && reader.count() == 0) before_building(count(scene.description));
  build_scene(document, scene, reader);
  if (reader.count() == 0) keep_notes(document, file_notes, reader, scene);
  diagnostics.insert(diagnostics.end(), reader.diagnostics().begin(), reader.diagnostics().end());
  if (!diagnostics.empty()) {
    name_keys(document, diagnostics);
    diagnostics = in_order(std::move(diagnostics));
    const std::string shown = to_text(diagnostics, body, most_shown, reader.left_out());
    throw BadScene(shown, std::move(diagnostics));
  }

  scene.name = std::filesystem::path(file).stem().string();
  if (scene.title.empty()) scene.title = scene.name;
  return scene;
}

std::string scene_text(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code code;
  const auto status = std::filesystem::status(file, code);
  if (!std::filesystem::exists(status)) throw BadRequest(name + ": no such file");
  if (std::filesystem::is_directory(status)) throw BadRequest(name + ": a directory, not a scene file");
  std::ifstream stream(file, std::ios::binary);
  std::string text(most_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || (stream.gcount() == 0 && !stream.eof())) throw BadRequest(name + ": can't be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides,
                 const BeforeBuilding& before_building) {
  return parse_scene(scene_text(file), file.string(), overrides, before_building);
}

}  // namespace taut
