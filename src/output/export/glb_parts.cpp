#include "export/glb_parts.h"

#include <map>
#include <numeric>
#include <utility>

namespace taut {
namespace {

GlbPart part_of_sheet(const ExportSubject& subject, std::size_t number,
                      const std::vector<ExportFace>& faces) {
  const Sheet& sheet = subject.model.sheets[number];
  GlbPart part{sheet.name,
               GlbMode::triangles,
               std::vector<Index>(sheet.rows * sheet.columns),
               {},
               subject.colours.sheets[number]};
  std::iota(part.masses.begin(), part.masses.end(), sheet.first_mass);
  part.corners.reserve(6 * faces.size());
  for (const ExportFace& face : faces)
    for (std::size_t third = 2; third < face.corners; ++third)
      for (const Index mass : {face.masses[0], face.masses.at(third - 1), face.masses.at(third)})
        part.corners.push_back(mass - sheet.first_mass);
  return part;
}

// The vertex of a mass in a part, which it gets where it has none.
std::uint32_t vertex_of(Index mass, GlbPart& part, std::map<Index, std::uint32_t>& vertices) {
  const auto [found, is_new] = vertices.try_emplace(mass, static_cast<std::uint32_t>(part.masses.size()));
  if (is_new) part.masses.push_back(mass);
  return found->second;
}

}  // namespace

std::vector<GlbPart> glb_parts(const ExportSubject& subject) {
  const ExportShape shape = export_shape(subject.model, subject.faces, subject.start);
  std::vector<GlbPart> parts;
  for (std::size_t i = 0; i < shape.sheets.size(); ++i)
    if (!shape.sheets[i].empty()) parts.push_back(part_of_sheet(subject, i, shape.sheets[i]));
  GlbPart links{"links", GlbMode::lines, {}, {}, subject.colours.links};
  std::map<Index, std::uint32_t> vertices;
  for (const Index link : shape.links)
    for (const Index end : {subject.model.links.a[link], subject.model.links.b[link]})
      links.corners.push_back(vertex_of(end, links, vertices));
  if (!links.corners.empty()) parts.push_back(std::move(links));
  GlbPart masses{"masses", GlbMode::points, shape.masses, std::vector<std::uint32_t>(shape.masses.size()),
                 subject.colours.masses};
  std::iota(masses.corners.begin(), masses.corners.end(), 0U);
  if (!masses.corners.empty()) parts.push_back(std::move(masses));
  return parts;
}

std::vector<Vec3> glb_normals(const GlbPart& part, const Vectors& position) {
  if (part.mode != GlbMode::triangles) return {};
  std::vector<Vec3> normals(part.masses.size(), Vec3::Zero());
  for (std::size_t i = 0; i + 2 < part.corners.size(); i += 3) {
    const std::uint32_t a = part.corners[i], b = part.corners[i + 1], c = part.corners[i + 2];
    const Vec3 origin = position.at(part.masses[a]);
    const Vec3 area = (position.at(part.masses[b]) - origin)
                          .cross(position.at(part.masses[c]) - origin);  // twice, along it
    for (const std::uint32_t corner : {a, b, c}) normals[corner] += area;
  }
  for (Vec3& normal : normals) {
    const double length = normal.norm();
    normal = length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::UnitZ());
  }
  return normals;
}

}  // namespace taut
