// The way in of chain_motion.cpp, for one set of vector instructions: included once for each. Puts links and
// their rows of the matrix together, block by block, and eliminates them from both ends to the middle.

#if defined(TAUT_HIGH_ORDER_CHAIN_ELIMINATION_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TAUT_HIGH_ORDER_CHAIN_ELIMINATION_INL_H
#undef TAUT_HIGH_ORDER_CHAIN_ELIMINATION_INL_H
#else
#define TAUT_HIGH_ORDER_CHAIN_ELIMINATION_INL_H
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "direct/link_matrices.h"
#include "direct/pivots-inl.h"
#include "high_order/chain_motion.h"
#include "high_order/sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

// What links are to be moved for: to be as long as they stay, or as they are, or to stop changing.
enum class Wanted { acceleration, length, speed };

// What a solve reads and writes: where a link or a mass has the number i, [i].
struct ChainArrays {
  const double* coupling;
  const double* inverse_mass;
  const double* length;
  AxesToWrite direction;
  double* passed;
  double* multiplier;  // and before, right sides, and what the elimination makes of them
  AxesToWrite moved;   // accelerations, positions or velocities
};

// A block's rows of the matrix: A_ii, and A_{i−1,i} of its links and the one behind them; and 1/δ_i, of the
// links before and behind it, too ([i + 1]).
struct BlockRows {
  double entry[most_block_links], shared[most_block_links + 1], inverse[most_block_links + 2];
};

// u of the lower mass less that of the higher one.
template <class D>
HWY_INLINE hn::Vec<D> across(D tag, const double* values) {
  return hn::Sub(hn::LoadU(tag, values), hn::LoadU(tag, values + 1));
}

// What a link's square of its length and its change (d·u or |u|²) make of it: (|d|² − l²)/2, or that change.
template <Wanted wanted, class D>
HWY_INLINE hn::Vec<D> right_side(D tag, hn::Vec<D> square, hn::Vec<D> change, const double* length) {
  if constexpr (wanted != Wanted::length) return change;
  const auto l = hn::LoadU(tag, length);
  return hn::Mul(hn::Set(tag, 0.5), hn::Sub(square, hn::Mul(l, l)));
}

// Which of a block's links to tell what they share with the one before them: [begin, end), where `count` is
// the one behind the block. What a half does not ask for is left to the other one, which may be at it.
struct Shared {
  std::size_t begin, end;
};
HWY_INLINE Shared shared_upwards(const ChainBlock& block) {
  return {0, block.count};
}
HWY_INLINE Shared shared_downwards(const ChainBlock& block) {
  return {1, block.count + 1};
}

// Directions, right sides and rows of a block's links, whose masses are where `position` says, and move so.
template <Wanted wanted>
HWY_INLINE void gather_links(const ChainBlock& block, Shared shared, const AxesToRead& position,
                             const AxesToRead& velocity, const ChainArrays& arrays, BlockRows& rows) {
  const std::size_t link = block.link;
  for_groups(Widest(), 0, block.count, [&](auto tag, std::size_t k) TAUT_INLINED {
    auto square = hn::Zero(tag), change = hn::Zero(tag);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto d = across(tag, position[axis] + k), u = across(tag, velocity[axis] + k);
      hn::StoreU(d, tag, arrays.direction[axis] + link + k);
      square = hn::Add(square, hn::Mul(d, d));
      change = hn::Add(change, hn::Mul(wanted == Wanted::speed ? d : u, u));
    }
    const double* weight = arrays.inverse_mass + block.mass + k;
    const auto weights = hn::Add(hn::LoadU(tag, weight), hn::LoadU(tag, weight + 1));
    hn::StoreU(hn::Mul(weights, square), tag, rows.entry + k);
    hn::StoreU(right_side<wanted>(tag, square, change, arrays.length + link + k), tag,
               arrays.multiplier + link + k);
  });
  for_groups(Widest(), shared.begin, shared.end, [&](auto tag, std::size_t k) TAUT_INLINED {
    auto along = hn::Zero(tag);
    for (const double* direction : arrays.direction) {
      const double* d = direction + link + k;
      along = hn::Add(along, hn::Mul(hn::LoadU(tag, d - 1), hn::LoadU(tag, d)));
    }
    hn::StoreU(hn::Mul(hn::LoadU(tag, arrays.coupling + link + k), along), tag, rows.shared + k);
  });
}

