#include "geometry/link_runs.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace taut {
namespace {

// What tells lines apart: a chain or sheet by its number, a sheet's links by family and the way from the
// first mass to the second.
using Line = std::tuple<int, std::size_t, LinkFamily, Index>;

std::vector<Line> lines_of(const Model& model) {
  std::vector<Line> lines(model.links.size(), Line{0, 0, LinkFamily::structural, 0});
  for (std::size_t i = 0; i < model.chains.size(); ++i) {
    const Chain& chain = model.chains[i];
    for (Index link = chain.first_link; link < chain.first_link + chain.link_count; ++link)
      lines[link] = {1, i, LinkFamily::structural, 0};
  }
  for (std::size_t i = 0; i < model.sheets.size(); ++i) {
    const Sheet& sheet = model.sheets[i];
    const Index end = sheet.first_mass + sheet.mass_count;
    const auto within = [&](Index mass) { return mass >= sheet.first_mass && mass < end; };
    const std::size_t own = model.chains.size();
    for (std::size_t link = 0; link < lines.size(); ++link) {
      const Index a = model.links.a[link], b = model.links.b[link];
      if (within(a) && within(b) && std::get<0>(lines[link]) == 0)
        // Links of a mesh follow no lines: each is one of its own.
        lines[link] = {2, own + i, model.links.family[link],
                       sheet.is_mesh() ? static_cast<Index>(link) : b - a};
    }
  }
  return lines;
}

// For each link the one that goes on at its mass a, and at its mass b; no_link where the run ends.
using Next = std::vector<std::array<Index, 2>>;

Next next_links(const Model& model, const std::vector<bool>& drawn) {
  struct End {
    Index mass;
    Line line;
    Index link;
    std::size_t which;
  };
  const std::vector<Line> lines = lines_of(model);
  std::vector<End> ends;
  for (std::size_t link = 0; link < drawn.size(); ++link) {
    if (!drawn[link]) continue;
    ends.push_back({model.links.a[link], lines[link], static_cast<Index>(link), 0});
    ends.push_back({model.links.b[link], lines[link], static_cast<Index>(link), 1});
  }
  std::ranges::sort(ends, [](const End& x, const End& y) {
    return std::tie(x.mass, x.line, x.link) < std::tie(y.mass, y.line, y.link);
  });
  Next next(model.links.size(), {no_link, no_link});
  for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
    for (last = first + 1;
         last < ends.size() && ends[last].mass == ends[first].mass && ends[last].line == ends[first].line;)
      ++last;
    if (last - first != 2) continue;
    next[ends[first].link][ends[first].which] = ends[first + 1].link;
    next[ends[first + 1].link][ends[first + 1].which] = ends[first].link;
  }
  return next;
}

Index other_end(const Model& model, Index link, Index mass) {
  return model.links.a[link] == mass ? model.links.b[link] : model.links.a[link];
}

Index next_at(const Model& model, const Next& next, Index link, Index mass) {
  return next[link][model.links.a[link] == mass ? 0 : 1];
}

}  // namespace

std::vector<LinkRun> link_runs(const Model& model, const std::vector<bool>& drawn) {
  const Next next = next_links(model, drawn);
  std::vector<bool> taken(drawn.size(), false);
  std::vector<LinkRun> runs;
  for (std::size_t first = 0; first < drawn.size(); ++first) {
    if (!drawn[first] || taken[first]) continue;
    // Back to where the run begins; a ring has been gone round when the first link comes again.
    auto link = static_cast<Index>(first);
    Index mass = model.links.a[link];
    for (Index before = next_at(model, next, link, mass); before != no_link && before != first;
         before = next_at(model, next, link, mass)) {
      link = before;
      mass = other_end(model, link, mass);
    }
    LinkRun run;
    run.masses.push_back(mass);
    while (link != no_link && !taken[link]) {
      taken[link] = true;
      mass = other_end(model, link, mass);
      run.links.push_back(link);
      run.masses.push_back(mass);
      link = next_at(model, next, link, mass);
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<Index> knots(const Model& model, const std::vector<LinkRun>& runs) {
  std::vector<int> passing(model.masses.size());
  for (const LinkRun& run : runs)
    for (std::size_t i = run.closed() ? 1 : 0; i < run.masses.size(); ++i) ++passing[run.masses[i]];
  std::vector<Index> result;
  for (std::size_t mass = 0; mass < passing.size(); ++mass)
    if (passing[mass] > 1) result.push_back(static_cast<Index>(mass));
  return result;
}

}  // namespace taut
