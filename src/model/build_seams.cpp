#include <fmt/format.h>

#include <algorithm>

#include "base/nearest.h"
#include "builder.h"
#include "name_patterns.h"

namespace taut {
namespace {

// Builds seams one after another and reports what is wrong with them.
class SeamBuilder {
 public:
  SeamBuilder(Builder& builder, std::vector<Problem>& problems)
      : builder_(builder), problems_(problems), names_(builder.model.masses) {}

  void add(const SeamSpec& spec, std::size_t index) {
    index_ = index;
    const std::size_t before = problems_.size();
    const std::vector<Index> links = spec.sheet.empty() ? between(spec) : across(spec);
    if (problems_.size() > before) return;
    if (links.empty()) {
      report("", "no link lies across the seam");
      return;
    }
    for (const Index link : links) give_way(spec, link);
    if (spec.break_at) builder_.break_links_at(*spec.break_at, links);
  }

 private:
  void report(std::string key, std::string message, std::string suggestion = "") {
    problems_.push_back({"seam", index_, std::move(key), std::move(message), std::move(suggestion)});
  }

  std::vector<bool> fitting(const std::vector<std::string>& patterns, std::string_view key) {
    std::vector<bool> in(builder_.model.masses.size(), false);
    for (const std::string& pattern : patterns) {
      const std::vector<Index>& masses = names_.fitting(pattern);
      for (const Index mass : masses) in[mass] = true;
      if (masses.empty())
        report(std::string(key), fmt::format("no mass is named \"{}\"", pattern),
               nearest_mass(pattern, builder_.model.masses, problems_));
    }
    return in;
  }

  std::vector<Index> between(const SeamSpec& spec) {
    const std::vector<bool> a = fitting(spec.a, "a"), b = fitting(spec.b, "b");
    return links_that([&](Index one, Index other) { return (a[one] && b[other]) || (a[other] && b[one]); });
  }

  std::vector<Index> across(const SeamSpec& spec) {
    const auto& sheets = builder_.model.sheets;
    const auto found = std::ranges::find(sheets, spec.sheet, &Sheet::name);
    if (found == sheets.end()) {
      std::vector<std::string_view> names;
      names.reserve(sheets.size());
      for (const Sheet& sheet : sheets)
        if (!sheet.is_mesh()) names.emplace_back(sheet.name);
      report("sheet", fmt::format("no sheet is named \"{}\"", spec.sheet),
             std::string(nearest_name(spec.sheet, names)));
      return {};
    }
    const Sheet& sheet = *found;
    if (sheet.is_mesh()) {
      report("sheet", fmt::format("\"{}\" is a mesh, which has no rows and columns: say between which masses "
                                  "the seam lies, with \"a\" and \"b\"",
                                  spec.sheet));
      return {};
    }
    const Index lines = spec.row ? sheet.rows : sheet.columns;
    const int line = spec.row ? *spec.row : *spec.column;
    if (line < 0 || static_cast<Index>(line) + 1 >= lines) {
      report(
          spec.row ? "row" : "column",
          fmt::format("the seam lies beyond line {}, and \"{}\" has lines 0 to {}: from 0 to {} there is one",
                      line, spec.sheet, lines - 1, lines - 2));
      return {};
    }
    const auto inside = [&](Index mass) {
      return mass >= sheet.first_mass && mass < sheet.first_mass + sheet.mass_count;
    };
    const auto is_beyond = [&](Index mass) {
      const Index place = mass - sheet.first_mass;
      return (spec.row ? place / sheet.columns : place % sheet.columns) > static_cast<Index>(line);
    };
    return links_that([&](Index one, Index other) {
      return inside(one) && inside(other) && is_beyond(one) != is_beyond(other);
    });
  }

  template <class Lies>
  std::vector<Index> links_that(const Lies& lies) const {
    std::vector<Index> links;
    for (Index link = 0; link < builder_.model.links.size(); ++link)
      if (lies(builder_.model.links.a[link], builder_.model.links.b[link])) links.push_back(link);
    return links;
  }

  void give_way(const SeamSpec& spec, Index link) {
    Links& links = builder_.model.links;
    if (spec.strength) builder_.weaken(link, *spec.strength);
    if (spec.break_stretch) links.break_stretch[link] = *spec.break_stretch;
    if (spec.break_tension) links.break_tension[link] = *spec.break_tension;
  }

  Builder& builder_;
  std::vector<Problem>& problems_;
  NamePatterns names_;
  std::size_t index_ = 0;
};

// Those that can break, in file order.
std::vector<Index> breakable(const Model& model) {
  std::vector<bool> timed(model.links.size(), false);
  for (const Change& change : model.changes)
    for (const Index link : change.links) timed[link] = true;
  std::vector<Index> links;
  for (Index link = 0; link < model.links.size(); ++link)
    if (timed[link] || model.links.break_stretch[link] < infinity ||
        model.links.break_tension[link] < infinity)
      links.push_back(link);
  return links;
}

}  // namespace

void add_seams(Builder& builder, const Description& description, std::vector<Problem>& problems) {
  if (description.seams.empty()) return;
  SeamBuilder seams(builder, problems);
  for (std::size_t i = 0; i < description.seams.size(); ++i) seams.add(description.seams[i], i);
  builder.model.breakable_links = breakable(builder.model);
}

}  // namespace taut
