#include "output/label_layout.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace taut {
namespace {

// The width of a character as a share of the letters' size in pixels; the bytes of one beyond ASCII count as
// one.
double character_width(char c) {
  constexpr std::string_view narrow = "ijl.,:;'|! ", middling = "frt()[]-/I";
  if ((static_cast<unsigned char>(c) & 0xc0U) == 0x80U) return 0.0;
  if (static_cast<unsigned char>(c) >= 0x80U) return 0.84;
  if (narrow.find(c) != std::string_view::npos) return 0.34;
  if (middling.find(c) != std::string_view::npos) return 0.42;
  if (c == 'm' || c == 'M' || c == 'W' || c == '%' || c == '@' || c == '+' || c == '=') return 0.98;
  if (c == 'w' || (c >= 'A' && c <= 'Z')) return 0.82;
  return 0.64;
}

// A run of labels that stand as close as they may, and where the lowest of them would rather be.
struct Run {
  double sum = 0.0;
  std::size_t count = 0;

  double place() const { return sum / static_cast<double>(count); }
};

}  // namespace

bool meets(const LabelBox& box, const LabelLine& line) {
  // The shares of the line within the box's width, then also within its height.
  double begin = 0.0, end = 1.0;
  const auto within = [&](double from, double to, double low, double high) {
    const double way = to - from;
    if (way == 0.0) return from > low && from < high;
    const double a = (low - from) / way, b = (high - from) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    return begin < end;
  };
  return within(line.from_x, line.to_x, box.left, box.right) &&
         within(line.from_y, line.to_y, box.low, box.high);
}

double text_width(std::string_view text, int letters) {
  constexpr double pixels = 4.0 / 3.0;
  double width = 0.0;
  for (const char c : text) width += character_width(c);
  return width * pixels * letters;
}

// Less the room of the labels below it every label's place may only rise with the order: an isotonic
// regression, by pooling neighbours that are the wrong way round (Barlow and others, 1972).
std::vector<double> spread_apart(const std::vector<double>& wanted, double gap, double low, double high) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  std::vector<Run> runs;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    runs.push_back({wanted[order[rank]] - gap * static_cast<double>(rank), 1});
    while (runs.size() > 1 && runs[runs.size() - 2].place() >= runs.back().place()) {
      const Run last = runs.back();
      runs.pop_back();
      runs.back().sum += last.sum;
      runs.back().count += last.count;
    }
  }
  const double room =
      wanted.empty() ? 0.0 : std::max(0.0, high - low - gap * static_cast<double>(wanted.size() - 1));
  std::vector<double> places(wanted.size());
  std::size_t rank = 0;
  for (const Run& run : runs)
    for (std::size_t i = 0; i < run.count; ++i, ++rank)
      places[order[rank]] = std::clamp(run.place(), low, low + room) + gap * static_cast<double>(rank);
  return places;
}

}  // namespace taut
