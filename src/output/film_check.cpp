#include "film_check.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "base/failure.h"
#include "output/atomic_file.h"

namespace taut {
namespace {

// Why something is no whole film.
class NotWhole : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void cut() {
  throw NotWhole("it is cut short");
}

[[noreturn]] void unfinished() {
  throw NotWhole("it was never finished");
}

// The bytes of a file, of which a window is in memory. What lies behind its end is a cut.
class FilmBytes {
 public:
  explicit FilmBytes(const std::filesystem::path& file) : file_(file), size_(size_of_file(file)) {
    descriptor_ = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) cannot_read(errno);
  }
  ~FilmBytes() { ::close(descriptor_); }
  FilmBytes(const FilmBytes&) = delete;
  FilmBytes& operator=(const FilmBytes&) = delete;

  std::uint64_t size() const { return size_; }

  std::uint8_t at(std::uint64_t place) {
    if (place >= size_) cut();
    if (place < begin_ || place - begin_ >= window_.size()) read_window(place);
    return window_[place - begin_];
  }
  // A number of that many bytes, the highest or the lowest first.
  std::uint64_t high_first(std::uint64_t place, std::uint64_t bytes) {
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < bytes; ++i) value = value << 8U | at(place + i);
    return value;
  }
  std::uint64_t low_first(std::uint64_t place, std::uint64_t bytes) {
    std::uint64_t value = 0;
    for (std::uint64_t i = bytes; i > 0; --i) value = value << 8U | at(place + i - 1);
    return value;
  }
  bool has(std::uint64_t place, std::string_view text) {
    for (const char c : text)
      if (at(place++) != static_cast<std::uint8_t>(c)) return false;
    return true;
  }

 private:
  [[noreturn]] void cannot_read(int error) const {
    throw RunFailure(
        fmt::format("can't read {}: {}", file_.string(), std::generic_category().message(error)));
  }
  void read_window(std::uint64_t place) {
    constexpr std::size_t length = 1U << 16U;
    window_.resize(length);
    ssize_t count = 0;
    while ((count = ::pread(descriptor_, window_.data(), length, static_cast<off_t>(place))) < 0 &&
           errno == EINTR) {
    }
    if (count < 0) cannot_read(errno);
    if (count == 0) cut();
    window_.resize(static_cast<std::size_t>(count));
    begin_ = place;
  }

  std::filesystem::path file_;
  std::uint64_t size_ = 0, begin_ = 0;
  int descriptor_ = -1;
  std::vector<std::uint8_t> window_;
};

// A stretch of a file.
struct Extent {
  std::uint64_t begin = 0, end = 0;
};

// Inside `outer`, or cut.
Extent inside(const Extent& outer, std::uint64_t begin, std::uint64_t length) {
  if (begin > outer.end || length > outer.end - begin) cut();
  return {begin, begin + length};
}

// --- MP4 and MOV: boxes of a length and a name, which may hold boxes.

struct AtomBox {
  std::uint64_t name = 0;
  Extent content, whole;
};

// Four letters, as a number.
constexpr std::uint64_t box_name(std::string_view name) {
  std::uint64_t value = 0;
  for (const char c : name) value = value << 8U | static_cast<std::uint8_t>(c);
  return value;
}

AtomBox box_at(FilmBytes& film, const Extent& outer, std::uint64_t at) {
  std::uint64_t head = 8, length = film.high_first(at, 4);
  if (length == 1) {
    head = 16;
    length = film.high_first(at + 8, 8);
  }
  if (length == 0) unfinished();
  if (length < head) throw NotWhole("it is no MP4 or MOV film");
  const Extent whole = inside(outer, at, length);
  return {film.high_first(at + 4, 4), {at + head, whole.end}, whole};
}

// The first box of that name.
Extent box_in(FilmBytes& film, const Extent& outer, std::uint64_t name) {
  for (std::uint64_t at = outer.begin; at < outer.end;) {
    const AtomBox box = box_at(film, outer, at);
    if (box.name == name) return box.content;
    at = box.whole.end;
  }
  unfinished();
}

std::size_t frames_of_mp4(FilmBytes& film) {
  const Extent all{0, film.size()};
  if (!film.has(4, "ftyp")) throw NotWhole("it is no MP4 or MOV film");
  // To the last box, wherever the index lies.
  for (std::uint64_t at = 0; at < all.end;) at = box_at(film, all, at).whole.end;
  box_in(film, all, box_name("mdat"));
  Extent index = box_in(film, all, box_name("moov"));
  for (const std::string_view name : {"trak", "mdia", "minf", "stbl", "stsz"})
    index = box_in(film, index, box_name(name));
  return film.high_first(index.begin + 8, 4);  // after flags, and the size of all where they are alike
}

// --- WebM: elements of an identifier, a length and content, both numbers as long as their first byte says.

struct Element {
  std::uint64_t identifier = 0;
  Extent content;
};

