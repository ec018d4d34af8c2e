#include <fmt/format.h>

#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "export/formats.h"
#include "model/orientation.h"
#include "output/export.h"

namespace taut {
namespace {

// A name as a field of a table (RFC 4180): in quotes where it holds a comma, a quote or the end of a line,
// its own quotes doubled.
std::string csv_field(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char letter : name) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

std::string_view csv_header(ExportTable table) {
  switch (table) {
    case ExportTable::links:
      return "frame,time,link,a,b,rest_length,length,strain,tension,broken_at\n";
    case ExportTable::orientations:
      return "frame,time,mass,name,qw,qx,qy,qz\n";
    case ExportTable::energy:
      return "frame,time,kinetic,potential,elastic,total,pin_work,load_work,contact_work,broken_energy\n";
    case ExportTable::usual:
    case ExportTable::masses:
      break;
  }
  return "frame,time,mass,name,x,y,z,vx,vy,vz\n";
}

// A line a mass.
std::string mass_rows(const Model& model, const ExportMoment& moment) {
  const State& state = moment.state;
  std::string rows;
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    const Vec3 x = state.position.at(i), v = state.velocity.at(i);
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{},{},{}\n", moment.frame, state.time, i,
                   csv_field(model.masses.name[i]), x.x(), x.y(), x.z(), v.x(), v.y(), v.z());
  }
  return rows;
}

// A line a link. broken_at is empty while it is whole; length, strain and tension are empty from then on, and
// tension is wherever it isn't known.
std::string link_rows(const Model& model, const ExportMoment& moment) {
  const State& state = moment.state;
  std::string rows;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},", moment.frame, state.time, i,
                   csv_field(model.masses.name[model.links.a[i]]),
                   csv_field(model.masses.name[model.links.b[i]]), model.links.length[i]);
    if (state.broken(i)) {
      fmt::format_to(std::back_inserter(rows), ",,,{}\n", state.broken_at[i]);
      continue;
    }
    const double length = link_distance(model, state.position, i);
    fmt::format_to(std::back_inserter(rows), "{},{},{},\n", length, model.links.strain(i, length),
                   moment.tension_known ? fmt::format("{}", state.tension[i]) : "");
  }
  return rows;
}

// A line a mass: how its links have turned since the start, as a unit quaternion.
std::string orientation_rows(const Model& model, const State& start, const ExportMoment& moment) {
  std::string rows;
  const std::vector<Eigen::Quaterniond> turns = orientations(model, start, moment.state);
  for (std::size_t i = 0; i < turns.size(); ++i)
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{}\n", moment.frame, moment.state.time, i,
                   csv_field(model.masses.name[i]), turns[i].w(), turns[i].x(), turns[i].y(), turns[i].z());
  return rows;
}

// A line an instant (J): what there is, and what pins, loads, solids and broken links have given and taken
// until then.
std::string energy_rows(const ExportMoment& moment) {
  const RunMeasures& now = *moment.measures;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}\n", moment.frame, moment.state.time, now.energy.kinetic,
                     now.energy.potential, now.energy.elastic, now.energy.total(), now.pin_work,
                     now.load_work, now.contact_work, now.broken_energy);
}

// RFC 4180; SI, and every number with as many digits as tell it from its neighbours.
class CsvExport : public MotionExport {
 public:
  CsvExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject), write_(target.write) {
    write_(csv_header(subject_.table));
  }
  void add(const ExportMoment& moment) override { write_(rows(moment)); }
  void finish() override {}

 private:
  std::string rows(const ExportMoment& moment) const {
    switch (subject_.table) {
      case ExportTable::links:
        return link_rows(subject_.model, moment);
      case ExportTable::orientations:
        return orientation_rows(subject_.model, subject_.start, moment);
      case ExportTable::energy:
        return energy_rows(moment);
      case ExportTable::usual:
      case ExportTable::masses:
        break;
    }
    return mass_rows(subject_.model, moment);
  }

  ExportSubject subject_;
  std::function<void(std::string_view)> write_;
};

std::unique_ptr<MotionExport> make_csv(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<CsvExport>(subject, target);
}

}  // namespace

const ExportFormat csv_format{.name = "csv",
                              .ending = ".csv",
                              .carries = "masses, links, orientations or energies, exactly",
                              .summary = "a table, for any spreadsheet and script",
                              .text = true,
                              .streams = true,
                              .tables = true,
                              .make = make_csv};

}  // namespace taut
