// PLY (Greg Turk, "The PLY Polygon File Format"), binary: every mass is a vertex with its velocity, in the
// model's order; cells are faces, links edges.

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "base/bytes.h"
#include "export/binary.h"
#include "export/export_shape.h"
#include "export/formats.h"
#include "output/atomic_file.h"
#include "output/export.h"

namespace taut {
namespace {

std::string ply_header(const ExportMoment& moment, std::size_t masses, std::size_t faces, std::size_t edges) {
  std::string header =
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}, {} s\nelement vertex {}\n",
                  moment.frame, moment.state.time, masses);
  for (const char* property : {"x", "y", "z", "vx", "vy", "vz"})
    header += fmt::format("property double {}\n", property);
  header += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", faces);
  header += fmt::format("element edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n", edges);
  return header;
}

class PlyExport : public MotionExport {
 public:
  PlyExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject), folder_(target.folder), shape_(subject_.model, subject_.faces) {}

  void add(const ExportMoment& moment) override {
    const Model& model = subject_.model;
    const ExportShape& shape = shape_.at(moment.state);
    std::size_t faces = 0;
    for (const auto& sheet : shape.sheets) faces += sheet.size();
    std::string bytes = ply_header(moment, model.masses.size(), faces, shape.links.size());
    for (std::size_t i = 0; i < model.masses.size(); ++i) {
      append_bytes(moment.state.position.at(i), bytes);
      append_bytes(moment.state.velocity.at(i), bytes);
    }
    for (const auto& sheet : shape.sheets)
      for (const ExportFace& face : sheet) {
        append_bytes(face.corners, bytes);
        for (std::size_t corner = 0; corner < face.corners; ++corner)
          append_bytes(static_cast<std::int32_t>(face.masses.at(corner)), bytes);
      }
    for (const Index link : shape.links)
      for (const Index end : {model.links.a[link], model.links.b[link]})
        append_bytes(static_cast<std::int32_t>(end), bytes);
    write_file(folder_ / export_frame_name(moment.frame, ply_format.ending), bytes);
  }
  void finish() override {}

 private:
  ExportSubject subject_;
  std::filesystem::path folder_;
  ShapeInTime shape_;
};

std::unique_ptr<MotionExport> make_ply(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<PlyExport>(subject, target);
}

}  // namespace

const ExportFormat ply_format{
    .name = "ply",
    .ending = ".ply",
    .carries = "masses with velocities, faces and links of each frame, exactly",
    .summary = "a binary file a frame, for MeshLab, Blender and scripts",
    .layout = ExportLayout::file_a_frame,
    .writes = [](std::string_view name) { return is_export_frame_name(name, ".ply"); },
    .make = make_ply};

}  // namespace taut
