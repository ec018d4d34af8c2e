// OpenUSD as text (the .usda of "Universal Scene Description", schemas UsdGeom): a mesh for each sheet,
// linear curves for links and points for lone masses, all with samples over time. Points are of single
// precision there, whatever is written. Which cells and links there are is held from the sample on that says
// so.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "export/export_shape.h"
#include "export/formats.h"
#include "export/scratch_file.h"
#include "model/measures.h"
#include "output/export.h"

namespace taut {
namespace {

// What changes with time of one attribute: a line a sample, in the scratch file.
struct UsdSamples {
  std::string declaration;
  struct Piece {
    std::uint64_t offset, size;
  };
  std::vector<Piece> pieces;
};

// One object, with what of it never changes.
struct UsdPrim {
  std::string head;
  std::deque<UsdSamples> attributes;
  bool has_points = false;  // at any time
};

// Names of objects: letters, digits and underlines, each once.
class UsdNames {
 public:
  std::string unique(std::string_view wanted) {
    std::string name;
    for (const char letter : wanted)
      name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0)
      name.insert(name.begin(), '_');
    std::string different = name;
    for (int number = 2; !taken_.insert(different).second; ++number)
      different = fmt::format("{}_{}", name, number);
    return different;
  }

 private:
  std::set<std::string> taken_;
};

std::string usd_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
  }
  return quoted + '"';
}

void append_point(const Vec3& point, std::string& text) {
  fmt::format_to(std::back_inserter(text), "({}, {}, {})", static_cast<float>(point.x()),
                 static_cast<float>(point.y()), static_cast<float>(point.z()));
}

// Of all masses that are asked for: "[(x, y, z), …]".
class UsdPoints {
 public:
  void add(const Vec3& point) {
    text_ += text_.empty() ? "[" : ", ";
    append_point(point, text_);
    low_ = low_.cwiseMin(point);
    high_ = high_.cwiseMax(point);
  }
  std::string points() const { return text_.empty() ? "[]" : text_ + "]"; }
  std::string extent() const {
    if (text_.empty()) return "[(0, 0, 0), (0, 0, 0)]";
    std::string text = "[";
    append_point(low_, text);
    text += ", ";
    append_point(high_, text);
    return text + "]";
  }

 private:
  std::string text_;
  Vec3 low_ = Vec3::Constant(infinity), high_ = Vec3::Constant(-infinity);
};

