// PC2, the point cache that Blender's Mesh Cache modifier reads: a head of twelve letters, the version 1, how
// many points, the first frame, frames a sample, how many samples; then the points of each sample, all in
// single precision. It deforms the mesh that lies beside it, which has the same points in the same order: the
// masses that are in faces or links, for Blender takes no vertices that are in neither.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "export/binary.h"
#include "export/export_shape.h"
#include "export/formats.h"
#include "export/obj_text.h"
#include "output/atomic_file.h"
#include "output/export.h"

namespace taut {
namespace {

constexpr std::string_view mesh_name = "mesh.obj", cache_name = "motion.pc2";

std::string pc2_head(std::size_t points, std::size_t samples) {
  std::string head("POINTCACHE2\0", 12);
  append_bytes(std::int32_t{1}, head);
  append_bytes(static_cast<std::int32_t>(points), head);
  append_bytes(1.0F, head);
  append_bytes(1.0F, head);
  append_bytes(static_cast<std::int32_t>(samples), head);
  return head;
}

class Pc2Export : public MotionExport {
 public:
  Pc2Export(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject), mesh_(target.folder / mesh_name), cache_(target.folder / cache_name) {
    const Model& model = subject_.model;
    ExportShape shape = export_shape(model, subject_.faces, subject_.start);
    for (Index mass = 0; mass < model.masses.size(); ++mass)
      if (!std::ranges::binary_search(shape.masses, mass)) masses_.push_back(mass);
    shape.masses.clear();
    write(mesh_, obj_text(model, subject_.start.position, shape, masses_));
    write(cache_, pc2_head(masses_.size(), subject_.times.size()));
  }

  void add(const ExportMoment& moment) override {
    std::string bytes;
    for (const Index mass : masses_) append_floats(moment.state.position.at(mass), bytes);
    write(cache_, bytes);
  }
  void finish() override {
    mesh_.commit();
    cache_.commit();
  }

 private:
  static void write(PendingFile& file, const std::string& bytes) {
    file.write(std::as_bytes(std::span(bytes)));
  }

  ExportSubject subject_;
  PendingFile mesh_, cache_;
  std::vector<Index> masses_;  // one a point
};

std::unique_ptr<MotionExport> make_pc2(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<Pc2Export>(subject, target);
}

}  // namespace

const ExportFormat pc2_format{
    .name = "pc2",
    .ending = ".pc2",
    .carries = "faces and links over time in single precision: a mesh, and what deforms it",
    .summary = "for Blender's Mesh Cache",
    .layout = ExportLayout::folder,
    .shows_breaks = false,
    .evenly = true,
    .writes = [](std::string_view name) { return name == mesh_name || name == cache_name; },
    .make = make_pc2};

}  // namespace taut
