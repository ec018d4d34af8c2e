#include "output/csv.h"

#include <fmt/format.h>

#include <iterator>

#include "model/orientation.h"

namespace taut {
namespace {

// A name as a field of a table (RFC 4180): in quotes where it holds a comma, a quote or the end of a line,
// its own quotes doubled.
std::string field(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string quoted = "\"";
  for (const char letter : name) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

}  // namespace

std::string mass_table_header() {
  return "frame,time,mass,name,x,y,z,vx,vy,vz\n";
}

std::string mass_table_rows(const Model& model, const State& state, int frame) {
  std::string rows;
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    const Vec3 x = state.position.at(i), v = state.velocity.at(i);
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{},{},{}\n", frame, state.time, i,
                   field(model.masses.name[i]), x.x(), x.y(), x.z(), v.x(), v.y(), v.z());
  }
  return rows;
}

std::string link_table_header() {
  return "frame,time,link,a,b,rest_length,length,strain,tension,broken_at\n";
}

std::string link_table_rows(const Model& model, const State& state, int frame, bool tension_known) {
  std::string rows;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},", frame, state.time, i,
                   field(model.masses.name[model.links.a[i]]), field(model.masses.name[model.links.b[i]]),
                   model.links.length[i]);
    if (state.broken(i)) {
      fmt::format_to(std::back_inserter(rows), ",,,{}\n", state.broken_at[i]);
      continue;
    }
    const double length = link_distance(model, state.position, i);
    fmt::format_to(std::back_inserter(rows), "{},{},{},\n", length, model.links.strain(i, length),
                   tension_known ? fmt::format("{}", state.tension[i]) : "");
  }
  return rows;
}

std::string orientation_table_header() {
  return "frame,time,mass,name,qw,qx,qy,qz\n";
}

std::string orientation_table_rows(const Model& model, const State& start, const State& state, int frame) {
  std::string rows;
  const std::vector<Eigen::Quaterniond> turns = orientations(model, start, state);
  for (std::size_t i = 0; i < turns.size(); ++i)
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{}\n", frame, state.time, i,
                   field(model.masses.name[i]), turns[i].w(), turns[i].x(), turns[i].y(), turns[i].z());
  return rows;
}

}  // namespace taut