constexpr std::uint64_t ebml = 0x1A45DFA3, segment = 0x18538067, cluster = 0x1F43B675, cues = 0x1C53BB6B,
                        simple_block = 0xA3, block_group = 0xA0;

std::uint64_t length_of_number(std::uint8_t first) {
  std::uint64_t length = 1;
  for (unsigned mask = 0x80; mask != 0 && (first & mask) == 0; mask >>= 1U) ++length;
  if (length > 8) throw NotWhole("it is no WebM film");
  return length;
}

Element element_at(FilmBytes& film, const Extent& outer, std::uint64_t at) {
  const std::uint64_t name_length = length_of_number(film.at(at));
  const std::uint64_t size_at = at + name_length, size_length = length_of_number(film.at(size_at));
  const std::uint64_t mask = (std::uint64_t{1} << 7U * size_length) - 1;
  const std::uint64_t length = film.high_first(size_at, size_length) & mask;
  if (length == mask) unfinished();  // all ones: not known yet
  return {film.high_first(at, name_length), inside(outer, size_at + size_length, length)};
}

std::size_t blocks_in(FilmBytes& film, const Extent& frames) {
  std::size_t count = 0;
  for (std::uint64_t at = frames.begin; at < frames.end;) {
    const Element element = element_at(film, frames, at);
    count += element.identifier == simple_block || element.identifier == block_group;
    at = element.content.end;
  }
  return count;
}

std::size_t frames_of_webm(FilmBytes& film) {
  const Extent all{0, film.size()};
  const Element head = element_at(film, all, 0);
  if (head.identifier != ebml) throw NotWhole("it is no WebM film");
  const Element body = element_at(film, all, head.content.end);
  if (body.identifier != segment || body.content.end != all.end) unfinished();
  std::size_t count = 0;
  bool indexed = false;
  for (std::uint64_t at = body.content.begin; at < all.end;) {
    const Element element = element_at(film, body.content, at);
    if (element.identifier == cluster) count += blocks_in(film, element.content);
    indexed = indexed || element.identifier == cues;
    at = element.content.end;
  }
  if (!indexed) unfinished();
  return count;
}

// --- GIF: blocks, each a row of parts of a byte's length.

std::uint64_t end_of_parts(FilmBytes& film, std::uint64_t at) {
  while (const std::uint8_t length = film.at(at)) at += 1U + length;
  return at + 1;
}

// Bytes of the table of colours that those flags speak of.
std::uint64_t bytes_of_colours(std::uint8_t flags) {
  return (flags & 0x80U) != 0 ? std::uint64_t{6} << (flags & 7U) : 0;
}

std::size_t frames_of_gif(FilmBytes& film) {
  if (!film.has(0, "GIF89a")) throw NotWhole("it is no GIF film");
  constexpr std::uint8_t extension = 0x21, picture = 0x2C, end = 0x3B;
  std::size_t count = 0;
  std::uint64_t at = 13 + bytes_of_colours(film.at(10));
  for (;;) {
    const std::uint8_t kind = film.at(at);
    if (kind == end) return count;
    if (kind == extension) {
      at = end_of_parts(film, at + 2);
    } else if (kind == picture) {
      at = end_of_parts(film, at + 11 + bytes_of_colours(film.at(at + 9)));
      ++count;
    } else {
      throw NotWhole("it is no GIF film");
    }
  }
}

// --- WebP: chunks of a name and a length, padded to an even one.

std::size_t frames_of_webp(FilmBytes& film) {
  if (!film.has(0, "RIFF") || !film.has(8, "WEBP")) throw NotWhole("it is no WebP film");
  if (film.low_first(4, 4) + 8 != film.size()) cut();
  const Extent all{0, film.size()};
  std::size_t animated = 0, still = 0;
  for (std::uint64_t at = 12; at < all.end;) {
    const std::uint64_t length = film.low_first(at + 4, 4);
    animated += film.has(at, "ANMF");
    still += film.has(at, "VP8 ") || film.has(at, "VP8L");
    at = inside(all, at + 8, length + length % 2).end;
  }
  return animated > 0 ? animated : still;
}

struct Reader {
  std::string_view ending;
  std::size_t (*frames)(FilmBytes&);
};

constexpr std::array<Reader, 5> readers{{
    {".mp4", frames_of_mp4},
    {".mov", frames_of_mp4},
    {".webm", frames_of_webm},
    {".gif", frames_of_gif},
    {".webp", frames_of_webp},
}};

}  // namespace

std::string film_problem(const std::filesystem::path& file, std::string_view ending, std::size_t frames) {
  FilmBytes film(file);
  if (film.size() == 0) return "it is empty";
  try {
    const std::size_t found = std::ranges::find(readers, ending, &Reader::ending)->frames(film);
    return found == frames ? std::string() : fmt::format("it has {} frames of {}", found, frames);
  } catch (const NotWhole& problem) {
    return problem.what();
  }
}

}  // namespace taut
