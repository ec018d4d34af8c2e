#include "relax/visit_parts.h"

#include <algorithm>

namespace taut {
namespace {

// Below that, waiting for each other takes longer than the work.
constexpr std::size_t fewest_to_share = 4000;

constexpr std::size_t of_the_rest = static_cast<std::size_t>(-1);

// Which part a mass belongs to, by its place: the rest, once a link of the rest has touched it.
class Owners {
 public:
  Owners(const Model& model, const VisitOrder& order, const std::vector<VisitParts::Part>& parts)
      : model_(model), owner_(model.masses.size(), of_the_rest) {
    for (std::size_t part = 0; part < parts.size(); ++part)
      for (std::size_t place = parts[part].begin; place < parts[part].end; ++place)
        if (order.masses[place] != empty_place) owner_[order.masses[place]] = part;
  }

  std::size_t of(Index mass) const { return owner_[mass]; }

  // Whose a link is that is visited now.
  std::size_t visit(Index link) {
    const Index a = model_.links.a[link], b = model_.links.b[link];
    const std::size_t owner_a = owner_[model_.masses.pinned(a) ? b : a],
                      owner_b = owner_[model_.masses.pinned(b) ? a : b];
    if (owner_a == owner_b) return owner_a;
    owner_[a] = owner_[b] = of_the_rest;
    return of_the_rest;
  }

 private:
  const Model& model_;
  std::vector<std::size_t> owner_;
};

// From the middle outwards, until a mass of the rest.
void find_settled(const VisitOrder& order, const Owners& owners, VisitParts::Part& part) {
  const auto rests = [&](std::size_t place) {
    return order.masses[place] != empty_place && owners.of(order.masses[place]) == of_the_rest;
  };
  part.settled_begin = part.settled_end = part.begin + (part.end - part.begin) / 2;
  while (part.settled_begin > part.begin && !rests(part.settled_begin - 1)) --part.settled_begin;
  while (part.settled_end < part.end && !rests(part.settled_end)) ++part.settled_end;
}

}  // namespace

std::size_t threads_for(const Workers* workers, std::size_t links) {
  return workers != nullptr && links >= fewest_to_share ? static_cast<std::size_t>(workers->count()) : 1;
}

VisitParts share_out(const Model& model, const VisitOrder& order, std::size_t parts) {
  VisitParts shared;
  const std::size_t masses = order.masses.size();
  for (std::size_t part = 0; part < parts; ++part)
    shared.parts.push_back({masses * part / parts, masses * (part + 1) / parts, 0, 0, {}});
  Owners owners(model, order, shared.parts);
  for (const VisitOrder::Run& run : order.runs) {
    std::vector<VisitOrder::Run> shares(parts + 1);
    for (const Index link : run) shares[std::min(owners.visit(link), parts)].push_back(link);
    for (std::size_t part = 0; part <= parts; ++part)
      if (!shares[part].empty())
        (part < parts ? shared.parts[part].runs : shared.rest).push_back(std::move(shares[part]));
  }
  for (VisitParts::Part& part : shared.parts) find_settled(order, owners, part);
  return shared;
}

}  // namespace taut
