#include "forces/springs.h"

#include <algorithm>
#include <cmath>

#include "base/vector_operations.h"
#include "methods/frequency.h"

namespace taut {

Springs gather_springs(const Model& model, const State& state, OneSided one_sided) {
  const bool all = one_sided == OneSided::taken;
  std::vector<Index> soft;
  for (const Index link : all ? links_with_a_free_end(model) : solvable_links(model))
    if (!model.links.rigid(link) && !state.broken(link)) soft.push_back(link);
  Springs springs{gather(model, soft), {}, {}, BendForces(model, state)};
  for (const Index link : soft) springs.stiffness.push_back(model.links.stiffness[link]);
  if (!all || !has_one_sided_links(model)) return springs;
  for (const Index link : soft) {
    const double length = model.links.length[link];
    springs.free_range.push_back(model.links.one_sided(link) ? model.links.free_range[link]
                                                             : FreeRange{length, length});
  }
  return springs;
}

bool any_damped(const Springs& springs) {
  return std::ranges::any_of(springs.links.damping, [](double damping) { return damping > 0.0; });
}

namespace {

// A spring's pull (N) and its direction.
struct Pull {
  double tension;
  Vec3 direction;
};

Pull pull_of(const Springs& springs, std::size_t i, const Vectors& position, const Vectors& velocity) {
  const Index a = springs.links.a[i], b = springs.links.b[i];
  const Vec3 difference = position.at(a) - position.at(b);
  const double distance = difference.norm();
  const Vec3 direction = distance > 0.0 ? Vec3(difference / distance) : Vec3::Zero();
  return {springs.stiffness[i] * springs.stretch(i, distance) +
              springs.links.damping[i] * direction.dot(velocity.at(a) - velocity.at(b)),
          direction};
}

}  // namespace

void spring_tensions(const Springs& springs, const Vectors& position, const Vectors& velocity,
                     std::vector<double>& tension) {
  tension.resize(springs.links.size());
  for (std::size_t i = 0; i < tension.size(); ++i)
    tension[i] = pull_of(springs, i, position, velocity).tension;
}

void kick_by_springs(const Springs& springs, double h, const Vectors& position, const Vectors& velocity,
                     Vectors& kicked, std::vector<double>& tension) {
  tension.resize(springs.links.size());
  for (std::size_t i = 0; i < tension.size(); ++i) {
    const Pull pull = pull_of(springs, i, position, velocity);
    tension[i] = pull.tension;
    const double impulse = -h * pull.tension;
    kicked.add(springs.links.a[i], (springs.links.weight_a[i] * impulse) * pull.direction);
    kicked.add(springs.links.b[i], -(springs.links.weight_b[i] * impulse) * pull.direction);
  }
  springs.bends.kick(h, position, kicked);
}

double highest_frequency(const Springs& springs, const Vectors& position) {
  if (springs.empty()) return 0.0;
  Vectors direction, still;
  still.resize(position.size());
  direction.resize(springs.links.size());
  for (std::size_t i = 0; i < direction.size(); ++i)
    direction.set(i, pull_of(springs, i, position, still).direction);
  // A start with a part along every mode: neighbours against each other, of unequal size.
  Vectors mode = still;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double size = (i % 2 == 0 ? 1.0 : -1.0) * (1.0 + 0.3 * std::sin(1.7 * static_cast<double>(i)));
    mode.set(i, Vec3(size, 0.9 * size, 1.1 * size));
  }
  double eigenvalue = 0.0;
  std::vector<double> pull(springs.links.size());
  for (int round = 0; round < 3000; ++round) {
    Vectors next = still;
    along_links(springs.links, direction, mode, pull);
    for (std::size_t i = 0; i < pull.size(); ++i) pull[i] *= springs.stiffness[i];
    apply_impulses(springs.links, direction, pull, next);
    springs.bends.add_product(position, mode, next);
    const double size = std::sqrt(squared_norm(next));
    if (size == 0.0) return 0.0;
    for (std::size_t i = 0; i < next.size(); ++i) next.set(i, next.at(i) / size);
    mode = std::move(next);
    const bool settled = std::abs(size - eigenvalue) <= 1e-9 * size;
    eigenvalue = size;
    if (settled && round > 20) break;
  }
  return std::sqrt(eigenvalue);
}

double highest_spring_frequency(const Model& model, const State& state) {
  return highest_frequency(gather_springs(model, state), state.position);
}

// In the coordinates √m x the matrix is M^(−1/2) K M^(−1/2), symmetric, with blocks of 3 × 3. A link adds k/m
// n nᵀ to the diagonal block of either end, and −k/√(m_a m_b) n nᵀ beside it. In the coordinates x the row of
// blocks of mass a sums to at most Σ (k/m_a + k/m_a) over its links to free masses, and Σ k/m_a over those to
// pins.
double spring_frequency_bound(const Model& model, const State& state) {
  const Springs springs = gather_springs(model, state);
  std::vector<double> sum(model.masses.size(), 0.0);
  const SystemLinks& links = springs.links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const double share = links.weight_a[i] > 0.0 && links.weight_b[i] > 0.0 ? 2.0 : 1.0;
    sum[links.a[i]] += share * springs.stiffness[i] * links.weight_a[i];
    sum[links.b[i]] += share * springs.stiffness[i] * links.weight_b[i];
  }
  springs.bends.add_rows(state.position, sum);
  double largest = 0.0;
  for (const double value : sum) largest = std::max(largest, value);
  return std::sqrt(largest);
}

}  // namespace taut
