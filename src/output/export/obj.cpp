// Wavefront OBJ: every mass is a vertex, in the model's order, so that a vertex is the same mass in every
// frame; cells are faces, links lines, lone masses points.

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "export/export_shape.h"
#include "export/formats.h"
#include "export/obj_text.h"
#include "output/atomic_file.h"
#include "output/export.h"

namespace taut {
namespace {

class ObjExport : public MotionExport {
 public:
  ObjExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject),
        folder_(target.folder),
        shape_(subject_.model, subject_.faces),
        masses_(subject_.model.masses.size()) {
    std::iota(masses_.begin(), masses_.end(), 0U);
  }

  void add(const ExportMoment& moment) override {
    const std::string text =
        fmt::format("# frame {}, {} s\n", moment.frame, moment.state.time) +
        obj_text(subject_.model, moment.state.position, shape_.at(moment.state), masses_);
    write_file(folder_ / export_frame_name(moment.frame, obj_format.ending), text);
  }
  void finish() override {}

 private:
  ExportSubject subject_;
  std::filesystem::path folder_;
  ShapeInTime shape_;
  std::vector<Index> masses_;  // all
};

std::unique_ptr<MotionExport> make_obj(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<ObjExport>(subject, target);
}

// A name that is one word.
std::string obj_word(std::string name) {
  for (char& letter : name)
    if (static_cast<unsigned char>(letter) <= ' ') letter = '_';
  return name.empty() ? "sheet" : name;
}

}  // namespace

std::string obj_text(const Model& model, const Vectors& position, const ExportShape& shape,
                     const std::vector<Index>& masses) {
  std::string text = "o taut\n";
  std::vector<std::size_t> vertex(model.masses.size(), 0);  // of each mass; they are counted from 1
  std::size_t count = 0;
  for (const Index mass : masses) {
    vertex[mass] = ++count;
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", position.x[mass], position.y[mass],
                   position.z[mass]);
  }
  for (std::size_t i = 0; i < shape.sheets.size(); ++i) {
    if (shape.sheets[i].empty()) continue;
    fmt::format_to(std::back_inserter(text), "g {}\n", obj_word(model.sheets[i].name));
    for (const ExportFace& face : shape.sheets[i]) {
      text += 'f';
      for (std::size_t corner = 0; corner < face.corners; ++corner)
        fmt::format_to(std::back_inserter(text), " {}", vertex[face.masses.at(corner)]);
      text += '\n';
    }
  }
  if (!shape.links.empty()) text += "g links\n";
  for (const Index link : shape.links)
    fmt::format_to(std::back_inserter(text), "l {} {}\n", vertex[model.links.a[link]],
                   vertex[model.links.b[link]]);
  if (!shape.masses.empty()) text += "g masses\n";
  for (const Index mass : shape.masses) fmt::format_to(std::back_inserter(text), "p {}\n", vertex[mass]);
  return text;
}

const ExportFormat obj_format{
    .name = "obj",
    .ending = ".obj",
    .carries = "faces, links and lone masses of each frame, exactly",
    .summary = "a file a frame, for nearly every program",
    .layout = ExportLayout::file_a_frame,
    .writes = [](std::string_view name) { return is_export_frame_name(name, ".obj"); },
    .make = make_obj};

}  // namespace taut
