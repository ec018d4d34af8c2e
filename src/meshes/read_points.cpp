#include "meshes/read_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "base/hash.h"
#include "base/nearest.h"
#include "file_bytes.h"
#include "meshes/table.h"
#include "model/turned.h"

namespace taut {
namespace {

constexpr double farthest_point = 1e6, heaviest = 1e12, stiffest = 1e15;  // m and m/s, kg, N/m and N

constexpr std::array<std::string_view, 10> mass_headings{"name", "x",  "y",    "z",      "vx",
                                                         "vy",   "vz", "mass", "radius", "pinned"};
constexpr std::array<std::string_view, 7> link_headings{
    "a", "b", "length", "stiffness", "damping", "break_stretch", "break_tension"};
// Of tables that this program writes, beside those.
constexpr std::array<std::string_view, 10> mass_exports{"frame", "time", "mass", "name", "x",
                                                        "y",     "z",    "vx",   "vy",   "vz"};
constexpr std::array<std::string_view, 10> link_exports{
    "frame", "time", "link", "a", "b", "rest_length", "length", "strain", "tension", "broken_at"};

// What is read of one table: where its columns are, and what its fields may be.
class Columns {
 public:
  Columns(const Table& table, std::span<const std::string_view> known,
          std::span<const std::string_view> exported)
      : table_(table), exported_(table.column("frame") != Table::no_column) {
    const auto allowed = exported_ ? exported : known;
    for (const TableField& heading : table.headings()) {
      if (std::ranges::find(allowed, heading.text) != allowed.end()) continue;
      const std::string hint = did_you_mean(nearest_name(heading.text, allowed));
      table.fail(heading, fmt::format("there is no column {} here{}{}", in_quotes(heading.text),
                                      hint.empty() ? "" : "; ", hint));
    }
    if (exported_) check_one_moment();
  }

  bool exported() const { return exported_; }

  double needed(std::size_t row, std::string_view heading, double most) const {
    const auto value = within(row, heading, -most, most);
    if (!value) table_.fail(table_.field(row, needed_column(heading)), fmt::format("{} is missing", heading));
    return *value;
  }

  // Of the column that there must be.
  std::size_t needed_column(std::string_view heading) const {
    const std::size_t column = table_.column(heading);
    if (column == Table::no_column)
      table_.fail(table_.headings().front(), fmt::format("there is no column {}", in_quotes(heading)));
    return column;
  }

  std::optional<double> within(std::size_t row, std::string_view heading, double least, double most) const {
    const std::size_t column = table_.column(heading);
    const std::optional<double> value = table_.number(row, column);
    if (value && !(*value >= least && *value <= most))
      table_.fail(table_.field(row, column),
                  fmt::format("{} must be from {:.6g} to {:.6g}, not {}", heading, least, most, *value));
    return value;
  }

  // What is divided by, and is not to be 0.
  std::optional<double> above(std::size_t row, std::string_view heading, double bound, double most) const {
    const auto value = within(row, heading, bound, most);
    if (value && !(*value - bound >= smallest_divisor))
      table_.fail(table_.field(row, table_.column(heading)),
                  fmt::format("{} must be above {}, not {}", heading, bound, *value));
    return value;
  }

 private:
  void check_one_moment() const {
    const std::size_t frame = table_.column("frame");
    for (std::size_t row = 1; row < table_.row_count(); ++row)
      if (table_.field(row, frame).text != table_.field(0, frame).text)
        table_.fail(table_.field(row, frame),
                    "another moment begins here: export one alone, as with --times 0");
  }