std::string usd_list(const std::vector<Index>& numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string colour_attribute(const std::array<double, 3>& colour) {
  return fmt::format("        color3f[] primvars:displayColor = [({}, {}, {})]\n", colour[0], colour[1],
                     colour[2]);
}

std::string width_attribute(double width) {
  return fmt::format("        float[] widths = [{}] (\n            interpolation = \"constant\"\n        )\n",
                     static_cast<float>(width));
}

class UsdaExport : public MotionExport {
 public:
  UsdaExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject),
        write_(target.write),
        scratch_(target.folder),
        shape_(subject_.model, subject_.faces),
        size_(scene_size(subject_.model, subject_.start)) {
    names_.unique("scene");
    for (std::size_t i = 0; i < subject_.model.sheets.size(); ++i) add_mesh(i);
    add_curves();
    add_points();
  }

  void add(const ExportMoment& moment) override {
    const ExportShape& shape = shape_.at(moment.state);
    const double code = time_code(moment.state.time);
    if (codes_ == 0) first_code_ = code;
    last_code_ = code;
    ++codes_;
    for (std::size_t i = 0; i < meshes_.size(); ++i)
      if (subject_.faces[i]) put_mesh(*meshes_[i], i, shape, moment.state, code);
    put_curves(shape, moment.state, code);
    put_masses(shape, moment.state, code);
  }

  void finish() override {
    write_(head());
    for (const UsdPrim& prim : prims_)
      if (prim.has_points) write_prim(prim);
    write_("}\n");
  }

 private:
  void add_mesh(std::size_t sheet) {
    meshes_.push_back(nullptr);
    if (!subject_.faces[sheet]) return;
    meshes_.back() = &prims_.emplace_back(UsdPrim{
        fmt::format("    def Mesh \"{}\"\n    {{\n        uniform token subdivisionScheme = \"none\"\n"
                    "        uniform bool doubleSided = 1\n{}",
                    names_.unique(subject_.model.sheets[sheet].name),
                    colour_attribute(subject_.colours.sheets[sheet])),
        {{"int[] faceVertexCounts", {}},
         {"int[] faceVertexIndices", {}},
         {"point3f[] points", {}},
         {"float3[] extent", {}}}});
  }
  void add_curves() {
    curves_ = &prims_.emplace_back(UsdPrim{
        fmt::format("    def BasisCurves \"{}\"\n    {{\n        uniform token type = \"linear\"\n{}{}",
                    names_.unique("links"), width_attribute(4e-3 * size_),
                    colour_attribute(subject_.colours.links)),
        {{"int[] curveVertexCounts", {}}, {"point3f[] points", {}}, {"float3[] extent", {}}}});
  }
  void add_points() {
    points_ = &prims_.emplace_back(
        UsdPrim{fmt::format("    def Points \"{}\"\n    {{\n{}{}", names_.unique("masses"),
                            width_attribute(2e-2 * size_), colour_attribute(subject_.colours.masses)),
                {{"point3f[] points", {}}, {"float3[] extent", {}}}});
  }

  void put_mesh(UsdPrim& prim, std::size_t number, const ExportShape& shape, const State& state,
                double code) {
    const Sheet& sheet = subject_.model.sheets[number];
    if (shape_.changed()) {
      std::vector<Index> counts, corners;
      counts.reserve(shape.sheets[number].size());
      corners.reserve(4 * shape.sheets[number].size());
      for (const ExportFace& face : shape.sheets[number]) {
        counts.push_back(face.corners);
        for (std::size_t corner = 0; corner < face.corners; ++corner)
          corners.push_back(face.masses.at(corner) - sheet.first_mass);
      }
      put(prim.attributes[0], code, usd_list(counts));
      put(prim.attributes[1], code, usd_list(corners));
    }
    prim.has_points = true;
    UsdPoints points;
    for (Index mass = 0; mass < sheet.rows * sheet.columns; ++mass)
      points.add(state.position.at(sheet.first_mass + mass));
    put(prim.attributes[2], code, points.points());
    put(prim.attributes[3], code, points.extent());
  }

  void put_curves(const ExportShape& shape, const State& state, double code) {
    if (shape_.changed())
      put(curves_->attributes[0], code, usd_list(std::vector<Index>(shape.links.size(), 2)));
    curves_->has_points |= !shape.links.empty();
    UsdPoints points;
    for (const Index link : shape.links)
      for (const Index end : {subject_.model.links.a[link], subject_.model.links.b[link]})
        points.add(state.position.at(end));
    put(curves_->attributes[1], code, points.points());
    put(curves_->attributes[2], code, points.extent());
  }

  void put_masses(const ExportShape& shape, const State& state, double code) {
    points_->has_points |= !shape.masses.empty();
    UsdPoints points;
    for (const Index mass : shape.masses) points.add(state.position.at(mass));
    put(points_->attributes[0], code, points.points());
    put(points_->attributes[1], code, points.extent());
  }

  void put(UsdSamples& samples, double code, const std::string& value) {
    const std::string line = fmt::format("            {}: {},\n", code, value);
    samples.pieces.push_back({scratch_.size(), line.size()});
    scratch_.append(line);
  }

  // Frames of the film are whole numbers; what lies between them is not.
  double time_code(double time) const {
    const double code = (time - subject_.start.time) * subject_.rate.value(), whole = std::round(code);
    return std::abs(code - whole) < 1e-9 * std::max(1.0, whole) ? whole : code;
  }

  std::string head() const {
    const Eigen::Quaterniond turn = turn_to_y_up(subject_.model);
    return fmt::format(
        "#usda 1.0\n(\n    defaultPrim = \"scene\"\n    doc = {}\n    metersPerUnit = 1\n    upAxis = \"Y\"\n"
        "    timeCodesPerSecond = {}\n    framesPerSecond = {}\n    startTimeCode = {}\n    endTimeCode = "
        "{}\n)\n\n"
        "def Xform \"scene\"\n{{\n    quatd xformOp:orient = ({}, {}, {}, {})\n"
        "    uniform token[] xformOpOrder = [\"xformOp:orient\"]\n\n",
        usd_text(subject_.title), subject_.rate.value(), subject_.rate.value(), first_code_, last_code_,
        turn.w(), turn.x(), turn.y(), turn.z());
  }

  void write_prim(const UsdPrim& prim) const {
    write_(prim.head);
    for (const UsdSamples& samples : prim.attributes) {
      write_(fmt::format("        {}.timeSamples = {{\n", samples.declaration));
      for (const UsdSamples::Piece& piece : samples.pieces) scratch_.copy(piece.offset, piece.size, write_);
      write_("        }\n");
    }
    write_("    }\n\n");
  }

  ExportSubject subject_;
  std::function<void(std::string_view)> write_;
  ScratchFile scratch_;
  ShapeInTime shape_;
  double size_;  // m
  UsdNames names_;
  std::deque<UsdPrim> prims_;     // which stay where they are
  std::vector<UsdPrim*> meshes_;  // one a sheet; null for a net
  UsdPrim *curves_ = nullptr, *points_ = nullptr;
  std::size_t codes_ = 0;
  double first_code_ = 0.0, last_code_ = 0.0;
};

std::unique_ptr<MotionExport> make_usda(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<UsdaExport>(subject, target);
}

}  // namespace

const ExportFormat usda_format{.name = "usda",
                               .ending = ".usda",
                               .carries = "faces, links and lone masses over time, in single precision",
                               .summary = "text of OpenUSD, for Blender, Houdini, Omniverse and usdview",
                               .text = true,
                               .make = make_usda};

}  // namespace taut
