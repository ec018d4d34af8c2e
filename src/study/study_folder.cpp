#include "study/study_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/failure.h"
#include "base/json_text.h"
#include "host/build_info.h"
#include "host/versions.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"

namespace taut {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int contents_version = 1;

std::string contents_text(const StudyContents& contents) {
  Json files = Json::object();
  for (const auto& [name, file] : contents.files)
    files[name] = {{"bytes", file.bytes}, {"content", file.content}};
  const Json json{{"taut_contents", contents_version}, {"kind", contents.kind},
                  {"build", contents.build},           {"physics", contents.physics},
                  {"judging", contents.judging},       {"open", contents.open},
                  {"files", std::move(files)}};
  return json_text(json, 1) + "\n";
}

}  // namespace

StudyContents read_study_contents(const fs::path& file) {
  try {
    std::ifstream in(file, std::ios::binary);
    const Json json = Json::parse(in);
    if (json.at("taut_contents").get<int>() != contents_version) throw std::invalid_argument("version");
    StudyContents contents{json.at("kind").get<std::string>(),
                           json.at("build").get<std::string>(),
                           json.at("physics").get<std::string>(),
                           json.at("judging").get<std::string>(),
                           json.at("open").get<std::map<std::string, std::string>>(),
                           {}};
    for (const auto& [name, entry] : json.at("files").items())
      contents.files[name] = {entry.at("bytes").get<std::uintmax_t>(),
                              entry.at("content").get<std::string>()};
    return contents;
  } catch (const std::exception&) {
    throw OutputConflict(fmt::format("{} is no list of a study's files that this taut wrote", file.string()));
  }
}

StudyFolder::StudyFolder(fs::path folder, std::string_view kind)
    : folder_(std::move(folder)), contents_{std::string(kind), build_info(), physics_version(),
                                            judging_version(), {},           {}} {
  make_folder(folder_);
  std::error_code error;
  if (!fs::exists(folder_ / study_contents_name, error)) return;
  try {
    StudyContents there = read_study_contents(folder_ / study_contents_name);
    contents_.files = std::move(there.files);
    contents_.open = std::move(there.open);
  } catch (const OutputConflict&) {
    // What is damaged is made anew.
  }
}

void StudyFolder::write(const std::string& name, std::string_view text) {
  write_file(folder_ / name, text);
  contents_.files[name] = {text.size(), content_hash_of(text)};
}

void StudyFolder::write(const std::string& name, std::span<const std::uint8_t> bytes) {
  write(name, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

void StudyFolder::draw(const std::string& stem, const PlotScript& plot, const StopTest& stop) {
  write_plot(plot, folder_ / stem, stop);
  for (const char* ending : {".png", ".svg"}) know(stem + ending);
}

void StudyFolder::know(const std::string& name) {
  if (const std::optional<std::string> content = content_hash(folder_ / name))
    contents_.files[name] = {size_of_file(folder_ / name), *content};
}

void StudyFolder::finish(const std::string& which, const std::string& open) {
  contents_.open.erase(which);
  if (!open.empty()) contents_.open[which] = open;
  write_file(folder_ / study_contents_name, contents_text(contents_));
}

}  // namespace taut
