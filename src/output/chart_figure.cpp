#include "output/chart_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace taut {
namespace {

constexpr int figure_width = 1800;                                // pixels
constexpr int left = 200, right = 50, plot_height = 920;          // pixels
constexpr int title_room = 120, least_top = 150;                  // pixels
constexpr int axis_room = 175, note_line = 36;                    // pixels
constexpr std::size_t note_letters = 99;                          // a line
constexpr double letter_width = 0.62 * plot_letters;              // pixels, about
constexpr double name_gap = 16.0;                                 // pixels, left of a curve's name
constexpr double small_letter_width = 0.62 * plot_small_letters;  // pixels, about

// A logarithmic axis and where it lies on the picture.
struct Axis {
  double low, high;  // of the numbers
  double from, to;   // pixels

  double pixel(double value) const {
    return from + (to - from) * std::log(value / low) / std::log(high / low);
  }
};

struct Axes {
  Axis x, y;
};

Axes axes_of(const ChartFigure& figure) {
  constexpr double big = std::numeric_limits<double>::max();
  double x_low = big, x_high = 0.0, y_low = big, y_high = 0.0;
  for (const FigureCurve& curve : figure.curves)
    for (const FigurePoint& point : curve.points) {
      x_low = std::min(x_low, point.x);
      x_high = std::max(x_high, point.x);
      y_low = std::min(y_low, point.y);
      y_high = std::max(y_high, point.y);
    }
  if (x_high == 0.0) x_low = y_low = 0.1, x_high = y_high = 1.0;
  // Room at the left for names, above for those that make way for others, below for those of the front.
  std::size_t longest = 0;
  for (const FigureCurve& curve : figure.curves) longest = std::max(longest, curve.name.size());
  for (const FigureLabel& label : figure.front) longest = std::max(longest, label.text.size());
  const double plot_width = figure_width - left - right;
  const double names = std::min(0.4, (letter_width * static_cast<double>(longest) + 20.0) / plot_width);
  const double decades = std::max(1.0, std::log10(x_high / x_low));
  const double floors = std::max(1.0, std::log10(y_high / y_low));
  return {{x_low * std::pow(10.0, -decades * names / (1.0 - names)), x_high * std::pow(10.0, 0.04 * decades),
           left, figure_width - right},
          {y_low * std::pow(10.0, -0.09 * floors), y_high * std::pow(10.0, 0.12 * floors), 0.0, plot_height}};
}

// Lines of at most so many characters, broken at spaces.
std::vector<std::string> wrapped(const std::vector<std::string>& sentences) {
  std::vector<std::string> lines;
  for (const std::string& sentence : sentences) {
    std::string line;
    std::size_t letters = 0;
    for (std::size_t at = 0; at < sentence.size();) {
      const std::size_t end = std::min(sentence.find(' ', at), sentence.size());
      const std::string word = sentence.substr(at, end - at);
      const auto length = static_cast<std::size_t>(std::ranges::count_if(
          word, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
      if (letters > 0 && letters + 1 + length > note_letters) {
        lines.push_back(line);
        line.clear();
        letters = 0;
      }
      line += (letters > 0 ? " " : "") + word;
      letters += length + (letters > 0 ? 1 : 0);
      at = end + 1;
    }
    lines.push_back(line);
  }
  return lines;
}

std::string data_block(const std::string& name, const std::vector<std::pair<double, double>>& points) {
  std::string block = fmt::format("${} << EOD\n", name);
  for (const auto& [x, y] : points) block += fmt::format("{:.9g} {:.9g}\n", x, y);
  return block + "EOD\n";
}

// A rectangle in pixels from the plot's lower left.
struct LabelBox {
  double left, right, low, high;

  bool meets(const LabelBox& other) const {
    return left < other.right && other.left < right && low < other.high && other.low < high;
  }
};

// Where the name of a place on the front stands: below and left of it, where nothing else is, for no point is
// better.
LabelBox front_box(const FigureLabel& label, const Axes& axes) {
  const double x = axes.x.pixel(label.x) - 0.6 * plot_letters, y = axes.y.pixel(label.y) - 0.9 * plot_letters;
  const double half = 0.6 * plot_small_letters;
  return {x - small_letter_width * static_cast<double>(label.text.size()), x, y - half, y + half};
}

// Those names of the front that find room beside each other.
std::vector<const FigureLabel*> front_names(const ChartFigure& figure, const Axes& axes) {
  std::vector<const FigureLabel*> names;
  for (const FigureLabel& label : figure.front) {
    const bool free = std::ranges::none_of(names, [&](const FigureLabel* other) {
      return front_box(*other, axes).meets(front_box(label, axes));
    });
    if (free && !label.text.empty()) names.push_back(&label);
  }
  return names;
}

// A curve's name and where it stands, in pixels from the plot's lower left.
struct NameTag {
  const FigureCurve* curve;
  double x, y, point_x, point_y;

  LabelBox box() const {
    const double half = 0.62 * plot_letters;
    return {x - letter_width * static_cast<double>(curve->name.size()) - name_gap, x + 4.0, y - half,
            y + half};
  }
};

std::vector<LabelBox> obstacles(const ChartFigure& figure, const Axes& axes) {
  std::vector<LabelBox> boxes;
  for (const FigureLabel* label : front_names(figure, axes)) boxes.push_back(front_box(*label, axes));
  for (const FigureCurve& curve : figure.curves)
    for (const FigurePoint& point : curve.points) {
      const double x = axes.x.pixel(point.x), y = axes.y.pixel(point.y);
      if (point.on_line) boxes.push_back({x - 6.0, x + 6.0, y - 6.0, y + 6.0});
    }
  return boxes;
}

// Names stand at the end of smallest error, moved up until they meet nothing.
std::vector<NameTag> place_names(const ChartFigure& figure, const Axes& axes) {
  std::vector<NameTag> tags;
  for (const FigureCurve& curve : figure.curves) {
    const FigurePoint* end = nullptr;
    for (const FigurePoint& point : curve.points)
      if (point.on_line && (end == nullptr || point.x < end->x)) end = &point;
    if (end == nullptr) continue;
    const double x = axes.x.pixel(end->x), y = axes.y.pixel(end->y);
    tags.push_back({&curve, x - 22.0, y, x, y});
  }
  std::ranges::sort(tags, {}, &NameTag::y);
  std::vector<LabelBox> taken = obstacles(figure, axes);
  for (NameTag& tag : tags) {
    while (std::ranges::any_of(taken, [&](const LabelBox& box) { return box.meets(tag.box()); }))
      tag.y += 6.0;
    taken.push_back(tag.box());
  }
  return tags;
}

// The whole picture, in pixels: below the plot as many notes as there are, above it the title, and between
// the two whatever names stand higher than the plot.
struct Canvas {
  int height, bottom;  // of the picture, and of the plot above its lower edge

  Canvas(std::size_t notes, const std::vector<NameTag>& tags)
      : height(0), bottom(axis_room + note_line * static_cast<int>(notes) + 10) {
    double highest = 0.0;
    for (const NameTag& tag : tags) highest = std::max(highest, tag.box().high);
    const int overhang = static_cast<int>(std::ceil(highest)) - plot_height;
    height = bottom + plot_height + std::max(least_top, title_room + overhang);
  }

  double x(double pixel) const { return pixel / figure_width; }
  double y(double pixel) const { return (bottom + pixel) / height; }
};

std::string tag_commands(const std::vector<NameTag>& tags, const Canvas& canvas) {
  std::string commands;
  for (const NameTag& tag : tags) {
    const double x = canvas.x(tag.x), y = canvas.y(tag.y);
    if (std::abs(tag.y - tag.point_y) > 12.0)
      commands += fmt::format(
          "set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead lc rgb '{}' lw 1.5\n",
          x + 0.002, y, canvas.x(tag.point_x), canvas.y(tag.point_y), plot_colour(tag.curve->colour));
    commands += fmt::format("set label {} at screen {:.5f},{:.5f} right front tc rgb '{}'\n",
                            plot_text(tag.curve->name), x, y, plot_colour(tag.curve->colour));
  }
  return commands;
}

std::string front_commands(const ChartFigure& figure, const Axes& axes, const Canvas& canvas) {
  std::string commands;
  for (const FigureLabel* label : front_names(figure, axes)) {
    const LabelBox box = front_box(*label, axes);
    commands += fmt::format("set label {} at screen {:.5f},{:.5f} right front font ',{}' tc rgb '{}'\n",
                            plot_text(label->text), canvas.x(box.right), canvas.y(0.5 * (box.low + box.high)),
                            plot_small_letters, plot_ink);
  }
  return commands;
}

std::string text_commands(const ChartFigure& figure, const std::vector<std::string>& notes,
                          const Canvas& canvas) {
  const double margin = canvas.x(30.0);
  std::string commands =
      fmt::format("set label {} at screen {:.5f},{:.5f} left font ',{}' tc rgb '{}'\n",
                  plot_text(figure.title), margin, 1.0 - 45.0 / canvas.height, plot_letters + 8, plot_ink);
  commands += fmt::format("set label {} at screen {:.5f},{:.5f} left tc rgb '{}'\n",
                          plot_text(figure.subtitle), margin, 1.0 - 100.0 / canvas.height, plot_ink);
  commands +=
      fmt::format("set label {} at screen {:.5f},{:.5f} center tc rgb '{}'\n", plot_text(figure.x_label),
                  canvas.x(0.5 * (left + figure_width - right)), canvas.y(-122.0), plot_ink);
  commands += fmt::format("set label {} at screen {:.5f},{:.5f} center rotate by 90 tc rgb '{}'\n",
                          plot_text(figure.y_label), canvas.x(35.0), canvas.y(0.5 * plot_height), plot_ink);
  double y = -axis_room;
  for (const std::string& note : notes) {
    commands += fmt::format("set label {} at screen {:.5f},{:.5f} left font ',{}' tc rgb '{}'\n",
                            plot_text(note), margin, canvas.y(y), plot_small_letters, plot_ink);
    y -= note_line;
  }
  return commands;
}

std::string axis_commands(const Axes& axes, const Canvas& canvas) {
  std::string commands = fmt::format("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n",
                                     canvas.x(left), canvas.x(figure_width - right));
  commands += fmt::format("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n",
                          canvas.y(plot_height), canvas.y(0.0));
  commands += fmt::format("set logscale xy\nset xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n",
                          axes.x.low, axes.x.high, axes.y.low, axes.y.high);
  const int step = axes.x.high / axes.x.low > 1e12 ? 100 : 10;
  commands += fmt::format(
      "set format xy '10^{{%T}}'\nset xtics {}\nset ytics 10\nset mxtics 10\nset mytics 10\n", step);
  return commands;
}

// The curves as data, and the command that plots them.
std::string curve_commands(const ChartFigure& figure) {
  std::vector<std::pair<double, double>> front;
  for (const FigureLabel& point : figure.front) front.emplace_back(point.x, point.y);
  std::string data = data_block("front", front);
  std::string plots = "plot $front with lines lw 16 lc rgb '#e2e2e2'";
  for (std::size_t i = 0; i < figure.curves.size(); ++i) {
    const FigureCurve& curve = figure.curves[i];
    std::vector<std::pair<double, double>> line, dots;
    for (const FigurePoint& point : curve.points)
      (point.on_line ? line : dots).emplace_back(point.x, point.y);
    const std::string_view colour = plot_colour(curve.colour);
    if (!dots.empty()) {
      data += data_block(fmt::format("dots{}", i), dots);
      plots += fmt::format(", \\\n $dots{} with points pt 7 ps 0.9 lc rgb '#a0{}'", i, colour.substr(1));
    }
    if (!line.empty()) {
      data += data_block(fmt::format("line{}", i), line);
      plots += fmt::format(", \\\n $line{} with linespoints pt 7 ps 1.6 lw 4 dt {} lc rgb '{}'", i,
                           curve.dashed ? 2 : 1, colour);
    }
  }
  return data + plots + "\n";
}

}  // namespace

PlotScript figure_script(const ChartFigure& figure) {
  const std::vector<std::string> notes = wrapped(figure.notes);
  const Axes axes = axes_of(figure);
  const std::vector<NameTag> tags = place_names(figure, axes);
  const Canvas canvas(notes.size(), tags);
  std::string commands = axis_commands(axes, canvas) + text_commands(figure, notes, canvas) +
                         front_commands(figure, axes, canvas) + tag_commands(tags, canvas) +
                         curve_commands(figure);
  return {std::move(commands), {figure_width, canvas.height}};
}

}  // namespace taut