// What gravity adds at pins.
HWY_INLINE void add_falls(const ChainLinks& links, const ChainBlock& block, const ChainArrays& arrays) {
  const auto from = std::lower_bound(links.hung.begin(), links.hung.end(), std::pair{block.link, false});
  for (auto hung = from; hung != links.hung.end() && hung->first < block.link + block.count; ++hung) {
    double fall = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      fall += arrays.direction[axis][hung->first] * links.gravity[static_cast<Eigen::Index>(axis)];
    arrays.multiplier[hung->first] += hung->second ? -fall : fall;
  }
}

template <Wanted wanted>
HWY_INLINE void gather_block(const ChainLinks& links, const PhaseSums& at, const ChainBlock& block,
                             Shared shared, const ChainArrays& arrays, BlockRows& rows) {
  if constexpr (wanted == Wanted::acceleration) {
    constexpr std::size_t room = most_block_links + 1;
    double x[3][room], v[3][room];
    const SpreadWeights weights(at.sums);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for_phases(at, weights, axis, block.mass, block.mass + block.count + 1,
                 [&](auto tag, std::size_t i, auto position, auto velocity) TAUT_INLINED {
                   hn::StoreU(position, tag, x[axis] + (i - block.mass));
                   hn::StoreU(velocity, tag, v[axis] + (i - block.mass));
                 });
    gather_links<wanted>(block, shared, {x[0], x[1], x[2]}, {v[0], v[1], v[2]}, arrays, rows);
    add_falls(links, block, arrays);
  } else {
    const auto from = [&](const AxesToRead& axes) -> AxesToRead {
      return {axes[0] + block.mass, axes[1] + block.mass, axes[2] + block.mass};
    };
    gather_links<wanted>(block, shared, from(at.position), from(at.velocity), arrays, rows);
  }
}

// Asks for what the sums of so many masses from i on read: so memory works while links are eliminated.
HWY_INLINE void fetch_masses(const PhaseSums& at, std::size_t i, std::size_t count) {
  constexpr std::size_t line = 64 / sizeof(double);  // of the cache
  const auto fetch = [&](const double* values) TAUT_INLINED {
    for (std::size_t k = 0; k < count; k += line) hwy::Prefetch(values + k);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fetch(at.position[axis] + i);
    fetch(at.velocity[axis] + i);
    for (std::size_t j = 0; j < at.sums.count; ++j) fetch(at.sums.terms[j].axes[axis] + i);
  }
}

// The elimination of one half: of the front upwards, after the link before, and of the back downwards.
template <bool upwards>
class HalfElimination : public Elimination<upwards> {
 public:
  // Begins a block, whose rows are those from `row` on.
  HWY_INLINE void begin_block(const ChainBlock& block, BlockRows& rows, std::size_t row,
                              const ChainArrays& arrays) {
    constexpr std::size_t to_last = upwards ? 0 : 1;
    this->count_ = block.count;
    this->inverse_ = rows.inverse + 1 + row;
    this->inverse_[upwards ? -1 : static_cast<std::ptrdiff_t>(block.count)] = this->last_inverse_;
    this->rows_ = {rows.entry + row, rows.shared + row + to_last, rows.shared + row + to_last};
    passed_ = arrays.passed + block.link + to_last;
    multiplier_ = arrays.multiplier + block.link;
  }

  HWY_INLINE void invert(std::size_t first, const Continuants<upwards>& continuants) {
    Elimination<upwards>::invert(first, continuants);
    const std::size_t group = this->group(first);
    for_each_value(group, group + pivots_at_once, [&](auto tag, std::size_t i) TAUT_INLINED {
      hn::StoreU(hn::Mul(hn::LoadU(tag, this->rows_.tie + i), hn::LoadU(tag, this->inverse_ + i + before_)),
                 tag, passed_ + i);
    });
  }
  // The right side.
  HWY_INLINE void pass_on(std::size_t k) {
    const std::size_t i = this->place(k);
    last_right_ = multiplier_[i] - passed_[i] * last_right_;
    multiplier_[i] = last_right_ * this->inverse_[i];
  }
  HWY_INLINE void pass_on_alone(std::size_t k) {
    const std::size_t i = this->place(k);
    passed_[i] = this->rows_.tie[i] * this->last_inverse_;
    this->invert_next(k);
    pass_on(k);
  }

