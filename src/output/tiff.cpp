#include "output/tiff.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>

#include "base/failure.h"
#include "output/content_hash.h"

namespace taut {
namespace {

constexpr int deep_bits = 16;

// A file in memory, as libtiff reads and writes it.
struct MemoryFile {
  std::string bytes;
  std::size_t at = 0;
};

MemoryFile& file_of(thandle_t handle) {
  return *static_cast<MemoryFile*>(handle);
}

tmsize_t read_some(thandle_t handle, void* to, tmsize_t count) {
  MemoryFile& file = file_of(handle);
  const std::size_t there = file.bytes.size() - std::min(file.at, file.bytes.size());
  const std::size_t taken = std::min(there, static_cast<std::size_t>(count));
  std::memcpy(to, file.bytes.data() + std::min(file.at, file.bytes.size()), taken);
  file.at += taken;
  return static_cast<tmsize_t>(taken);
}

tmsize_t write_some(thandle_t handle, void* from, tmsize_t count) {
  MemoryFile& file = file_of(handle);
  const auto length = static_cast<std::size_t>(count);
  if (file.at + length > file.bytes.size()) file.bytes.resize(file.at + length);
  std::memcpy(file.bytes.data() + file.at, from, length);
  file.at += length;
  return count;
}

toff_t seek_to(thandle_t handle, toff_t offset, int whence) {
  MemoryFile& file = file_of(handle);
  const toff_t base = whence == SEEK_CUR ? file.at : whence == SEEK_END ? file.bytes.size() : 0;
  file.at = static_cast<std::size_t>(base + offset);
  return file.at;
}

int close_nothing(thandle_t /*handle*/) {
  return 0;
}

toff_t size_of_memory(thandle_t handle) {
  return file_of(handle).bytes.size();
}

// What libtiff has to say stands in the messages of who calls it.
int say_nothing(TIFF* /*file*/, void* /*data*/, const char* /*module*/, const char* /*text*/,
                va_list /*values*/) {
  return 1;
}

struct CloseTiff {
  void operator()(TIFF* file) const { TIFFClose(file); }
};
struct FreeOptions {
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using OpenTiff = std::unique_ptr<TIFF, CloseTiff>;

OpenTiff open_in_memory(MemoryFile& file, const char* mode) {
  const std::unique_ptr<TIFFOpenOptions, FreeOptions> options(TIFFOpenOptionsAlloc());
  if (!options) return nullptr;
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_nothing, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_nothing, nullptr);
  return OpenTiff(TIFFClientOpenExt("frame", mode, &file, read_some, write_some, seek_to, close_nothing,
                                    size_of_memory, nullptr, nullptr, options.get()));
}

bool describe_picture(TIFF* file, const Image& image) {
  constexpr std::uint16_t straight = EXTRASAMPLE_UNASSALPHA;
  const auto put = [file](std::uint32_t tag, auto... values) {
    return TIFFSetField(file, tag, values...) == 1;
  };
  return put(TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(image.size.width)) &&
         put(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(image.size.height)) &&
         put(TIFFTAG_BITSPERSAMPLE, deep_bits) && put(TIFFTAG_SAMPLESPERPIXEL, image.channels) &&
         put(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB) && put(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) &&
         put(TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE) &&
         put(TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL) && put(TIFFTAG_ZIPQUALITY, 1) &&
         put(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) &&
         (image.channels == 3 || put(TIFFTAG_EXTRASAMPLES, 1, &straight)) &&
         put(TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(file, 0));
}

bool write_rows(TIFF* file, const Image& image) {
  const std::size_t length = static_cast<std::size_t>(image.size.width) * image.bytes_of_pixel();
  std::vector<std::uint8_t> row(length);  // a copy: the predictor works in place
  for (int y = 0; y < image.size.height; ++y) {
    std::memcpy(row.data(), image.pixels.data() + static_cast<std::size_t>(y) * length, length);
    if (TIFFWriteScanline(file, row.data(), static_cast<std::uint32_t>(y), 0) != 1) return false;
  }
  return TIFFFlush(file) == 1;
}

std::optional<Image> read_picture(std::string_view bytes) {
  MemoryFile memory{std::string(bytes), 0};
  const OpenTiff file = open_in_memory(memory, "rm");
  if (!file) return std::nullopt;
  constexpr std::uint32_t longest_side = 16384;
  std::uint32_t width = 0, height = 0;
  std::uint16_t bits = 0, channels = 0;
  TIFFGetField(file.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(file.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetField(file.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetField(file.get(), TIFFTAG_SAMPLESPERPIXEL, &channels);
  if (width == 0 || height == 0 || width > longest_side || height > longest_side || bits != deep_bits ||
      (channels != 3 && channels != 4))
    return std::nullopt;
  Image image = Image::blank({static_cast<int>(width), static_cast<int>(height)}, channels, deep_bits);
  const std::size_t length = width * image.bytes_of_pixel();
  if (static_cast<std::size_t>(TIFFScanlineSize(file.get())) != length) return std::nullopt;
  for (std::uint32_t y = 0; y < height; ++y)
    if (TIFFReadScanline(file.get(), image.pixels.data() + y * length, y, 0) != 1) return std::nullopt;
  return image;
}

}  // namespace

std::vector<std::uint8_t> encode_tiff(const Image& image) {
  MemoryFile memory;
  bool whole = false;
  if (const OpenTiff file = open_in_memory(memory, "w"))
    whole = describe_picture(file.get(), image) && write_rows(file.get(), image);
  if (!whole) throw RunFailure("a frame could not be compressed: there is no memory left");
  return {memory.bytes.begin(), memory.bytes.end()};
}

Image decode_tiff(std::string_view bytes, const std::filesystem::path& name) {
  std::optional<Image> image = read_picture(bytes);
  if (!image) throw RunFailure(fmt::format("{} is not a whole picture", name.string()));
  return *std::move(image);
}

bool is_whole_tiff(const std::filesystem::path& file, Size size) {
  const std::optional<std::string> bytes = bytes_of_file(file);
  const std::optional<Image> image = bytes ? read_picture(*bytes) : std::nullopt;
  return image && image->size.width == size.width && image->size.height == size.height;
}

}  // namespace taut
