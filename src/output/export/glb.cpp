// glTF 2.0 in one binary file (Khronos Group, "glTF 2.0 Specification", .glb). The first instant is the mesh;
// each later one is a morph target, the way of every vertex from there, and the animation fades from one to
// the next: at the time of an instant its own weight is 1 and all others are 0, so there the places are exact
// to single precision, and between two instants every vertex goes straight.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/bytes.h"
#include "base/failure.h"
#include "base/json_text.h"
#include "export/binary.h"
#include "export/formats.h"
#include "export/glb_parts.h"
#include "export/scratch_file.h"
#include "output/export.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;
using Float3 = std::array<float, 3>;

// As the specification numbers them.
constexpr int of_float = 5126, of_uint = 5125, array_buffer = 34962, element_array_buffer = 34963;

// What viewers take as morph targets; also the weights, whose number grows as the square of this.
constexpr std::size_t most_instants = 2000;

Float3 as_floats(const Vec3& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

// Three numbers for each of many vertices, and the box around them.
struct GlbVertices {
  std::string bytes;
  Float3 low{}, high{};
  std::size_t count = 0;

  void add(const Float3& vertex) {
    if (count++ == 0) low = high = vertex;
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      low.at(i) = std::min(low.at(i), vertex.at(i));
      high.at(i) = std::max(high.at(i), vertex.at(i));
      append_bytes(vertex.at(i), bytes);
    }
  }
};

