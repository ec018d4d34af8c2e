// Points, edges and triangles, of sheets and of solids, each in a tree of boxes. A tree is cut into sections
// of parts that follow each other, and each section is a job of its own: it finds the pairs whose first part
// is in it, and sorts them. So what the jobs find, one after the other, is sorted whichever thread did which.

#include "model/face_pair_search.h"

#include <algorithm>
#include <limits>

namespace taut {
namespace {

constexpr std::size_t most_sections = 16;  // of a tree: some for each thread
constexpr std::size_t fewest_nodes_to_share = 1000;
constexpr double too_far = std::numeric_limits<double>::infinity();
enum : std::size_t { sheet_edges, sheet_triangles, sheet_points, solid_edges, solid_triangles, solid_points };

std::uint32_t first_of(std::uint64_t key) {
  return static_cast<std::uint32_t>(key >> 32U);
}
std::uint32_t second_of(std::uint64_t key) {
  return static_cast<std::uint32_t>(key);
}

}  // namespace

// The arguments of one search.
struct FacePairSearch::Query {
  const FaceMesh& mesh;
  const WholeFaces& whole;
  const std::vector<Vec3>& places;
  const std::vector<double>& rooms;
  std::size_t most;

  // Around the balls of some nodes, and what is kept free around them.
  template <std::size_t count>
  Bounds bounds_of(const std::array<std::uint32_t, count>& nodes) const {
    Bounds bounds;
    for (const std::uint32_t node : nodes)
      bounds.take_in(places[node],
                     rooms[node] + mesh.radius[node] + look_ahead * (mesh.radius[node] - mesh.core[node]));
    return bounds;
  }

  // The distance of a pair that can come into contact, or too_far.
  double near_enough(const FacePair& pair) const {
    const auto [a, b, c, d] = pair.nodes;
    if (!mesh.meet(mesh.group[a], mesh.group[d])) return too_far;
    const bool held = mesh.inverse_mass[a] == 0.0 && mesh.inverse_mass[b] == 0.0 &&
                      mesh.inverse_mass[c] == 0.0 && mesh.inverse_mass[d] == 0.0;
    if (held) return too_far;
    const double room = pair.edges ? std::max(rooms[a], rooms[b]) + std::max(rooms[c], rooms[d])
                                   : rooms[a] + std::max({rooms[b], rooms[c], rooms[d]});
    const double distance = nearest_gap(pair, places).distance;
    return distance <= watched_apart(mesh, pair) + room ? distance : too_far;
  }

