// VTK's XML format of points, lines and polygons ("VTK File Formats", PolyData), a file a frame, and a list
// of them with their times (.pvd) that ParaView opens as one. Points are the masses in the model's order.

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "export/export_shape.h"
#include "export/formats.h"
#include "export/vtk_arrays.h"
#include "output/atomic_file.h"
#include "output/export.h"

namespace taut {

std::string VtkArrays::begin(std::string_view name, std::string_view type, int components) const {
  return fmt::format(
      R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" format="appended" offset="{}"/>)"
      "\n",
      type, name, components, appended_.size());
}

std::string VtkArrays::add(std::string_view name, const Vectors& vectors) {
  const std::string element = begin(name, type_of<double>(), 3);
  append_bytes(static_cast<std::uint64_t>(vectors.size() * 3 * sizeof(double)), appended_);
  for (std::size_t i = 0; i < vectors.size(); ++i) append_bytes(vectors.at(i), appended_);
  return element;
}

namespace {

constexpr std::string_view motion_name = "motion.pvd", links_name = "links.pvd", links_begin_with = "links-";

// Cells of one kind: the masses of all, one cell after the other, and where each ends.
struct VtkCells {
  std::vector<std::int64_t> masses, ends;

  void end_cell() { ends.push_back(static_cast<std::int64_t>(masses.size())); }
};

// What of a model a file shows.
struct VtkShape {
  VtkCells points, lines, faces;
  std::vector<Index> links;  // of the lines
};

VtkCells cells_of_links(const Model& model, const std::vector<Index>& links) {
  VtkCells cells;
  cells.masses.reserve(2 * links.size());
  for (const Index link : links) {
    cells.masses.insert(cells.masses.end(), {model.links.a[link], model.links.b[link]});
    cells.end_cell();
  }
  return cells;
}

VtkShape vtk_shape(const Model& model, const ExportShape& shape) {
  VtkShape cells;
  for (const Index mass : shape.masses) {
    cells.points.masses.push_back(mass);
    cells.points.end_cell();
  }
  cells.links = shape.links;
  cells.lines = cells_of_links(model, shape.links);
  for (const auto& sheet : shape.sheets)
    for (const ExportFace& face : sheet) {
      cells.faces.masses.insert(cells.faces.masses.end(), face.masses.begin(),
                                face.masses.begin() + face.corners);
      cells.faces.end_cell();
    }
  return cells;
}

VtkShape all_whole_links(const Model& model, const State& state) {
  VtkShape cells;
  for (Index link = 0; link < model.links.size(); ++link)
    if (!state.broken(link)) cells.links.push_back(link);
  cells.lines = cells_of_links(model, cells.links);
  return cells;
}

// What is known of each cell; of points and faces, which come before and after lines, nothing.
std::string cell_data(const Model& model, const ExportMoment& moment, const VtkShape& shape,
                      VtkArrays& arrays) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = shape.points.ends.size() + shape.links.size() + shape.faces.ends.size();
  std::vector<std::int64_t> number(count, -1);
  std::vector<std::int8_t> family(count, -1);
  std::vector<double> tension(count, unknown), strain(count, unknown);
  std::size_t cell = shape.points.ends.size();
  for (const Index link : shape.links) {
    number[cell] = link;
    family[cell] = static_cast<std::int8_t>(model.links.family[link]);
    strain[cell] = model.links.strain(link, link_distance(model, moment.state.position, link));
    if (moment.tension_known) tension[cell] = moment.state.tension[link];
    ++cell;
  }
  return arrays.add("link", number) + arrays.add("family", family) + arrays.add("tension", tension) +
         arrays.add("strain", strain);
}

std::string cells_element(std::string_view name, const VtkCells& cells, VtkArrays& arrays) {
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", name, arrays.add("connectivity", cells.masses),
                     arrays.add("offsets", cells.ends));
}

std::string vtp_file(const Model& model, const ExportMoment& moment, const VtkShape& shape) {
  VtkArrays arrays;
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<FieldData>\n"
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n"
      "</FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      moment.state.time, model.masses.size(), shape.points.ends.size(), shape.links.size(),
      shape.faces.ends.size());
  text += fmt::format("<PointData Vectors=\"velocity\">\n{}{}{}</PointData>\n",
                      arrays.add("velocity", moment.state.velocity), arrays.add("mass", model.masses.mass),
                      arrays.add("radius", model.masses.radius));
  text += fmt::format("<CellData>\n{}</CellData>\n", cell_data(model, moment, shape, arrays));
  text += fmt::format("<Points>\n{}</Points>\n", arrays.add("position", moment.state.position));
  text += cells_element("Verts", shape.points, arrays) + cells_element("Lines", shape.lines, arrays) +
          cells_element("Polys", shape.faces, arrays);
  text += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  return text + arrays.appended() + "\n</AppendedData>\n</VTKFile>\n";
}

std::string links_file_name(int frame) {
  return fmt::format("{}{}", links_begin_with, export_frame_name(frame, ".vtp").substr(6));
}

class VtpExport : public MotionExport {
 public:
  VtpExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject), folder_(target.folder), shape_(subject_.model, subject_.faces) {
    const ExportShape& shape = export_shape(subject_.model, subject_.faces, subject_.start);
    hides_links_ = shape.links.size() < subject_.model.links.size();
  }

  void add(const ExportMoment& moment) override {
    const Model& model = subject_.model;
    const std::string name = export_frame_name(moment.frame, vtp_format.ending);
    write_file(folder_ / name, vtp_file(model, moment, vtk_shape(model, shape_.at(moment.state))));
    list(moment.state.time, name, motion_);
    if (!hides_links_) return;
    write_file(folder_ / links_file_name(moment.frame),
               vtp_file(model, moment, all_whole_links(model, moment.state)));
    list(moment.state.time, links_file_name(moment.frame), links_);
  }
  void finish() override {
    write_list(motion_name, motion_);
    if (hides_links_) write_list(links_name, links_);
  }
  void end_early() override { finish(); }

 private:
  static void list(double time, const std::string& name, std::string& entries) {
    fmt::format_to(std::back_inserter(entries), "<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", time,
                   name);
  }
  void write_list(std::string_view name, const std::string& entries) const {
    write_file(folder_ / name,
               fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                           "byte_order=\"LittleEndian\">\n<Collection>\n{}</Collection>\n</VTKFile>\n",
                           entries));
  }

  ExportSubject subject_;
  std::filesystem::path folder_;
  ShapeInTime shape_;
  bool hides_links_ = false;  // the shape has not all of them, and they get files of their own
  std::string motion_, links_;
};

std::unique_ptr<MotionExport> make_vtp(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<VtpExport>(subject, target);
}

bool is_of_vtp(std::string_view name) {
  if (name == motion_name || name == links_name || is_export_frame_name(name, ".vtp")) return true;
  if (!name.starts_with(links_begin_with)) return false;
  return is_export_frame_name(fmt::format("frame-{}", name.substr(links_begin_with.size())), ".vtp");
}

}  // namespace

const ExportFormat vtp_format{
    .name = "vtp",
    .ending = ".vtp",
    .carries = "masses with velocities, faces, and links with tension and strain of each frame, exactly",
    .summary = "a file a frame and their times in motion.pvd, for ParaView and VTK",
    .layout = ExportLayout::file_a_frame,
    .writes = is_of_vtp,
    .make = make_vtp};

}  // namespace taut
