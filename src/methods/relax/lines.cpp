#include "relax/lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

namespace taut {
namespace {

constexpr std::size_t no_line = static_cast<std::size_t>(-1);

// A link on the way along a line: the end, 0 for a or 1 for b, at which the way leaves it.
struct LinkOnWay {
  Index link = no_link;
  std::size_t leaves_at = 0;
};

// Which link each one goes on into at either end.
class LinkPairs {
 public:
  LinkPairs(const Model& model, const std::vector<Index>& links)
      : links_(model.links), next_(model.links.size(), {no_link, no_link}), woven_(woven_links(model)) {
    std::vector<std::size_t> begin(model.masses.size() + 1, 0);
    for (const Index link : links) ++begin[links_.a[link] + 1], ++begin[links_.b[link] + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> around(begin.back());  // the links of mass after mass
    std::vector<std::size_t> end = begin;
    for (const Index link : links)
      for (const Index mass : {links_.a[link], links_.b[link]}) around[end[mass]++] = link;
    for (std::size_t mass = 0; mass < model.masses.size(); ++mass)
      if (!model.masses.pinned(mass))
        pair_at(static_cast<Index>(mass), std::span(around).subspan(begin[mass], end[mass] - begin[mass]));
  }

  Index mass_at(const LinkOnWay& at) const { return ends(at.link)[at.leaves_at]; }
  Index mass_before(const LinkOnWay& at) const { return ends(at.link)[1 - at.leaves_at]; }

  LinkOnWay next(const LinkOnWay& at) const {
    const Index link = next_[at.link][at.leaves_at];
    if (link == no_link) return {};
    return {link, links_.a[link] == mass_at(at) ? 1U : 0U};
  }

 private:
  // Which links are of sheets with rows and columns.
  static std::vector<bool> woven_links(const Model& model) {
    std::vector<bool> woven(model.links.size(), false);
    for (const Sheet& sheet : model.sheets)
      if (!sheet.is_mesh()) std::fill_n(woven.begin() + sheet.first_link, sheet.link_count, true);
    return woven;
  }
  std::array<Index, 2> ends(Index link) const { return {links_.a[link], links_.b[link]}; }
  std::size_t end_at(Index link, Index mass) const { return links_.a[link] == mass ? 0 : 1; }
  bool paired(Index link, Index mass) const { return next_[link][end_at(link, mass)] != no_link; }
  // How far on the other end is numbered.
  std::int64_t step(Index link, Index mass) const {
    return std::int64_t{ends(link)[1 - end_at(link, mass)]} - std::int64_t{mass};
  }
  void pair(Index one, Index other, Index mass) {
    next_[one][end_at(one, mass)] = other;
    next_[other][end_at(other, mass)] = one;
  }

  // `around`: the mass's links.
  void pair_at(Index mass, std::span<Index> around) {
    std::ranges::stable_sort(around, {}, [&](Index link) { return step(link, mass); });
    for (const Index link : around) {
      const std::int64_t opposite = -step(link, mass);
      if (opposite < 0) break;
      auto other = std::ranges::lower_bound(around, opposite, {}, [&](Index i) { return step(i, mass); });
      while (other != around.end() && step(*other, mass) == opposite && paired(*other, mass)) ++other;
      if (other != around.end() && step(*other, mass) == opposite) pair(link, *other, mass);
    }
    std::array<Index, 2> left{};
    std::size_t count = 0;
    for (const Index link : around)
      if (!paired(link, mass) && count++ < left.size()) left[count - 1] = link;
    // Round the corners of a sheet nothing goes on.
    if (count == left.size() && !(woven_[left[0]] && woven_[left[1]])) pair(left[0], left[1], mass);
  }

  const Links& links_;
  std::vector<std::array<Index, 2>> next_;
  std::vector<bool> woven_;
};

// Where the way that a link lies on begins, with its lowest link: at an end, or with that link where it is a
// ring.
LinkOnWay beginning(const LinkPairs& pairs, Index lowest) {
  LinkOnWay back{lowest, 0};
  for (LinkOnWay next = pairs.next(back); next.link != no_link; next = pairs.next(back)) {
    if (next.link == lowest) return {lowest, 1};
    back = next;
  }
  return {back.link, 1 - back.leaves_at};
}

// Adds the lines of a way.
void add_way(const Model& model, const LinkPairs& pairs, const LinkOnWay& first,
             std::vector<std::size_t>& last_line, LinkLines& lines) {
  const auto add_mass = [&](Index mass) {
    lines.masses.push_back(mass);
    if (!model.masses.pinned(mass)) last_line[mass] = lines.lines.size() - 1;
  };
  const auto begin_line = [&](const LinkOnWay& at) {
    lines.lines.push_back({lines.links.size(), lines.masses.size(), 0, at.link, 0});
    add_mass(pairs.mass_before(at));
  };
  begin_line(first);
  for (LinkOnWay at = first; at.link != no_link;) {
    if (last_line[pairs.mass_at(at)] == lines.lines.size() - 1) begin_line(at);
    LinkLine& line = lines.lines.back();
    lines.links.push_back(at.link);
    add_mass(pairs.mass_at(at));
    ++line.count;
    line.lowest = std::min(line.lowest, at.link);
    at = pairs.next(at);
    if (at.link == first.link) break;
  }
}

void give_colours(const Model& model, LinkLines& lines) {
  std::vector<std::vector<std::size_t>> used(model.masses.size());  // colours at each mass
  std::vector<std::size_t> last_line;                               // with a mass in which a colour is used
  for (std::size_t i = 0; i < lines.lines.size(); ++i) {
    LinkLine& line = lines.lines[i];
    for (const Index mass : lines.masses_of(line))
      for (const std::size_t colour : used[mass]) last_line[colour] = i;
    while (line.colour < last_line.size() && last_line[line.colour] == i) ++line.colour;
    if (line.colour == last_line.size()) last_line.push_back(no_line);
    for (const Index mass : lines.masses_of(line))
      if (!model.masses.pinned(mass)) used[mass].push_back(line.colour);
  }
  lines.colours = last_line.size();
}

}  // namespace

LinkLines lines_of(const Model& model, const std::vector<Index>& links) {
  const LinkPairs pairs(model, links);
  LinkLines lines;
  std::vector<bool> done(model.links.size(), false);
  std::vector<std::size_t> last_line(model.masses.size(), no_line);
  for (const Index link : links) {
    if (done[link]) continue;
    const std::size_t begin = lines.links.size();
    add_way(model, pairs, beginning(pairs, link), last_line, lines);
    for (std::size_t i = begin; i < lines.links.size(); ++i) done[lines.links[i]] = true;
  }
  std::ranges::sort(lines.lines, {}, &LinkLine::lowest);
  give_colours(model, lines);
  return lines;
}

}  // namespace taut
