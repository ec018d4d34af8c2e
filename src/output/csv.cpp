#include "output/csv.h"

#include <fmt/format.h>

#include <iterator>

#include "model/orientation.h"

namespace taut {

std::string mass_table_header() {
  return "frame,time,mass,name,x,y,z,vx,vy,vz\n";
}

std::string mass_table_rows(const Model& model, const State& state, int frame) {
  std::string rows;
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    const Vec3 x = state.position.at(i), v = state.velocity.at(i);
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},{},{},{},{}\n", frame, state.time, i,
                   model.masses.name[i], x.x(), x.y(), x.z(), v.x(), v.y(), v.z());
  }
  return rows;
}

std::string link_table_header() {
  return "frame,time,link,a,b,length,strain,tension,broken_at\n";
}

std::string link_table_rows(const Model& model, const State& state, int frame) {
  std::string rows;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    fmt::format_to(std::back_inserter(rows), "{},{},{},{},{},{},", frame, state.time, i,
                   model.masses.name[model.links.a[i]], model.masses.name[model.links.b[i]],
                   model.links.length[i]);
    if (state.broken(i))
      fmt::format_to(std::back_inserter(rows), ",,{}\n", state.broken_at[i]);
    else
      fmt::format_to(std::back_inserter(rows), "{},{},\n",
                     link_distance(model, state.position, i) / model.links.length[i] - 1.0, state.tension[i]);
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
                   model.masses.name[i], turns[i].w(), turns[i].x(), turns[i].y(), turns[i].z());
  return rows;
}

}  // namespace taut
