#include "output/manifest.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/failure.h"
#include "base/hash.h"
#include "base/json_text.h"
#include "output/atomic_file.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 2;

Json settings_to_json(const Manifest& manifest) {
  Json settings = Json::object();
  for (const auto& [name, value] : manifest.settings)
    std::visit([&, &key = name](const auto& held) { settings[key] = held; }, value);
  return settings;
}

// One of the two hashes of every frame.
Json frames_to_json(const Manifest& manifest, std::string FrameRecord::*part) {
  Json frames = Json::object();
  for (const auto& [number, record] : manifest.frames) frames[fmt::format("{}", number)] = record.*part;
  return frames;
}

Json films_to_json(const std::vector<FilmRecord>& records) {
  Json films = Json::array();
  for (const FilmRecord& film : records)
    films.push_back(
        {{"file", film.file}, {"frames", film.frames}, {"bytes", film.bytes}, {"content", film.content}});
  return films;
}

std::vector<FilmRecord> films_from_json(const Json& json) {
  std::vector<FilmRecord> films;
  films.reserve(json.size());
  for (const Json& film : json)
    films.push_back({film.at("file").get<std::string>(), film.at("frames").get<std::string>(),
                     film.at("bytes").get<std::uintmax_t>(), film.at("content").get<std::string>()});
  return films;
}

Manifest from_json(const Json& json) {
  Manifest manifest;
  manifest.kind = json.at("kind").get<std::string>();
  manifest.inputs = json.at("inputs").get<std::string>();
  manifest.scene = json.at("scene").get<std::string>();
  manifest.scene_toml = json.at("scene_toml").get<std::string>();
  for (const Json& toml : json.at("other_tomls")) manifest.other_tomls.push_back(toml.get<std::string>());
  manifest.folder = json.value("folder", "");
  manifest.method = json.at("method").get<std::string>();
  for (const auto& [name, value] : json.at("settings").items()) {
    if (value.is_number())
      manifest.settings[name] = value.get<double>();
    else
      manifest.settings[name] = value.get<std::string>();
  }
  manifest.plan = json.value("plan", "");
  manifest.halvings = json.value("halvings", "");
  manifest.size = {json.at("width").get<int>(), json.at("height").get<int>()};
  manifest.bits = json.value("bits", 8);
  manifest.frames_per_second = json.at("frames_per_second").get<double>();
  manifest.frame_rate = json.at("frame_rate").get<std::string>();
  manifest.frame_count = json.at("frame_count").get<int>();
  manifest.colour_range = json.at("colour_range").get<double>();
  manifest.picture = json.at("picture").get<std::string>();
  manifest.drawn_by = json.value("drawn_by", "");
  manifest.physics = json.at("physics").get<std::string>();
  manifest.drawing = json.at("drawing").get<std::string>();
  manifest.build = json.at("build").get<std::string>();
  for (const auto& [number, state] : json.at("frames").items())
    manifest.frames[std::stoi(number)] = {state.get<std::string>(),
                                          json.at("contents").at(number).get<std::string>()};
  manifest.films = films_from_json(json.at("films"));
  manifest.metrics = films_from_json(json.value("metrics", Json::array()));
  return manifest;
}

}  // namespace

std::string inputs_of(const Manifest& manifest) {
  if (manifest.kind == "motion") return manifest.inputs;
  // Everything else in the manifest is a part of one of these, follows from them, or decides nothing.
  Hash hash;
  for (const std::string& part : {manifest.scene_toml, manifest.picture, manifest.physics, manifest.drawing,
                                  fmt::format("{} frames/s", manifest.frame_rate)})
    hash.add(part).add("\n");
  for (const std::string& toml : manifest.other_tomls) hash.add(toml).add("\n");
  return hash.hex();
}

std::string manifest_text(const Manifest& manifest) {
  Json json{{"taut_manifest", format_version},
            {"kind", manifest.kind},
            {"inputs", manifest.inputs},
            {"physics", manifest.physics},
            {"drawing", manifest.drawing},
            {"build", manifest.build},
            {"scene", manifest.scene},
            {"method", manifest.method},
            {"settings", settings_to_json(manifest)},
            {"plan", manifest.plan},
            {"halvings", manifest.halvings},
            {"width", manifest.size.width},
            {"height", manifest.size.height},
            {"bits", manifest.bits},
            {"frames_per_second", manifest.frames_per_second},
            {"frame_rate", manifest.frame_rate},
            {"frame_count", manifest.frame_count},
            {"colour_range", manifest.colour_range},
            {"picture", manifest.picture},
            {"drawn_by", manifest.drawn_by},
            {"films", films_to_json(manifest.films)},
            {"metrics", films_to_json(manifest.metrics)},
            {"scene_toml", manifest.scene_toml},
            {"other_tomls", manifest.other_tomls},
            {"frames", frames_to_json(manifest, &FrameRecord::state)},
            {"contents", frames_to_json(manifest, &FrameRecord::content)}};
  if (!manifest.folder.empty()) json["folder"] = manifest.folder;
  constexpr int indent = 1;
  return json_text(json, indent) + "\n";
}

void write_manifest(const std::filesystem::path& file, const Manifest& manifest) {
  write_file(file, manifest_text(manifest));
}

std::optional<Manifest> read_manifest(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    std::ifstream in(file, std::ios::binary);
    const Json json = Json::parse(in);
    if (json.at("taut_manifest").get<int>() != format_version) throw std::invalid_argument("version");
    return from_json(json);
  } catch (const std::exception&) {
    throw OutputConflict(fmt::format("{} is not a manifest that this taut wrote", file.string()));
  }
}

}  // namespace taut
