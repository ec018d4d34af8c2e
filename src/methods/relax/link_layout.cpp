#include "relax/link_layout.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "relax/visit_parts.h"

namespace taut {
namespace {

template <class Real>
class LayingOut {
 public:
  LayingOut(const Model& model, const VisitOrder& order, Layout layout, double equal_weight)
      : model_(model), equal_weight_(equal_weight) {
    out_.layout = layout;
    out_.give_places(model, order.masses);
  }

  void add_section(const std::vector<VisitOrder::Run>& runs, const MassRange& masses) {
    const std::size_t begin = out_.stretches.size();
    // Slots without a link may lie over masses of its own, or, where no other thread is, over any.
    beside_begin_ = masses.end == 0 ? 0 : masses.begin;
    beside_end_ = masses.end == 0 ? out_.masses.size() : masses.end;
    for (const VisitOrder::Run& run : runs) add_run(run);
    out_.sections.push_back({begin, out_.stretches.size(), masses});
    find_reach(out_.sections.back());
  }

  LinkLayout<Real> result() { return std::move(out_); }

 private:
  static constexpr std::size_t at_once = links_at_once<Real>;
  static constexpr auto lanes = static_cast<std::ptrdiff_t>(at_once);

  // Apart by what they lack, so that each kind pays for no more than it has.
  void add_run(const VisitOrder::Run& run) {
    std::array<std::vector<Index>, 6> kinds;
    for (const Index link : run) kinds[kind_of(link)].push_back(link);
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      LinkStretch stretch;
      stretch.weighted = kind % 2 != 0;
      stretch.soft = kind >= 2;
      stretch.damped = kind >= 4;
      if (!stretch.weighted && out_.layout == Layout::packed) add_strided(kinds[kind], stretch);
      if (!stretch.weighted && out_.layout == Layout::split) add_adjoining(kinds[kind], stretch);
      if (!kinds[kind].empty()) add_stretch(kinds[kind], stretch);
    }
  }

  std::size_t kind_of(Index link) const {
    const Links& links = model_.links;
    const bool weighted = model_.masses.inverse_mass[links.a[link]] != equal_weight_ ||
                          model_.masses.inverse_mass[links.b[link]] != equal_weight_;
    const std::size_t softness = links.rigid(link) ? 0 : links.damping[link] > 0.0 ? 2 : 1;
    return 2 * softness + (weighted ? 1 : 0);
  }

  // Where the ends of a link between free masses lie.
  std::ptrdiff_t a(Index link) const { return out_.place[model_.links.a[link]]; }
  std::ptrdiff_t b(Index link) const { return out_.place[model_.links.b[link]]; }

  // The distance at which the ends of so many links as a kernel takes at once follow each other; 0 where they
  // don't.
  std::size_t stride_of(const Index* links) const {
    const std::ptrdiff_t stride = a(links[1]) - a(links[0]);
    if (stride <= 0) return 0;
    for (std::size_t i = 1; i < at_once; ++i)
      if (a(links[i]) - a(links[i - 1]) != stride || b(links[i]) - b(links[i - 1]) != stride) return 0;
    return static_cast<std::size_t>(stride);
  }

  // Takes out of some links between free masses those that lie at equal distances, as in rows of sheets and
  // in chains, and makes stretches of them.
  void add_strided(std::vector<Index>& links, const LinkStretch& kind) {
    constexpr std::size_t fewest = 4 * at_once;
    std::map<std::size_t, std::vector<Index>> by_stride;
    for (std::size_t i = 0; i < links.size();) {
      const std::size_t stride = i + at_once <= links.size() ? stride_of(&links[i]) : 0;
      const std::size_t count = stride == 0 ? 1 : at_once;
      by_stride[stride].insert(by_stride[stride].end(), &links[i], &links[i] + count);
      i += count;
    }
    links = std::move(by_stride[0]);
    for (const auto& [stride, strided] : by_stride) {
      if (stride == 0) continue;
      if (strided.size() < fewest) {
        links.insert(links.end(), strided.begin(), strided.end());
        continue;
      }
      LinkStretch stretch = kind;
      stretch.stride = stride * bytes_between<Real>(out_.layout);
      add_stretch(strided, stretch);
    }
  }

  // Takes out of some links between free masses those whose ends lie beside each other, and makes stretches
  // of them. Their vectors begin where those of masses do, so that no two of a colour lie over each other in
  // part, for which a processor would wait: where there is no link there is a gap, if there is room for it.
  // Those that would be alone among gaps are left.
  void add_adjoining(std::vector<Index>& links, const LinkStretch& kind) {
    std::map<std::pair<std::ptrdiff_t, std::ptrdiff_t>, std::vector<Index>> vectors;  // by first a, b - a
    for (const Index link : links) vectors[{a(link) / lanes * lanes, b(link) - a(link)}].push_back(link);
    std::vector<Index> alike, others;  // without gaps and as long as the first one; and not
    links.clear();
    for (const auto& [ends, those] : vectors) {
      const auto [first, between] = ends;
      if (2 * those.size() < at_once || (those.size() < at_once && !has_room(first, first + between))) {
        links.insert(links.end(), those.begin(), those.end());
        continue;
      }
      std::vector<Index>& all =
          !kind.soft && are_alike(alike.empty() ? those.front() : alike.front(), those) ? alike : others;
      const std::size_t begin = all.size();
      all.resize(begin + at_once, no_link);
      for (const Index link : those) all[begin + static_cast<std::size_t>(a(link) - first)] = link;
    }
    LinkStretch stretch = kind;
    stretch.stride = bytes_between<Real>(out_.layout);
    stretch.alike = true;
    if (!alike.empty()) add_stretch(alike, stretch);
    stretch.alike = false;
    if (!others.empty()) add_stretch(others, stretch);
  }

