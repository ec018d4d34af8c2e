#include "output/film.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.h"
#include "film_format.h"

namespace taut {
namespace {

std::string endings() {
  std::vector<std::string_view> names;
  for (const FilmFormat& format : film_formats()) names.push_back(format.ending);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::filesystem::path encoder_program() {
  if (auto program = find_program("ffmpeg")) return *program;
  throw RunFailure(
      "a film needs the program ffmpeg, which is not on the PATH; on Debian: apt-get install ffmpeg");
}

void add_words(std::vector<std::string>& words, std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::vector<std::string> encoder_arguments(const FilmSettings& settings, const std::filesystem::path& to) {
  const FilmFormat& format = *find_film_format(settings.file);
  std::vector<std::string> arguments{"-hide_banner", "-nostats", "-loglevel", "error", "-y"};
  const auto add = [&](auto... words) { (arguments.emplace_back(words), ...); };
  add("-f", "rawvideo", "-pixel_format", settings.transparent ? "rgba" : "rgb24");
  add("-video_size", fmt::format("{}x{}", settings.size.width, settings.size.height));
  add("-framerate", fmt::format("{}", settings.frames_per_second), "-i", "pipe:0", "-an");
  add_words(arguments, format.colours);
  add_words(arguments, settings.transparent ? format.encoder_with_opacity : format.encoder);
  // The name is no help to ffmpeg: it is a temporary one.
  add("-f", format.ending.substr(1), fmt::format("file:{}", to.string()));
  return arguments;
}

const FilmSettings& checked(const FilmSettings& settings) {
  check_film_settings(settings);
  return settings;
}

}  // namespace

void check_film_settings(const FilmSettings& settings) {
  const FilmFormat* format = find_film_format(settings.file);
  if (format == nullptr)
    throw BadRequest(fmt::format("a film's name has to end in one of {}; \"{}\" does not", endings(),
                                 settings.file.string()));
  if (settings.transparent && !format->transparent)
    throw BadRequest(fmt::format("{} films can't be transparent; .webm and .webp can", format->ending));
  const auto [width, height] = settings.size;
  if (format->even_sizes && (width % 2 != 0 || height % 2 != 0))
    throw BadRequest(
        fmt::format("{} films store colour for squares of 2×2 pixels, so width and height have to be "
                    "even: {}x{} instead of {}x{}",
                    format->ending, width + width % 2, height + height % 2, width, height));
  if (width > format->largest || height > format->largest)
    throw BadRequest(fmt::format("{} films are at most {} pixels a side", format->ending, format->largest));
}

void require_film_encoder() {
  encoder_program();
}

Film::Film(const FilmSettings& settings)
    : file_(checked(settings).file),
      encoder_(encoder_program(), encoder_arguments(settings, file_.temporary_name())) {}

void Film::add(const Image& frame, const StopTest& stop) {
  if (!encoder_.feed(std::as_bytes(std::span(frame.pixels)), stop)) fail(encoder_.finish());
}

void Film::finish(const StopTest& stop) {
  const ProcessEnd end = encoder_.finish(stop);
  if (end.status != 0) fail(end);
  file_.commit();
}

void Film::fail(const ProcessEnd& end) const {
  throw RunFailure(fmt::format("ffmpeg could not make {} (its exit status was {}){}{}",
                               file_.final_name().string(), end.status,
                               end.last_lines.empty() ? "" : "; its last words:\n", end.last_lines));
}

}  // namespace taut
