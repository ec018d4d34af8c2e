#include "layers.h"

#include <algorithm>
#include <span>

#include "legend.h"

namespace taut {
namespace {

// Calls with (pixel of the picture, first pixel of the cut-out, its width) for each of the cut-out's rows.
template <typename Visit>
void for_each_row(Image& picture, int left, int top, const Image& cut_out, const Visit& visit) {
  const auto width = static_cast<std::size_t>(cut_out.size.width);
  for (int row = 0; row < cut_out.size.height; ++row) {
    const auto at = static_cast<std::size_t>(top + row) * static_cast<std::size_t>(picture.size.width) +
                    static_cast<std::size_t>(left);
    visit(picture.pixels.data() + at * static_cast<std::size_t>(picture.channels),
          cut_out.pixels.data() + static_cast<std::size_t>(row) * width * 4, width);
  }
}

// A product of two shares of 255 as a share of 255, rounded.
unsigned share_of(unsigned a, unsigned b) {
  const unsigned product = a * b + 128;
  return (product + (product >> 8)) >> 8;
}

// Lays a cut-out over an RGBA picture, colours of both multiplied by alpha.
void lay_over_cut_out(Image& picture, int left, int top, const Image& cut_out) {
  for_each_row(
      picture, left, top, cut_out, [](std::uint8_t* to, const std::uint8_t* from, std::size_t width) {
        for (std::size_t x = 0; x < width; ++x, to += 4, from += 4) {
          const unsigned uncovered = 255U - from[3];
          if (uncovered == 255) continue;
          for (int channel = 0; channel < 4; ++channel)
            to[channel] =
                static_cast<std::uint8_t>(std::min(from[channel] + share_of(to[channel], uncovered), 255U));
        }
      });
}

// From colours multiplied by alpha to straight ones.
void divide_by_alpha(Image& picture) {
  for (std::size_t pixel = 0; pixel < picture.pixels.size(); pixel += 4) {
    std::uint8_t* const at = picture.pixels.data() + pixel;
    const unsigned alpha = at[3];
    if (alpha == 0 || alpha == 255) continue;
    for (int channel = 0; channel < 3; ++channel)
      at[channel] = static_cast<std::uint8_t>(std::min((at[channel] * 255U + alpha / 2) / alpha, 255U));
  }
}

// The mean of pictures of one size.
Image mean_of(std::span<const Image> pictures) {
  Image mean = pictures.front();
  const auto count = static_cast<unsigned>(pictures.size());
  for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
    unsigned sum = count / 2;
    for (const Image& picture : pictures) sum += picture.pixels[i];
    mean.pixels[i] = static_cast<std::uint8_t>(sum / count);
  }
  return mean;
}

}  // namespace

void lay_over(Image& picture, int left, int top, const Image& cut_out) {
  for_each_row(
      picture, left, top, cut_out, [](std::uint8_t* to, const std::uint8_t* from, std::size_t width) {
        for (std::size_t x = 0; x < width; ++x, to += 3, from += 4) {
          const unsigned uncovered = 255U - from[3];
          if (uncovered == 255) continue;
          for (int channel = 0; channel < 3; ++channel)
            to[channel] =
                static_cast<std::uint8_t>(std::min(from[channel] + share_of(to[channel], uncovered), 255U));
        }
      });
}

Image flatten(const Layers& layers) {
  Image image = layers.backdrop ? *layers.backdrop : Image::blank(layers.size, 4);
  const auto lay = layers.backdrop ? lay_over : lay_over_cut_out;
  for (const Layer& part : layers.parts) {
    if (part.passes.size() == 1)
      lay(image, part.region.left, part.region.top, part.passes.front());
    else
      lay(image, part.region.left, part.region.top, mean_of(part.passes));
  }
  if (!layers.backdrop) divide_by_alpha(image);
  if (layers.legend) draw_legend(image, layers.legend->font, layers.legend->by, layers.legend->scale);
  return image;
}

}  // namespace taut
