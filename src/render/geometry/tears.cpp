#include "geometry/tears.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace taut {
namespace {

constexpr Index none = std::numeric_limits<Index>::max();

// How far tears leave the middles of links and cells, in cells: farther, and triangles would fold over.
constexpr float stray_on_link = 0.15F, stray_in_cell = 0.12F;

Index next(Index corner) {
  return (corner + 1) % 4;
}
Index before(Index corner) {
  return (corner + 3) % 4;
}

/// A mass of a sheet by row and column.
struct Node {
  int row = 0, column = 0;

  Node operator+(const Node& other) const { return {row + other.row, column + other.column}; }
  Node operator-() const { return {-row, -column}; }
};

// What of a sheet is whole.
struct Whole {
  const SheetLattice& sheet;
  const std::vector<bool>& broken;

  Index mass(const Node& node) const {
    return sheet.mass(static_cast<Index>(node.row), static_cast<Index>(node.column));
  }
  bool has(const Node& node) const {
    return node.row >= 0 && node.column >= 0 && node.row < static_cast<int>(sheet.rows) &&
           node.column < static_cast<int>(sheet.columns);
  }
  // Whether a whole link leads from a mass to its neighbour that way.
  bool joins(const Node& node, const Node& way) const {
    const Node end = node + way;
    if (!has(node) || !has(end)) return false;
    const auto row = static_cast<Index>(std::min(node.row, end.row));
    const auto column = static_cast<Index>(std::min(node.column, end.column));
    return !broken[way.row == 0 ? sheet.link_across(row, column) : sheet.link_down(row, column)];
  }
};

CutEdge cut_edge(const Whole& whole, const Node& node, const Node& way, float share,
                 const std::vector<glm::vec3>& at_start) {
  CutEdge edge;
  edge.mass = edge.beside = whole.mass(node);
  edge.share = share;
  edge.length = way.row == 0 ? whole.sheet.cell.x : whole.sheet.cell.y;
  edge.at_start = at_start[whole.mass(node + way)] - at_start[edge.mass];
  const auto like = [&](const Node& from, const Node& to) {
    edge.like.at(static_cast<std::size_t>(edge.like_count++)) = {whole.mass(from), whole.mass(to)};
  };
  if (whole.joins(node, -way)) like(node + -way, node);
  for (const Node& aside : {Node{way.column, way.row}, Node{-way.column, -way.row}}) {
    if (!whole.joins(node, aside)) continue;
    edge.beside = whole.mass(node + aside);
    edge.beside_at_start = at_start[edge.beside] - at_start[edge.mass];
    if (whole.joins(node + aside, way)) like(node + aside, node + aside + way);
  }
  return edge;
}

// Numbers of the pair of cut edges of each broken link of a cell, made where the cell beside hasn't yet.
std::array<Index, 4> cuts_of(SurfaceTopology& topology, std::vector<Index>& cut_of_link, const Cloth& cloth,
                             const TornCell& torn) {
  const SheetLattice& sheet = cloth.sheets[torn.sheet];
  const Whole whole{sheet, topology.broken};
  const std::array<Index, 4> links = sheet.edges(torn.row, torn.column);
  const Node top_left{static_cast<int>(torn.row), static_cast<int>(torn.column)};
  // The end of each edge that is the upper or left one, and the way on from there.
  const std::array<Node, 4> ends{top_left, top_left + Node{1, 0}, top_left + Node{0, 1}, top_left};
  const std::array<Node, 4> ways{Node{1, 0}, Node{0, 1}, Node{1, 0}, Node{0, 1}};
  std::array<Index, 4> cuts{none, none, none, none};
  for (std::size_t i = 0; i < 4; ++i) {
    const Index link = links[i];
    if (!topology.broken[link]) continue;
    if (cut_of_link[link] == none) {
      cut_of_link[link] = static_cast<Index>(topology.edges.size());
      const float share = 0.5F + stray_on_link * jitter(link, 0);
      topology.edges.push_back(cut_edge(whole, ends[i], ways[i], share, cloth.at_start));
      topology.edges.push_back(cut_edge(whole, ends[i] + ways[i], -ways[i], 1.0F - share, cloth.at_start));
      topology.edges[cut_of_link[link]].seed = 2 * link;
      topology.edges.back().seed = 2 * link + 1;
    }
    cuts[i] = cut_of_link[link];
  }
  return cuts;
}

// The cut edge that starts at a corner; along an edge to the right or below from corner 0 and 3, else back.
Index cut_from(const std::array<Index, 4>& cuts, Index edge, Index corner) {
  const bool second = edge == 0 ? corner == 1 : edge == 3 ? corner == 3 : corner == 2;
  return cuts[edge] + (second ? 1 : 0);
}

// Vertices along a whole edge from its corner to the next, without the last.
void add_edge(std::vector<Index>& loop, const FineCell& cell, Index edge) {
  const Index across = cell.fineness.across, down = cell.fineness.down;
  const Index steps = edge % 2 == 0 ? down : across;
  for (Index i = 0; i < steps; ++i)
    loop.push_back(edge == 0   ? cell.vertex(0, i)
                   : edge == 1 ? cell.vertex(i, down)
                   : edge == 2 ? cell.vertex(across, down - i)
                               : cell.vertex(across - i, 0));
}

Index corner_vertex(const FineCell& cell, Index corner) {
  return cell.vertex(corner >= 2 ? cell.fineness.across : 0,
                     corner == 1 || corner == 2 ? cell.fineness.down : 0);
}

glm::vec2 corner_place(Index corner) {
  return {corner >= 2 ? 1.0F : 0.0F, corner == 1 || corner == 2 ? 1.0F : 0.0F};
}

// Where in its cell a broken edge is cut.
glm::vec2 cut_place(const SurfaceTopology& topology, const std::array<Index, 4>& cuts, Index edge) {
  const float share = topology.edges[cut_from(cuts, edge, edge)].share;
  return glm::mix(corner_place(edge), corner_place(next(edge)), share);
}

// Cuts cells once all cut edges are there.
struct Cutter {
  SurfaceTopology& topology;
  const Cloth& cloth;
  std::vector<SurfacePlace>& places;
  std::vector<Index>& indices;
  Index first_edge, first_middle, first_corner;
  Index corners_a_line;