  // Whether these fill a vector, each as long as this one.
  bool are_alike(Index one, const std::vector<Index>& those) const {
    const std::vector<double>& length = model_.links.length;
    return those.size() == at_once &&
           std::ranges::all_of(those, [&](Index link) { return length[link] == length[one]; });
  }

  // Whether there can be slots without a link in a vector whose ends lie from these places on. As they write
  // back what they have read, its ends must lie apart, and over no masses of other threads.
  bool has_room(std::ptrdiff_t first_a, std::ptrdiff_t first_b) const {
    const auto [low, high] = std::minmax(first_a, first_b);
    return high - low >= lanes && low >= static_cast<std::ptrdiff_t>(beside_begin_) &&
           high + lanes <= static_cast<std::ptrdiff_t>(beside_end_);
  }

  void add_stretch(const std::vector<Index>& links, LinkStretch stretch) {
    stretch.begin = out_.visited.size();
    stretch.special = out_.special.size();
    stretch.ends = out_.a.size();
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (stretch.stride == 0)
        add_ends(out_.place_of(model_, model_.links.a[links[i]]),
                 out_.place_of(model_, model_.links.b[links[i]]));
      else if (i % at_once == 0)
        add_first_ends(&links[i], stretch.stride / bytes_between<Real>(out_.layout));
      add_slot(links[i], links[i] == no_link ? -1.0 : model_.links.length[links[i]], stretch);
      if (stretch.stride != 0 && links[i] != no_link) ++out_.adjoining;
    }
    if (out_.visited.size() % at_once != 0) {
      out_.fillers.push_back(out_.places);
      out_.places += 2;
      while (out_.visited.size() % at_once != 0) {
        add_ends(out_.fillers.back(), out_.fillers.back() + 1);
        add_slot(no_link, 1.0, stretch);
      }
    }
    stretch.end = out_.visited.size();
    out_.stretches.push_back(stretch);
  }

  // Of the first link of a vector, or where its ends would be if it is a gap.
  void add_first_ends(const Index* links, std::size_t places_between) {
    std::size_t i = 0;
    while (links[i] == no_link) ++i;
    add_ends(out_.place[model_.links.a[links[i]]] - i * places_between,
             out_.place[model_.links.b[links[i]]] - i * places_between);
  }

  void add_ends(std::size_t a_place, std::size_t b_place) {
    const std::size_t between = bytes_between<Real>(out_.layout);
    out_.a.push_back(static_cast<std::uint32_t>(a_place * between));
    out_.b.push_back(static_cast<std::uint32_t>(b_place * between));
  }

  void add_slot(Index link, double length, const LinkStretch& stretch) {
    out_.length.push_back(static_cast<Real>(length));
    out_.visited.push_back(link);
    if (stretch.weighted || stretch.soft) out_.special.push_back(link);
  }

  // What each stretch of a section, and those before and after it, may touch of the free masses.
  void find_reach(const LinkSection& section) {
    std::size_t begun = section.masses.begin, done = section.masses.end;
    const auto visit_free = [&](const LinkStretch& stretch, const auto& visit) {
      for (std::size_t slot = stretch.begin; slot < stretch.end; ++slot)
        for (const auto* ends : {out_.a.data(), out_.b.data()})
          if (const std::size_t place =
                  end_offset<Real>(ends, stretch, slot) / bytes_between<Real>(out_.layout);
              place < out_.masses.size())
            visit(place);
    };
    for (std::size_t i = section.begin; i < section.end; ++i) {
      visit_free(out_.stretches[i], [&](std::size_t place) { begun = std::max(begun, place + 1); });
      out_.stretches[i].begun = begun;
    }
    for (std::size_t i = section.end; i-- > section.begin;) {
      out_.stretches[i].done = done;
      visit_free(out_.stretches[i], [&](std::size_t place) { done = std::min(done, place); });
    }
  }

  const Model& model_;
  double equal_weight_;
  std::size_t beside_begin_ = 0, beside_end_ = 0;
  LinkLayout<Real> out_;
};

}  // namespace

template <class Real>
LinkLayout<Real> lay_out_links(const Model& model, const VisitOrder& order, Layout layout,
                               double equal_weight, std::size_t threads) {
  LayingOut<Real> laying_out(model, order, layout, equal_weight);
  const VisitParts parts = share_out(model, order, threads);
  for (const VisitParts::Part& part : parts.parts)
    laying_out.add_section(part.runs, {part.begin, part.end, part.settled_begin, part.settled_end});
  if (parts.parts.size() > 1) laying_out.add_section(parts.rest, {});
  return laying_out.result();
}

template LinkLayout<double> lay_out_links(const Model&, const VisitOrder&, Layout, double, std::size_t);
template LinkLayout<float> lay_out_links(const Model&, const VisitOrder&, Layout, double, std::size_t);

}  // namespace taut