  const Table& table_;
  bool exported_;
};

bool is_pinned_in(const Table& table, std::size_t row) {
  const std::size_t column = table.column("pinned");
  if (column == Table::no_column) return false;
  const TableField& field = table.field(row, column);
  if (field.text == "true" || field.text == "1") return true;
  if (field.text.empty() || field.text == "false" || field.text == "0") return false;
  table.fail(field, fmt::format("pinned must be 0, 1, false or true, not {}", in_quotes(field.text)));
}

std::vector<PointsData::Mass> masses_of(const Table& table, const PointsSpec& spec) {
  const Columns columns(table, mass_headings, mass_exports);
  for (const std::string_view axis : {"x", "y", "z"}) columns.needed_column(axis);
  const std::size_t name = table.column("name");
  const Eigen::Matrix3d turn = turned(spec.turn);
  std::unordered_map<std::string_view, std::size_t> rows;
  std::vector<PointsData::Mass> masses;
  masses.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    PointsData::Mass mass;
    const auto at = [&](std::string_view heading) { return columns.needed(row, heading, farthest_point); };
    const auto speed = [&](std::string_view heading) {
      return columns.within(row, heading, -farthest_point, farthest_point).value_or(0.0);
    };
    mass.position = spec.position + turn * Vec3(at("x"), at("y"), at("z"));
    mass.velocity = turn * Vec3(speed("vx"), speed("vy"), speed("vz"));
    if (!columns.exported()) mass.mass = columns.above(row, "mass", 0.0, heaviest);
    mass.radius = columns.within(row, "radius", 0.0, farthest_point);
    mass.pinned = is_pinned_in(table, row);
    mass.name = name == Table::no_column ? std::to_string(row) : table.field(row, name).text;
    if (name != Table::no_column) {
      if (mass.name.empty()) table.fail(table.field(row, name), "the name is missing");
      const auto [known, is_new] = rows.try_emplace(table.field(row, name).text, row);
      if (!is_new)
        table.fail(table.field(row, name),
                   fmt::format("the name {} is in line {} already", in_quotes(mass.name),
                               table.field(known->second, name).line));
    }
    masses.push_back(std::move(mass));
  }
  return masses;
}

// Finds masses by their names, or by their numbers where no mass has that as its name.
class MassFinder {
 public:
  MassFinder(const std::vector<PointsData::Mass>& masses, const std::string& called)
      : masses_(masses), called_(called) {
    numbers_.reserve(masses.size());
    for (Index i = 0; i < masses.size(); ++i) numbers_.emplace(masses[i].name, i);
  }

  Index find(const Table& table, const TableField& field) const {
    if (const auto found = numbers_.find(field.text); found != numbers_.end()) return found->second;
    Index number = 0;
    const char* const last = field.text.data() + field.text.size();
    const auto [end, code] = std::from_chars(field.text.data(), last, number);
    if (code == std::errc{} && end == last && number < masses_.size()) return number;
    std::vector<std::string_view> names;
    names.reserve(masses_.size());
    for (const PointsData::Mass& mass : masses_) names.emplace_back(mass.name);
    const std::string hint = did_you_mean(nearest_name(field.text, names));
    table.fail(field, fmt::format("{} has no mass {}{}{}", called_, in_quotes(field.text),
                                  hint.empty() ? "" : "; ", hint));
  }

 private:
  const std::vector<PointsData::Mass>& masses_;
  const std::string& called_;
  std::unordered_map<std::string_view, Index> numbers_;
};

std::vector<PointsData::Link> links_of(const Table& table, const PointsSpec& spec,
                                       const std::vector<PointsData::Mass>& masses) {
  const Columns columns(table, link_headings, link_exports);
  const std::size_t a = columns.needed_column("a"), b = columns.needed_column("b");
  const MassFinder finder(masses, spec.masses);
  std::vector<PointsData::Link> links;
  links.reserve(table.row_count());
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    if (columns.exported() && table.number(row, table.column("broken_at"))) continue;
    PointsData::Link link{finder.find(table, table.field(row, a)), finder.find(table, table.field(row, b))};
    const TableField& second = table.field(row, b);
    if (link.a == link.b)
      table.fail(second, fmt::format("a link can't join {} to itself", in_quotes(second.text)));
    if (!((masses[link.a].position - masses[link.b].position).norm() >= smallest_divisor))
      table.fail(second, fmt::format("{} and {} are at the same point, so their link has no direction",
                                     in_quotes(table.field(row, a).text), in_quotes(second.text)));
    link.length = columns.above(row, columns.exported() ? "rest_length" : "length", 0.0, farthest_point);
    link.stiffness = columns.above(row, "stiffness", 0.0, stiffest);
    link.damping = columns.within(row, "damping", 0.0, stiffest);
    if (link.damping.value_or(0.0) > 0.0 && !link.stiffness && !spec.properties.stiffness)
      table.fail(table.field(row, table.column("damping")),
                 "damping needs a stiffness: a rigid link has no speed to damp");
    link.break_stretch = columns.above(row, "break_stretch", 1.0, 1e6);
    link.break_tension = columns.above(row, "break_tension", 0.0, stiffest);
    links.push_back(link);
  }
  return links;
}

}  // namespace

PointsReading read_points(const std::filesystem::path& masses, const std::filesystem::path& links,
                          const PointsSpec& spec) {
  PointsReading reading;
  PointsData data;
  const std::string bytes = file_bytes(masses, spec.masses);
  Hash hash;
  hash.add(bytes);
  data.masses = masses_of(Table(bytes, spec.masses), spec);
  if (data.masses.empty()) throw BadRequest(fmt::format("{}: there are no masses in it", spec.masses));
  if (!spec.links.empty()) {
    const std::string link_bytes = file_bytes(links, spec.links);
    hash.add("\n").add(link_bytes);
    data.links = links_of(Table(link_bytes, spec.links), spec, data.masses);
  }
  reading.content = hash.hex();
  reading.data = std::make_shared<const PointsData>(std::move(data));
  return reading;
}

}  // namespace taut
