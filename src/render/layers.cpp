#include "layers.h"

#include <algorithm>
#include <limits>
#include <span>

#include "legend.h"

namespace taut {
namespace {

// The samples of an image: of memory that is aligned for any of them.
template <typename Sample>
Sample* samples_of(Image& image) {
  return reinterpret_cast<Sample*>(image.pixels.data());
}
template <typename Sample>
const Sample* samples_of(const Image& image) {
  return reinterpret_cast<const Sample*>(image.pixels.data());
}

template <typename Sample>
constexpr unsigned full = std::numeric_limits<Sample>::max();

// Calls with (pixel of the picture, first pixel of the cut-out, its width) for each of the cut-out's rows.
template <typename Sample, typename Visit>
void for_each_row(Image& picture, int left, int top, const Image& cut_out, const Visit& visit) {
  const auto width = static_cast<std::size_t>(cut_out.size.width);
  for (int row = 0; row < cut_out.size.height; ++row) {
    const auto at = static_cast<std::size_t>(top + row) * static_cast<std::size_t>(picture.size.width) +
                    static_cast<std::size_t>(left);
    visit(samples_of<Sample>(picture) + at * static_cast<std::size_t>(picture.channels),
          samples_of<Sample>(cut_out) + static_cast<std::size_t>(row) * width * 4, width);
  }
}

// A product of two shares of the fullest value as a share of it, rounded.
template <typename Sample>
unsigned share_of(unsigned a, unsigned b) {
  constexpr unsigned bits = std::numeric_limits<Sample>::digits, half = 1U << (bits - 1U);
  const unsigned product = a * b + half;
  return (product + (product >> bits)) >> bits;
}

// Lays a cut-out over a picture of so many channels, colours of both multiplied by alpha.
template <typename Sample, int channels>
void lay_samples_over(Image& picture, int left, int top, const Image& cut_out) {
  for_each_row<Sample>(picture, left, top, cut_out, [](Sample* to, const Sample* from, std::size_t width) {
    for (std::size_t x = 0; x < width; ++x, to += channels, from += 4) {
      const unsigned uncovered = full<Sample> - from[3];
      if (uncovered == full<Sample>) continue;
      for (int channel = 0; channel < channels; ++channel)
        to[channel] = static_cast<Sample>(
            std::min(from[channel] + share_of<Sample>(to[channel], uncovered), full<Sample>));
    }
  });
}

// From colours multiplied by alpha to straight ones.
template <typename Sample>
void divide_by_alpha(Image& picture) {
  Sample* const samples = samples_of<Sample>(picture);
  for (std::size_t pixel = 0; pixel < picture.pixels.size() / sizeof(Sample); pixel += 4) {
    Sample* const at = samples + pixel;
    const unsigned alpha = at[3];
    if (alpha == 0 || alpha == full<Sample>) continue;
    for (int channel = 0; channel < 3; ++channel)
      at[channel] =
          static_cast<Sample>(std::min((at[channel] * full<Sample> + alpha / 2) / alpha, full<Sample>));
  }
}

// The mean of pictures of one size.
template <typename Sample>
Image mean_of(std::span<const Image> pictures) {
  Image mean = pictures.front();
  const auto count = static_cast<unsigned>(pictures.size());
  for (std::size_t i = 0; i < mean.pixels.size() / sizeof(Sample); ++i) {
    unsigned sum = count / 2;
    for (const Image& picture : pictures) sum += samples_of<Sample>(picture)[i];
    samples_of<Sample>(mean)[i] = static_cast<Sample>(sum / count);
  }
  return mean;
}

template <typename Sample>
Image flatten_samples(const Layers& layers) {
  Image image = layers.backdrop ? *layers.backdrop : Image::blank(layers.size, 4, layers.bits);
  const auto lay = layers.backdrop ? lay_samples_over<Sample, 3> : lay_samples_over<Sample, 4>;
  for (const Layer& part : layers.parts) {
    if (part.passes.size() == 1)
      lay(image, part.region.left, part.region.top, part.passes.front());
    else
      lay(image, part.region.left, part.region.top, mean_of<Sample>(part.passes));
  }
  if (!layers.backdrop) divide_by_alpha<Sample>(image);
  return image;
}

}  // namespace

void lay_over(Image& picture, int left, int top, const Image& cut_out) {
  if (picture.bits == 16)
    lay_samples_over<std::uint16_t, 3>(picture, left, top, cut_out);
  else
    lay_samples_over<std::uint8_t, 3>(picture, left, top, cut_out);
}

Image flatten(const Layers& layers, bool with_legend) {
  Image image =
      layers.bits == 16 ? flatten_samples<std::uint16_t>(layers) : flatten_samples<std::uint8_t>(layers);
  if (layers.legend && with_legend)
    draw_legend(image, layers.legend->font, layers.legend->by, layers.legend->scale);
  return image;
}

bool has_legend(const Layers& layers) {
  return layers.legend.has_value();
}

}  // namespace taut
