#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace taut {

/// What there is to know about one kind of film.
struct FilmFormat {
  std::string_view ending;  ///< with its dot; also ffmpeg's name of the container, without it
  bool even_sizes = false;  ///< its colours are stored for squares of 2×2 pixels
  bool transparent = false;
  bool streams = false;      ///< can be written into a pipe
  int largest = 0;           ///< pixels a side
  double fastest = 0.0;      ///< frames a second
  bool whole_rates = false;  ///< its clock is too coarse for rates such as 24000/1001
  // ffmpeg's options, with a space between words.
  std::string_view colours;               ///< which colours its numbers stand for
  std::string_view encoder;               ///< how it is encoded
  std::string_view encoder_with_opacity;  ///< the same for transparent films
  std::string_view in_file;               ///< how it is laid out in a file …
  std::string_view in_pipe;               ///< … and in a pipe, where that can be
};

/// Every format, in the order in which messages list them.
std::span<const FilmFormat> film_formats();

/// Where a film goes.
struct FilmTarget {
  std::filesystem::path file;          ///< "-" for standard output
  bool stream = false;                 ///< into a pipe or a device instead of a file of its own
  const FilmFormat* format = nullptr;  ///< null where the name chooses none

  bool is_standard_output() const { return file == "-"; }
};

/// What a name means: its ending chooses the format. What goes into a pipe (which "-" is, and any name of
/// one) may have the format in front, as in "webm:-", and is .mp4 otherwise.
FilmTarget film_target(const std::filesystem::path& name);

}  // namespace taut