class GlbExport : public MotionExport {
 public:
  GlbExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject), write_(target.write), parts_(glb_parts(subject)), vertices_(target.folder) {
    check_size();
    first_places_.resize(parts_.size());
    first_normals_.resize(parts_.size());
    targets_.resize(parts_.size());
  }

  void add(const ExportMoment& moment) override {
    const bool first = times_.empty();
    times_.push_back(static_cast<float>(moment.state.time - subject_.times.front()));
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      std::vector<Vec3> places;
      places.reserve(parts_[i].masses.size());
      for (const Index mass : parts_[i].masses) places.push_back(moment.state.position.at(mass));
      Json attributes{{"POSITION", put(places, first, first_places_[i])}};
      const std::vector<Vec3> normals = glb_normals(parts_[i], moment.state.position);
      if (!normals.empty()) attributes["NORMAL"] = put(normals, first, first_normals_[i]);
      if (first)
        bases_.push_back(std::move(attributes));
      else
        targets_[i].push_back(std::move(attributes));
    }
  }

  void finish() override {
    const std::string corners = bytes_of_corners();
    const std::string times = bytes_of_times();
    const std::uint64_t weights = std::uint64_t{times_.size()} * (times_.size() - 1) * sizeof(float);
    const std::uint64_t binary = vertices_.size() + corners.size() + times.size() + weights;
    std::string json = json_text(description(corners.size(), times.size(), weights));
    json.append((4 - json.size() % 4) % 4, ' ');
    write_chunk_heads(json, binary);
    vertices_.copy(0, vertices_.size(), write_);
    write_(corners);
    write_(times);
    write_weights();
  }

 private:
  void check_size() const {
    if (subject_.times.size() > most_instants)
      throw BadRequest(
          fmt::format("glb keeps every instant as a morph target, and takes {} of them, not {}; --every "
                      "or --fps asks for fewer",
                      most_instants, subject_.times.size()));
    double vertices = 0.0;
    for (const GlbPart& part : parts_) vertices += static_cast<double>(part.masses.size());
    constexpr double most_bytes = 4e9, bytes_of_a_vertex = 2 * sizeof(Float3);
    if (vertices * bytes_of_a_vertex * static_cast<double>(subject_.times.size()) > most_bytes)
      throw BadRequest(
          "a glb file holds at most 4 GB, and this would be more; --every or --fps asks for fewer instants");
  }

  // The first time the vectors themselves, afterwards their ways from there. Gives the accessor's number.
  int put(const std::vector<Vec3>& vectors, bool first, std::vector<Float3>& at_first) {
    GlbVertices vertices;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      if (first) at_first.push_back(as_floats(vectors[i]));
      const Float3& from = at_first[i];
      vertices.add(first ? from : as_floats(vectors[i] - Vec3(from[0], from[1], from[2])));
    }
    Json accessor{{"bufferView", 0},
                  {"byteOffset", vertices_.size()},
                  {"componentType", of_float},
                  {"count", vertices.count},
                  {"type", "VEC3"},
                  {"min", vertices.low},
                  {"max", vertices.high}};
    vertices_.append(vertices.bytes);
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string bytes_of_corners() const {
    std::string bytes;
    for (const GlbPart& part : parts_)
      for (const std::uint32_t corner : part.corners) append_bytes(corner, bytes);
    return bytes;
  }

  std::string bytes_of_times() const {
    std::string bytes;
    for (const float time : times_) append_bytes(time, bytes);
    return bytes;
  }

  void write_chunk_heads(const std::string& json, std::uint64_t binary) const {
    constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A,
                            binary_chunk = 0x004E4942;
    constexpr std::uint64_t head_size = 12, chunk_head_size = 8;
    const std::uint64_t all = head_size + chunk_head_size + json.size() + chunk_head_size + binary;
    if (all > std::numeric_limits<std::uint32_t>::max())
      throw RunFailure(
          "a glb file holds at most 4 GB, and this would be more; --every or --fps asks for fewer instants");
    std::string head;
    for (const std::uint64_t number : {std::uint64_t{magic}, std::uint64_t{version}, all,
                                       std::uint64_t{json.size()}, std::uint64_t{json_chunk}})
      append_bytes(static_cast<std::uint32_t>(number), head);
    head += json;
    append_bytes(static_cast<std::uint32_t>(binary), head);
    append_bytes(binary_chunk, head);
    write_(head);
  }

  // One row an instant: the first is the mesh itself.
  void write_weights() const {
    for (std::size_t instant = 0; instant < times_.size(); ++instant) {
      std::string row;
      for (std::size_t target = 1; target < times_.size(); ++target)
        append_bytes(target == instant ? 1.0F : 0.0F, row);
      write_(row);
    }
  }

  Json description(std::size_t corners, std::size_t times, std::uint64_t weights) {
    Json views = Json::array();
    std::uint64_t offset = 0;
    const auto add_view = [&](std::uint64_t size, const Json& more) {
      Json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
      view.update(more);
      views.push_back(view);
      offset += size;
    };
    add_view(vertices_.size(), {{"byteStride", sizeof(Float3)}, {"target", array_buffer}});
    add_view(corners, {{"target", element_array_buffer}});
    if (times_.size() > 1) {
      add_view(times, Json::object());
      add_view(weights, Json::object());
    } else {
      offset += times;
    }
    Json json{{"asset", {{"version", "2.0"}, {"generator", "taut"}}}, {"scene", 0}};
    add_nodes(json);
    add_meshes(json);
    if (times_.size() > 1) add_animation(json);
    json["accessors"] = accessors_;
    json["bufferViews"] = views;
    json["buffers"] = Json::array({Json{{"byteLength", offset}}});
    return json;
  }

  // One node above all others, that turns what is up to y.
  void add_nodes(Json& json) const {
    const Eigen::Quaterniond turn = turn_to_y_up(subject_.model);
    Json children = Json::array(), nodes = Json::array();
    for (std::size_t i = 0; i < parts_.size(); ++i) children.push_back(i + 1);
    Json root{{"name", subject_.title}};
    if (turn.vec().norm() > 0.0) root["rotation"] = {turn.x(), turn.y(), turn.z(), turn.w()};
    if (!children.empty()) root["children"] = children;
    nodes.push_back(root);
    for (std::size_t i = 0; i < parts_.size(); ++i) nodes.push_back({{"name", parts_[i].name}, {"mesh", i}});
    json["scenes"] = Json::array({Json{{"nodes", Json::array({0})}}});
    json["nodes"] = nodes;
  }

  void add_meshes(Json& json) {
    std::uint64_t offset = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const GlbPart& part = parts_[i];
      Json primitive{{"attributes", bases_[i]},
                     {"indices", accessors_.size()},
                     {"mode", static_cast<int>(part.mode)},
                     {"material", i}};
      accessors_.push_back({{"bufferView", 1},
                            {"byteOffset", offset},
                            {"componentType", of_uint},
                            {"count", part.corners.size()},
                            {"type", "SCALAR"}});
      offset += part.corners.size() * sizeof(std::uint32_t);
      Json mesh{{"name", part.name}};
      if (times_.size() > 1) {
        primitive["targets"] = targets_[i];
        mesh["weights"] = std::vector<int>(times_.size() - 1, 0);
      }
      mesh["primitives"] = Json::array({primitive});
      json["meshes"].push_back(mesh);
      json["materials"].push_back(material(part));
    }
  }

  // Colours are linear there.
  static Json material(const GlbPart& part) {
    constexpr double display_exponent = 2.2, roughness = 0.85;
    Json colour = Json::array();
    for (const double channel : part.colour) colour.push_back(std::pow(channel, display_exponent));
    colour.push_back(1.0);
    return {{"name", part.name},
            {"doubleSided", true},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", colour}, {"metallicFactor", 0.0}, {"roughnessFactor", roughness}}}};
  }

  void add_animation(Json& json) {
    Json channels = Json::array();
    for (std::size_t i = 0; i < parts_.size(); ++i)
      channels.push_back({{"sampler", 0}, {"target", {{"node", i + 1}, {"path", "weights"}}}});
    const std::size_t input = accessors_.size();
    const std::array<float, 1> low{times_.front()}, high{times_.back()};
    accessors_.push_back({{"bufferView", 2},
                          {"componentType", of_float},
                          {"count", times_.size()},
                          {"type", "SCALAR"},
                          {"min", low},
                          {"max", high}});
    accessors_.push_back({{"bufferView", 3},
                          {"componentType", of_float},
                          {"count", times_.size() * (times_.size() - 1)},
                          {"type", "SCALAR"}});
    const Json sampler{{"input", input}, {"output", input + 1}, {"interpolation", "LINEAR"}};
    json["animations"] =
        Json::array({Json{{"name", "motion"}, {"channels", channels}, {"samplers", Json::array({sampler})}}});
  }

  ExportSubject subject_;
  std::function<void(std::string_view)> write_;
  std::vector<GlbPart> parts_;
  ScratchFile vertices_;
  std::vector<float> times_;                                       // s since the first instant
  std::vector<std::vector<Float3>> first_places_, first_normals_;  // of each part
  std::vector<Json> bases_, accessors_;
  std::vector<std::vector<Json>> targets_;  // of each part
};

std::unique_ptr<MotionExport> make_glb(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<GlbExport>(subject, target);
}

}  // namespace

const ExportFormat glb_format{
    .name = "glb",
    .ending = ".glb",
    .carries = "faces, links and lone masses over time, in single precision",
    .summary = "binary glTF with morph targets, for web pages, three.js and Blender",
    .shows_breaks = false,
    .make = make_glb};

}  // namespace taut