 private:
  // Where the link before lies in memory.
  static constexpr std::ptrdiff_t before_ = upwards ? -1 : 1;

  double last_right_ = 0.0;
  double *passed_ = nullptr, *multiplier_ = nullptr;
};

// One half from its end to the middle, for a thread of its own; returns the last pivot's inverse.
template <Wanted wanted, bool upwards>
HWY_INLINE double eliminate_half(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays) {
  BlockRows rows;
  HalfElimination<upwards> half;
  const std::vector<ChainBlock>& blocks = upwards ? links.front : links.back;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const ChainBlock& block = blocks[b];
    gather_block<wanted>(links, at, block, upwards ? shared_upwards(block) : shared_downwards(block), arrays,
                         rows);
    half.begin_block(block, rows, 0, arrays);
    const auto fetch = [&](std::size_t k) TAUT_INLINED {
      if (b + 1 < blocks.size()) fetch_masses(at, blocks[b + 1].mass + k, pivots_at_once);
    };
    eliminate(0, block.count, fetch, half);
  }
  return half.last_inverse();
}

struct LastInverses {
  double front = 0.0, back = 0.0;
};

// Both halves, in turn.
template <Wanted wanted>
HWY_INLINE LastInverses eliminate_halves(const ChainLinks& links, const PhaseSums& at,
                                         const ChainArrays& arrays) {
  BlockRows front_rows, back_rows;
  HalfElimination<true> on_front;
  HalfElimination<false> on_back;
  const ChainBlock none;
  for (std::size_t b = 0; b < std::max(links.front.size(), links.back.size()); ++b) {
    const ChainBlock& front = b < links.front.size() ? links.front[b] : none;
    const ChainBlock& back = b < links.back.size() ? links.back[b] : none;
    if (links.is_short) {
      gather_block<wanted>(links, at, links.whole, {0, links.whole.count + 1}, arrays, front_rows);
    } else {
      if (front.count > 0) gather_block<wanted>(links, at, front, shared_upwards(front), arrays, front_rows);
      if (back.count > 0) gather_block<wanted>(links, at, back, shared_downwards(back), arrays, back_rows);
    }
    on_front.begin_block(front, front_rows, 0, arrays);
    if (links.is_short)
      on_back.begin_block(back, front_rows, links.middle, arrays);
    else
      on_back.begin_block(back, back_rows, 0, arrays);
    const bool more = b + 1 < links.front.size() && b + 1 < links.back.size();
    const auto fetch = [&](std::size_t k) TAUT_INLINED {
      if (!more) return;
      fetch_masses(at, links.front[b + 1].mass + k, pivots_at_once);
      fetch_masses(at, links.back[b + 1].mass + k, pivots_at_once);
    };
    eliminate_both(0, front.count, back.count, fetch, on_front, on_back);
  }
  return {on_front.last_inverse(), on_back.last_inverse()};
}

// Where the halves meet: λ' = y' − p' λ and λ = y − p λ'.
HWY_INLINE void meet(const ChainLinks& links, const LastInverses& last, const ChainArrays& arrays) {
  const std::size_t middle = links.middle;
  if (middle == 0) return;
  double along = 0.0;
  for (const double* direction : arrays.direction) along += direction[middle - 1] * direction[middle];
  const double shared = links.coupling[middle] * along;
  const double to_front = shared * last.front, to_back = shared * last.back;
  arrays.passed[middle] = to_front;
  arrays.multiplier[middle] = (arrays.multiplier[middle] - to_back * arrays.multiplier[middle - 1]) /
                              mended_pivot(1.0 - to_front * to_back, 1.0);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
