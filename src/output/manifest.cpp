#include "output/manifest.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "base/failure.h"
#include "output/atomic_file.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

constexpr int format_version = 1;

Json settings_to_json(const Manifest& manifest) {
  Json settings = Json::object();
  for (const auto& [name, value] : manifest.settings)
    std::visit([&, &key = name](const auto& held) { settings[key] = held; }, value);
  return settings;
}

Json frames_to_json(const Manifest& manifest) {
  Json frames = Json::object();
  for (const auto& [number, hash] : manifest.frames) frames[std::to_string(number)] = hash;
  return frames;
}

Json films_to_json(const Manifest& manifest) {
  Json films = Json::array();
  for (const FilmRecord& film : manifest.films)
    films.push_back({{"file", film.file}, {"frames", film.frames}, {"bytes", film.bytes}});
  return films;
}

Manifest from_json(const Json& json) {
  Manifest manifest;
  manifest.inputs = json.at("inputs").get<std::string>();
  manifest.scene = json.at("scene").get<std::string>();
  manifest.scene_toml = json.at("scene_toml").get<std::string>();
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
  manifest.frames_per_second = json.at("frames_per_second").get<double>();
  manifest.picture = json.at("picture").get<std::string>();
  manifest.drawn_by = json.value("drawn_by", "");
  manifest.build = json.at("build").get<std::string>();
  for (const auto& [number, hash] : json.at("frames").items())
    manifest.frames[std::stoi(number)] = hash.get<std::string>();
  for (const Json& film : json.at("films"))
    manifest.films.push_back({film.at("file").get<std::string>(), film.at("frames").get<std::string>(),
                              film.at("bytes").get<std::uintmax_t>()});
  return manifest;
}

}  // namespace

std::string manifest_text(const Manifest& manifest) {
  const Json json{{"taut_manifest", format_version},
                  {"inputs", manifest.inputs},
                  {"build", manifest.build},
                  {"scene", manifest.scene},
                  {"method", manifest.method},
                  {"settings", settings_to_json(manifest)},
                  {"plan", manifest.plan},
                  {"halvings", manifest.halvings},
                  {"width", manifest.size.width},
                  {"height", manifest.size.height},
                  {"frames_per_second", manifest.frames_per_second},
                  {"picture", manifest.picture},
                  {"drawn_by", manifest.drawn_by},
                  {"films", films_to_json(manifest)},
                  {"scene_toml", manifest.scene_toml},
                  {"frames", frames_to_json(manifest)}};
  constexpr int indent = 1;
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
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