  SurfacePlace torn_place(const TornCell& torn, const glm::vec2& in_cell, const glm::vec2& light) const {
    SurfacePlace place = place_on_sheet(cloth, torn.sheet, glm::vec2(torn.column, torn.row) + in_cell, light);
    place.edges.z = 0.0F;
    return place;
  }

  // The line from where an edge is cut to the middle as one side sees it: vertices, the edge's first.
  std::vector<Index> line(const TornCell& torn, const CutMiddle& middle, Index edge, Index corner,
                          const glm::vec2& middle_light) {
    const Index cut = cut_from(middle.cuts, edge, corner);
    const Index link = cloth.sheets[torn.sheet].edges(torn.row, torn.column)[edge];
    const glm::vec2 cut_at = cut_place(topology, middle.cuts, edge);
    const glm::vec2 way = corner_place(corner == edge ? next(edge) : edge) - corner_place(corner);
    const glm::vec2 cut_light = places[corner_vertex(torn.cell, corner)].light;
    places[first_edge + cut] = torn_place(torn, cut_at, cut_light);
    std::vector<Index> vertices{first_edge + cut};
    const auto middle_number = static_cast<Index>(topology.middles.size());
    for (Index i = corners_a_line; i > 0; --i) {
      const float along = static_cast<float>(i) / static_cast<float>(corners_a_line + 1);
      // The same chance on both sides, away from the one mass and towards the other; smaller where steps are.
      const float stray = (corners_a_line == 1 ? 0.10F : 0.05F) * jitter(link, 1 + 8 * edge + i);
      const bool from_first = cut % 2 == 0;
      const CutCorner place{middle_number, cut, along, from_first ? stray : -stray};
      vertices.push_back(first_corner + static_cast<Index>(topology.corners.size()));
      topology.corners.push_back(place);
      places[vertices.back()] = torn_place(torn, glm::mix(middle.place, cut_at, along) + place.aside * way,
                                           glm::mix(middle_light, cut_light, along));
    }
    return vertices;
  }

