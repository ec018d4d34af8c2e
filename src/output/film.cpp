#include "output/film.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.h"
#include "film_check.h"
#include "film_format.h"

namespace taut {
namespace {

// The endings of formats, as ".mp4, .webm and .gif".
template <class Which>
std::string endings(std::string_view last_joined_by, const Which& which) {
  std::vector<std::string_view> names;
  for (const FilmFormat& format : film_formats())
    if (which(format)) names.push_back(format.ending);
  const std::string_view last = names.back();
  names.pop_back();
  return fmt::format("{} {} {}", fmt::join(names, ", "), last_joined_by, last);
}

// Rates that a coarse clock can't keep: it takes so long till frames and seconds meet, and a frame is short.
bool is_broken_rate(const FrameRate& rate) {
  constexpr std::int64_t longest = 60;  // s
  return rate.seconds > longest && rate.value() > 1.0;
}

void check_film_rate(const FilmFormat& format, const FrameRate& rate) {
  if (rate.value() > format.fastest)
    throw BadRequest(fmt::format("{} films show at most {} frames a second, not {}; --fps {} does",
                                 format.ending, format.fastest, rate.text(), format.fastest));
  if (format.whole_rates && is_broken_rate(rate))
    throw BadRequest(fmt::format(
        "{} films can't keep {} frames a second, their clock is too coarse; {} can, or --fps {:.0f}",
        format.ending, rate.text(),
        endings("and", [](const FilmFormat& other) { return !other.whole_rates; }), rate.value()));
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

// What ffmpeg calls the pixels it is fed.
std::string_view pixel_format(const FilmSettings& settings) {
  constexpr bool low_first = std::endian::native == std::endian::little;
  if (settings.bits == 16 && settings.transparent) return low_first ? "rgba64le" : "rgba64be";
  if (settings.bits == 16) return low_first ? "rgb48le" : "rgb48be";
  return settings.transparent ? "rgba" : "rgb24";
}

// `to` is what ffmpeg writes into: a file, or "pipe:1".
std::vector<std::string> encoder_arguments(const FilmSettings& settings, const FilmTarget& target,
                                           const std::string& to) {
  const FilmFormat& format = *target.format;
  std::vector<std::string> arguments{"-hide_banner", "-nostats", "-loglevel", "error", "-y"};
  const auto add = [&](auto... words) { (arguments.emplace_back(words), ...); };
  add("-f", "rawvideo", "-pixel_format", pixel_format(settings));
  add("-video_size", fmt::format("{}x{}", settings.size.width, settings.size.height));
  add("-framerate", settings.rate.text(), "-i", "pipe:0", "-an");
  add_words(arguments, format.colours);
  if (settings.threads > 0) add("-threads", fmt::format("{}", settings.threads));
  add_words(arguments, settings.transparent ? format.encoder_with_opacity : format.encoder);
  add_words(arguments, target.stream ? format.in_pipe : format.in_file);
  // What went into a pipe can't be looked at afterwards, so nothing may be passed over.
  if (target.stream) add("-xerror");
  // The name is no help to ffmpeg: it is a temporary one, or none.
  add("-f", format.ending.substr(1), to);
  return arguments;
}

const FilmSettings& checked(const FilmSettings& settings) {
  check_film_settings(settings);
  return settings;
}

}  // namespace

void check_film_settings(const FilmSettings& settings) {
  const auto [file, stream, format] = film_target(settings.file);
  if (format == nullptr)
    throw BadRequest(fmt::format("a film's name has to end in {}; \"{}\" does not",
                                 endings("or", [](const FilmFormat&) { return true; }),
                                 settings.file.string()));
  if (settings.transparent && !format->transparent)
    throw BadRequest(fmt::format("{} films can't be transparent; {} can", format->ending,
                                 endings("and", [](const FilmFormat& other) { return other.transparent; })));
  if (stream && !format->streams)
    throw BadRequest(fmt::format("{} films can't be written into a pipe; {} can", format->ending,
                                 endings("and", [](const FilmFormat& other) { return other.streams; })));
  check_film_rate(*format, settings.rate);
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

bool is_film_stream(const std::filesystem::path& name) {
  return film_target(name).stream;
}

bool goes_to_standard_output(const std::filesystem::path& name) {
  return film_target(name).is_standard_output();
}

Film::Film(const FilmSettings& settings) : name_(checked(settings).file) {
  const FilmTarget target = film_target(settings.file);
  ending_ = target.format->ending;
  if (!target.stream) {
    sweep_leftovers(target.file.parent_path());
    file_.emplace(target.file);
  }
  const std::string to =
      target.is_standard_output()
          ? "pipe:1"
          : fmt::format("file:{}", (file_ ? file_->temporary_name() : target.file).string());
  encoder_.emplace(encoder_program(), encoder_arguments(settings, target, to),
                   target.is_standard_output() ? ChildOutput::ours : ChildOutput::nowhere);
}

void Film::add(const Image& frame, const StopTest& stop) {
  if (!encoder_->feed(std::as_bytes(std::span(frame.pixels)), stop)) {
    const ProcessEnd end = encoder_->finish(stop);
    fail(end_text(end), end);
  }
  ++frames_;
}

double Film::finish(const StopTest& stop) {
  const ProcessEnd end = encoder_->finish(stop);
  if (end.status != 0) fail(end_text(end), end);
  if (!file_) return end.processor_seconds;
  // On a full disk it ends with status 0, too.
  if (const std::string problem = film_problem(file_->temporary_name(), ending_, frames_); !problem.empty())
    fail(problem, end);
  return end.processor_seconds;
}

std::filesystem::path Film::file() const {
  return file_ ? file_->temporary_name() : std::filesystem::path();
}

void Film::commit() {
  if (file_) file_->commit();
}

void Film::fail(std::string_view how, const ProcessEnd& end) const {
  throw RunFailure(fmt::format("ffmpeg could not make {}: {}{}{}", name_.string(), how,
                               end.last_lines.empty() ? "" : "; its last words:\n", end.last_lines));
}

}  // namespace taut
