#include <algorithm>
#include <cstdlib>
#include <utility>

#include "forces/forces.h"
#include "high_order/chain_motion.h"

namespace taut {
namespace {

// Whether nothing acts on masses but gravity and rigid links.
bool hangs_freely(const Model& model) {
  return model.drag == 0.0 && !pushed_from_outside(model) && model.bends.empty();
}

// Rows of many links, or all of them as one.
std::vector<LinkRow> rows_of(const SystemLinks& links) {
  if (!links.rows.empty() || links.size() == 0) return links.rows;
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links.a[i] != links.a[0] + i || links.b[i] != links.b[0] + i) return {};
  return {{0, links.size(), links.a[0], links.b[0]}};
}

// Cuts a half into blocks, from its first link on.
std::vector<ChainBlock> blocks_of(const std::vector<LinkRow>& rows, std::size_t begin, std::size_t end) {
  std::vector<ChainBlock> blocks;
  for (const LinkRow& row : rows) {
    const std::size_t row_end = std::min(row.begin + row.count, end);
    for (std::size_t link = std::max(row.begin, begin); link < row_end; link += blocks.back().count)
      blocks.push_back({link, std::min(most_block_links, row_end - link),
                        std::min(row.a, row.b) + (link - row.begin), 0, 0});
  }
  return blocks;
}

// The links that are not the first of a row: the mass before them is between two links of it.
std::vector<bool> that_go_on(const std::vector<LinkRow>& rows, std::size_t links) {
  std::vector<bool> all(links + 1, true);
  for (const LinkRow& row : rows) all[row.begin] = false;
  all[links] = false;
  return all;
}

// What shares a mass, with its sign: links are directed from the higher mass to the lower one.
std::vector<double> couplings(const SystemLinks& links) {
  std::vector<double> coupling(links.size() + 1, 0.0);
  for (std::size_t i = 1; i < links.size(); ++i) {
    const auto ends = [&](std::size_t link) {
      const bool a_is_lower = links.a[link] < links.b[link];
      const std::pair a{links.a[link], links.weight_a[link]}, b{links.b[link], links.weight_b[link]};
      return a_is_lower ? std::pair{a, b} : std::pair{b, a};
    };
    const auto before = ends(i - 1), behind = ends(i);
    if (before.first.first == behind.first.first) coupling[i] += before.first.second;
    if (before.second.first == behind.second.first) coupling[i] += before.second.second;
    if (before.first.first == behind.second.first) coupling[i] -= before.first.second;
    if (before.second.first == behind.first.first) coupling[i] -= before.second.second;
  }
  return coupling;
}

// Who is moved with no block.
std::vector<SingleMass> singles_of(const Model& model, const SystemLinks& links, const ChainLinks& chain) {
  std::vector<SingleMass> all(model.masses.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].mass = i;
    all[i].pinned = model.masses.pinned(i);
  }
  const auto take = [&](std::size_t mass, std::size_t link, double pull) {
    SingleMass& single = all[mass];
    if (single.pinned) return;
    single.link[single.count] = link;
    single.pull[single.count++] = pull * model.masses.inverse_mass[mass];
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    take(std::min(links.a[i], links.b[i]), i, -1.0);
    take(std::max(links.a[i], links.b[i]), i, 1.0);
  }
  std::vector<bool> inner(all.size(), false);
  for (const auto* blocks : {&chain.front, &chain.back})
    for (const ChainBlock& block : *blocks)
      for (std::size_t k = block.inner_begin; k < block.inner_end; ++k) inner[block.mass + k] = true;
  std::erase_if(all, [&](const SingleMass& single) { return !single.pinned && inner[single.mass]; });
  return all;
}

}  // namespace

std::unique_ptr<ChainMotion> make_chain_motion(const Model& model, const LinkSystem& system,
                                               const std::shared_ptr<Workers>& workers) {
  const SystemLinks& links = system.links;
  if (!system.along_paths || !hangs_freely(model)) return nullptr;
  const std::vector<LinkRow> rows = rows_of(links);
  const auto neighbours = [](const LinkRow& row) { return row.a + 1 == row.b || row.b + 1 == row.a; };
  if (rows.empty() || !std::ranges::all_of(rows, neighbours)) return nullptr;

  ChainLinks chain;
  chain.count = links.size();
  chain.middle = links.size() / 2;
  chain.front = blocks_of(rows, 0, chain.middle);
  chain.back = blocks_of(rows, chain.middle, links.size());
  std::ranges::reverse(chain.back);
  const std::vector<bool> goes_on = that_go_on(rows, links.size());
  for (ChainBlock& block : chain.front) {
    block.inner_begin = 1;
    const std::size_t end = block.link + block.count;
    block.inner_end = block.count + (goes_on[end] ? 1 : 0);
  }
  for (ChainBlock& block : chain.back) {
    const bool has_first = block.link != chain.middle && goes_on[block.link];
    block.inner_begin = has_first ? 0 : 1;
    block.inner_end = block.count;
  }
  chain.is_short = rows.size() == 1 && links.size() <= most_block_links;
  if (chain.is_short) chain.whole = {0, chain.count, chain.back.back().mass - chain.middle, 0, 0};
  chain.coupling = couplings(links);
  chain.inverse_mass = model.masses.inverse_mass;
  chain.length = links.length;
  chain.singles = singles_of(model, links, chain);
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Index lower = std::min(links.a[i], links.b[i]), higher = std::max(links.a[i], links.b[i]);
    if (model.masses.pinned(lower) != model.masses.pinned(higher))
      chain.hung.emplace_back(i, model.masses.pinned(lower));
  }
  chain.gravity = model.gravity;
  return std::make_unique<ChainMotion>(std::move(chain), workers);
}

}  // namespace taut
