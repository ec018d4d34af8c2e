#include "render/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/failure.h"

namespace taut {
namespace {

// In bytes.
std::size_t pixel_offset(const Image& image, int x, int y) {
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width) + static_cast<std::size_t>(x);
  return pixel * image.bytes_of_pixel();
}

// Lays a colour over a pixel of so many channels.
template <typename Sample>
void lay_colour(std::uint8_t* at, int channels, const Colour& colour, double above) {
  constexpr double most = std::numeric_limits<Sample>::max();
  const auto to_sample = [](double share) {
    return static_cast<Sample>(std::lround(most * std::clamp(share, 0.0, 1.0)));
  };
  std::array<Sample, 4> pixel{};
  const std::size_t bytes = static_cast<std::size_t>(channels) * sizeof(Sample);
  std::memcpy(pixel.data(), at, bytes);
  const double below = channels == 4 ? pixel[3] / most : 1.0;
  const double together = above + below * (1.0 - above);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double old = pixel.at(channel) / most;
    pixel.at(channel) = to_sample((colour.at(channel) * above + old * below * (1.0 - above)) / together);
  }
  if (channels == 4) pixel[3] = to_sample(together);
  std::memcpy(at, pixel.data(), bytes);
}

/// How much of the pixel from `at` to `at` + 1 lies between two edges.
double covered(int at, double from, double to) {
  return std::clamp(std::min(to, at + 1.0) - std::max(from, static_cast<double>(at)), 0.0, 1.0);
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double along = squared > 0.0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared : 0.0;
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

/// First and last pixel, within the picture, that the stretch from `from` to `to` touches.
struct PixelRange {
  int first, last;
};

PixelRange pixels_between(double from, double to, int size) {
  return {static_cast<int>(std::clamp(std::floor(from), 0.0, static_cast<double>(size))),
          static_cast<int>(std::clamp(std::ceil(to), 0.0, static_cast<double>(size))) - 1};
}

}  // namespace

void blend_pixel(Image& image, int x, int y, const Paint& paint, double share) {
  if (x < 0 || y < 0 || x >= image.size.width || y >= image.size.height) return;
  const double above = std::clamp(paint.alpha * share, 0.0, 1.0);
  if (above <= 0.0) return;
  std::uint8_t* pixel = image.pixels.data() + pixel_offset(image, x, y);
  if (image.bits == 16)
    lay_colour<std::uint16_t>(pixel, image.channels, paint.colour, above);
  else
    lay_colour<std::uint8_t>(pixel, image.channels, paint.colour, above);
}

void fill_rectangle(Image& image, const Rectangle& rectangle, const Paint& paint) {
  const double right = rectangle.left + rectangle.width, bottom = rectangle.top + rectangle.height;
  const PixelRange columns = pixels_between(rectangle.left, right, image.size.width);
  const PixelRange rows = pixels_between(rectangle.top, bottom, image.size.height);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      blend_pixel(image, x, y, paint, covered(x, rectangle.left, right) * covered(y, rectangle.top, bottom));
    }
  }
}

void draw_line(Image& image, const Point& from, const Point& to, double width, const Paint& paint) {
  const double reach = 0.5 * width + 1.0;
  const PixelRange columns =
      pixels_between(std::min(from.x, to.x) - reach, std::max(from.x, to.x) + reach, image.size.width);
  const PixelRange rows =
      pixels_between(std::min(from.y, to.y) - reach, std::max(from.y, to.y) + reach, image.size.height);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const double away = distance_to_segment({x + 0.5, y + 0.5}, from, to);
      blend_pixel(image, x, y, paint, std::clamp(0.5 * width + 0.5 - away, 0.0, std::min(width, 1.0)));
    }
  }
}

void place_image(Image& image, int left, int top, const Image& inset) {
  if (image.channels != inset.channels || image.bits != inset.bits)
    throw RunFailure("pictures of different kinds can't be put together");
  const int first = std::max(0, -left);
  const int last = std::min(inset.size.width, image.size.width - left);
  if (first >= last) return;
  const auto bytes = static_cast<std::size_t>(last - first) * image.bytes_of_pixel();
  for (int row = std::max(0, -top); row < inset.size.height && row + top < image.size.height; ++row) {
    std::copy_n(inset.pixels.data() + pixel_offset(inset, first, row), bytes,
                image.pixels.data() + pixel_offset(image, left + first, top + row));
  }
}

}  // namespace taut