  void add(Index a, Index b, Index c) { indices.insert(indices.end(), {a, b, c}); }

  // The part of a torn cell from the corner after one broken edge to the next broken edge.
  void add_part(const TornCell& torn, const std::array<Index, 4>& cuts, Index broken_edge) {
    const SheetLattice& sheet = cloth.sheets[torn.sheet];
    std::vector<Index> path{next(broken_edge)};
    while (cuts[path.back()] == none) path.push_back(next(path.back()));

    CutMiddle middle{sheet.corners(torn.row, torn.column), {}, cuts, glm::vec2(0.5F), 0};
    const Index seed = middle.corners[0];
    middle.place += stray_in_cell * glm::vec2(jitter(seed, 5), jitter(seed, 6));
    for (const Index corner : path) middle.joined.at(corner) = true;
    middle.mass = middle.corners.at(path[path.size() / 2]);
    // Light is looked up where there surely is cloth: on the links that are whole.
    const glm::vec2 light = 0.5F * (places[corner_vertex(torn.cell, path[path.size() / 2])].light +
                                    places[corner_vertex(torn.cell, path[(path.size() - 1) / 2])].light);
    const Index centre = first_middle + static_cast<Index>(topology.middles.size());
    places[centre] = torn_place(torn, middle.place, light);
    const Index first = path.front(), last = path.back();
    const std::vector<Index> start = line(torn, middle, broken_edge, first, light);
    const std::vector<Index> end = line(torn, middle, last, last, light);
    topology.middles.push_back(middle);

    std::vector<Index> loop;
    for (const Index corner : path)
      if (corner != last) add_edge(loop, torn.cell, corner);
    loop.push_back(corner_vertex(torn.cell, last));
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) add(centre, loop[i], loop[i + 1]);
    add_fan(loop.front(), start, centre, true);
    add_fan(loop.back(), end, centre, false);
  }

  // Triangles from a corner to each piece of a ragged line.
  void add_fan(Index corner, std::vector<Index> line, Index centre, bool starts) {
    line.push_back(centre);
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      starts ? add(corner, line[i + 1], line[i]) : add(corner, line[i], line[i + 1]);
  }
};

// A vector turned as `from` has to be turned to point as `to`, both of unit length, by the shortest way.
glm::vec3 turned(const glm::vec3& vector, const glm::vec3& from, const glm::vec3& to) {
  const float cosine = glm::dot(from, to);
  if (cosine < -0.999F) return vector;
  const glm::vec3 both = from + to;
  return vector - both * (glm::dot(both, vector) / (1.0F + cosine)) + to * (2.0F * glm::dot(from, vector));
}

std::optional<glm::vec3> direction(const glm::vec3& way) {
  const float length = glm::length(way);
  if (!(length > 1e-12F)) return {};
  return way / length;
}

glm::vec3 place_of(const CutMiddle& middle, const std::vector<glm::vec3>& ways,
                   std::span<const glm::vec3> masses) {
  const auto place = [&](Index corner) { return masses[middle.corners[corner]]; };
  const auto way = [&](Index corner, Index edge) { return ways[cut_from(middle.cuts, edge, corner)]; };
  std::array<glm::vec3, 4> corners;
  for (Index i = 0; i < 4; ++i) {
    const Index opposite = next(next(i));
    const bool from_before = middle.joined[before(i)], from_next = middle.joined[next(i)];
    corners[i] = middle.joined[i]           ? place(i)
                 : from_before && from_next ? place(before(i)) + place(next(i)) - place(opposite)
                 : from_before              ? place(before(i)) + way(before(i), before(i))
                 : from_next                ? place(next(i)) + way(next(i), i)
                             : place(opposite) + way(opposite, opposite) + way(opposite, before(opposite));
  }
  const float right = middle.place.x;
  return glm::mix(glm::mix(corners[0], corners[3], right), glm::mix(corners[1], corners[2], right),
                  middle.place.y);
}

}  // namespace

