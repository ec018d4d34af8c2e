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
  int largest = 0;  ///< pixels a side
  // ffmpeg's options, with a space between words.
  std::string_view colours;               ///< which colours its numbers stand for
  std::string_view encoder;               ///< how it is encoded
  std::string_view encoder_with_opacity;  ///< the same for transparent films
};

/// Every format, in the order in which messages list them.
std::span<const FilmFormat> film_formats();

/// The format that a file's ending chooses, or nullptr.
const FilmFormat* find_film_format(const std::filesystem::path& file);

}  // namespace taut