  void keep_near(const FacePair& pair, std::uint32_t one, std::uint32_t other,
                 std::vector<KeyedPair>& found) const {
    if (found.size() > most) return;
    if (const double distance = near_enough(pair); distance < too_far)
      found.emplace_back((std::uint64_t{one} << 32U) | other, distance);
  }
};

// Those of sheets, or of solids, which do not meet each other; of these only what is near sheets at all.
void FacePairSearch::gather(const Query& query, const Bounds& sheets, std::size_t which, Parts& parts) {
  parts.numbers.clear();
  parts.bounds.clear();
  const bool of_solids = which >= solid_edges;
  const auto take = [&](const std::vector<std::uint32_t>& all, const auto& nodes_of) {
    for (const std::uint32_t part : all) {
      const auto& nodes = nodes_of(part);
      if (query.mesh.of_solid(nodes[0]) != of_solids) continue;
      const Bounds bounds = query.bounds_of(nodes);
      if (of_solids && !bounds.meets(sheets)) continue;
      parts.bounds.push_back(bounds);
      parts.numbers.push_back(part);
    }
  };
  if (which == sheet_edges || which == solid_edges)
    take(query.whole.edges, [&](std::uint32_t edge) { return query.mesh.edges[edge].nodes; });
  else if (which == sheet_triangles || which == solid_triangles)
    take(query.whole.triangles, [&](std::uint32_t triangle) { return query.mesh.triangles[triangle]; });
  else
    take(query.whole.points, [](std::uint32_t point) { return std::array{point}; });
  parts.tree.fill(parts.bounds);
}

// A job for each section of a tree, and of another one that follows it.
void FacePairSearch::make_jobs(const Parts& one, const Parts* other) {
  job_count_ = 0;
  for (const Parts* parts : {&one, other}) {
    if (parts == nullptr) continue;
    const std::size_t sections = parts->tree.sections(most_sections);
    jobs_.resize(std::max(jobs_.size(), job_count_ + sections));
    for (std::size_t section = 0; section < sections; ++section) {
      Job& job = jobs_[job_count_++];
      job.parts = parts;
      job.section = section;
      job.sections = sections;
    }
  }
}

void FacePairSearch::find_points(const Query& query, Job& job) const {
  const auto among = [&](const Parts& of_triangles) {
    job.parts->tree.visit_pairs(
        job.section, job.sections, of_triangles.tree, [&](std::uint32_t i, std::uint32_t j) {
          const std::uint32_t point = job.parts->numbers[i], triangle = of_triangles.numbers[j];
          const auto [a, b, c] = query.mesh.triangles[triangle];
          if (point == a || point == b || point == c) return;
          if (query.mesh.joins(point, {a, b, c})) return;
          query.keep_near({{point, a, b, c}, false}, point, triangle, job.found);
        });
  };
  among(parts_[sheet_triangles]);
  if (job.parts == &parts_[sheet_points]) among(parts_[solid_triangles]);
}

void FacePairSearch::find_edges(const Query& query, Job& job) const {
  const auto take = [&](std::uint32_t one, std::uint32_t other) {
    const auto [a, b] = query.mesh.edges[one].nodes;
    const auto [c, d] = query.mesh.edges[other].nodes;
    if (a == c || a == d || b == c || b == d) return;
    query.keep_near({{a, b, c, d}, true}, one, other, job.found);
  };
  const std::vector<std::uint32_t>&own = job.parts->numbers, &of_solids = parts_[solid_edges].numbers;
  job.parts->tree.visit_pairs(job.section, job.sections,
                              [&](std::uint32_t i, std::uint32_t j) { take(own[i], own[j]); });
  job.parts->tree.visit_pairs(job.section, job.sections, parts_[solid_edges].tree,
                              [&](std::uint32_t i, std::uint32_t j) { take(own[i], of_solids[j]); });
}

template <class Find>
void FacePairSearch::run(Workers* workers, const Find& find) {
  run_jobs(workers, job_count_, [&](std::size_t i) {
    jobs_[i].found.clear();
    find(jobs_[i]);
    std::ranges::sort(jobs_[i].found);
  });
}

// Appends what the jobs have found, in their order: make(first, second) gives the nodes.
template <class Make>
void FacePairSearch::take(Workers* workers, std::vector<FacePair>& pairs, const Make& make) const {
  std::array<std::size_t, 2 * most_sections> begin{};
  std::size_t end = pairs.size();
  for (std::size_t i = 0; i < job_count_; ++i) {
    begin.at(i) = end;
    end += jobs_[i].found.size();
  }
  pairs.resize(end);
  run_jobs(workers, job_count_, [&](std::size_t i) {
    std::size_t at = begin.at(i);
    for (const auto& [key, distance] : jobs_[i].found) {
      pairs[at] = make(first_of(key), second_of(key));
      pairs[at++].distance = distance;
    }
  });
}

void FacePairSearch::find(const FaceMesh& mesh, const WholeFaces& whole, const std::vector<Vec3>& places,
                          const std::vector<double>& rooms, std::size_t most, Workers* workers,
                          std::vector<FacePair>& pairs) {
  pairs.clear();
  if (mesh.size() < fewest_nodes_to_share) workers = nullptr;
  const Query query{mesh, whole, places, rooms, most};
  Bounds sheets;
  for (std::uint32_t node = 0; node < mesh.sheet_nodes; ++node)
    sheets.take_in(query.bounds_of(std::array{node}));
  run_jobs(workers, parts_.size(),
           [&](std::size_t which) { gather(query, sheets, which, parts_.at(which)); });

  make_jobs(parts_[sheet_points], &parts_[solid_points]);
  run(workers, [&](Job& job) { find_points(query, job); });
  take(workers, pairs, [&](std::uint32_t point, std::uint32_t triangle) {
    const auto& nodes = mesh.triangles[triangle];
    return FacePair{{point, nodes[0], nodes[1], nodes[2]}, false};
  });

  make_jobs(parts_[sheet_edges], nullptr);
  run(workers, [&](Job& job) { find_edges(query, job); });
  take(workers, pairs, [&](std::uint32_t one, std::uint32_t other) {
    const auto &a = mesh.edges[one].nodes, &b = mesh.edges[other].nodes;
    return FacePair{{a[0], a[1], b[0], b[1]}, true};
  });
}

}  // namespace taut