void cut(SurfaceTopology& topology, const Cloth& cloth, std::span<const TornCell> torn,
         std::vector<SurfacePlace>& places, std::vector<Index>& indices) {
  std::vector<Index> cut_of_link(topology.broken.size(), none);
  std::vector<std::array<Index, 4>> cuts;
  Index parts = 0;
  for (const TornCell& cell : torn) {
    cuts.push_back(cuts_of(topology, cut_of_link, cloth, cell));
    parts += 4 - static_cast<Index>(std::count(cuts.back().begin(), cuts.back().end(), none));
  }
  const bool fine = cloth.fineness != Fineness{};
  const auto first = static_cast<Index>(places.size());
  const Index first_middle = first + static_cast<Index>(topology.edges.size());
  Cutter cutter{topology,
                cloth,
                places,
                indices,
                first,
                first_middle,
                first_middle + parts,
                fine ? Index{3} : Index{1}};
  places.resize(cutter.first_corner + std::size_t{2} * parts * cutter.corners_a_line);
  for (std::size_t i = 0; i < torn.size(); ++i)
    for (Index edge = 0; edge < 4; ++edge)
      if (cuts[i][edge] != none) cutter.add_part(torn[i], cuts[i], edge);
}

glm::vec3 way_of(const CutEdge& edge, std::span<const glm::vec3> masses, const glm::mat3& to_picture) {
  glm::vec3 way(0.0F);
  for (int i = 0; i < edge.like_count; ++i) {
    const glm::uvec2& pair = edge.like.at(static_cast<std::size_t>(i));
    way += (masses[pair.y] - masses[pair.x]) / static_cast<float>(edge.like_count);
  }
  const float most = 1.1F * edge.length, now = glm::length(way);
  if (now > 0.2F * edge.length) return now > most ? way * (most / now) : way;
  // Nothing beside it says where it goes: as at the start, turned along with the link that crosses it.
  way = to_picture * edge.at_start;
  const std::optional<glm::vec3> before = direction(to_picture * edge.beside_at_start);
  const std::optional<glm::vec3> after = direction(masses[edge.beside] - masses[edge.mass]);
  if (before && after) way = turned(way, *before, *after);
  const float length = glm::length(way);
  return length > most ? way * (most / length) : way;
}

std::vector<glm::vec3> places_of_tears(const SurfaceTopology& topology, std::span<const glm::vec3> masses,
                                       const glm::mat3& to_picture) {
  std::vector<glm::vec3> ways, places, middles;
  for (const CutEdge& edge : topology.edges) {
    ways.push_back(way_of(edge, masses, to_picture));
    places.push_back(masses[edge.mass] + edge.share * ways.back());
  }
  for (const CutMiddle& middle : topology.middles) middles.push_back(place_of(middle, ways, masses));
  const std::vector<glm::vec3> edges = places;
  places.insert(places.end(), middles.begin(), middles.end());
  for (const CutCorner& corner : topology.corners)
    places.push_back(glm::mix(middles[corner.middle], edges[corner.edge], corner.along) +
                     corner.aside * ways[corner.edge]);
  return places;
}

std::vector<Index> masses_of_tears(const SurfaceTopology& topology) {
  std::vector<Index> masses;
  for (const CutEdge& edge : topology.edges) masses.push_back(edge.mass);
  for (const CutMiddle& middle : topology.middles) masses.push_back(middle.mass);
  for (const CutCorner& corner : topology.corners) masses.push_back(topology.edges[corner.edge].mass);
  return masses;
}

}  // namespace taut
