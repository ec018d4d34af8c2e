// The equations of motion of chains on which nothing acts but gravity and rigid links, in two passes over
// memory, made once for every set of vector instructions and chosen by the processor at hand.
//
// With d_i the vector along link i, w the inverse masses, and g alone acting, the multipliers follow from
//   A_ii λ_i + A_{i,i−1} λ_{i−1} + A_{i,i+1} λ_{i+1} = |ḋ_i|² ± d_i·g,
//   A_ii = (w + w') |d_i|²,   A_{i,i−1} = −w d_{i−1}·d_i,
// where g stands only at links that hang on a pin. On the way in, a block of masses is put together of the
// step's sums, then its links and their rows of the matrix, and then they are eliminated, from both ends at
// once (each pivot waits for the division by the one before: so two are under way):
//   δ_i = A_ii − A_{i,i−1}²/δ_{i−1},   r_i = b_i − (A_{i,i−1}/δ_{i−1}) r_{i−1},   y_i = r_i/δ_i.
// Without |ḋ|² and g, (|d|² − l²)/2 or d·ḋ on the right side give the way back onto links, and of velocities.
// The last two left, one from each end, meet as a system of two. On the way out λ_{i−1} = y_{i−1} −
// (A_{i,i−1}/δ_{i−1}) λ_i, and a mass between two links gets g + w (λ_{i−1} d_{i−1} − λ_i d_i).

#include "high_order/chain_motion.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "direct/link_matrices.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "high_order/chain_motion.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

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
  double* direction[3];
  double* passed;
  double* multiplier;  // and before, right sides, and what the elimination makes of them
  double* moved[3];    // accelerations, positions or velocities
};

// A block's rows of the matrix: A_ii, and A_{i−1,i} of its links and the one behind them.
struct BlockRows {
  double entry[most_block_links], shared[most_block_links + 1];
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

// Directions, right sides and rows of a block's links, whose masses are where `position` says, and move so.
template <Wanted wanted>
HWY_INLINE void gather_links(const ChainBlock& block, const double* const position[3],
                             const double* const velocity[3], const ChainArrays& arrays, BlockRows& rows) {
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
  for_groups(Widest(), 0, block.count + 1, [&](auto tag, std::size_t k) TAUT_INLINED {
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
                             const ChainArrays& arrays, BlockRows& rows) {
  if constexpr (wanted == Wanted::acceleration) {
    constexpr std::size_t room = most_block_links + 1;
    double x[3][room], v[3][room];
    for (std::size_t axis = 0; axis < 3; ++axis)
      for_phases(at, axis, block.mass, block.mass + block.count + 1,
                 [&](auto tag, std::size_t i, auto position, auto velocity) TAUT_INLINED {
                   hn::StoreU(position, tag, x[axis] + (i - block.mass));
                   hn::StoreU(velocity, tag, v[axis] + (i - block.mass));
                 });
    const double* const position[] = {x[0], x[1], x[2]};
    const double* const velocity[] = {v[0], v[1], v[2]};
    gather_links<wanted>(block, position, velocity, arrays, rows);
    add_falls(links, block, arrays);
  } else {
    const auto from = [&](const Axes& axes, std::size_t axis) { return axes[axis] + block.mass; };
    const double* const position[] = {from(at.position, 0), from(at.position, 1), from(at.position, 2)};
    const double* const velocity[] = {from(at.velocity, 0), from(at.velocity, 1), from(at.velocity, 2)};
    gather_links<wanted>(block, position, velocity, arrays, rows);
  }
}

// How far an elimination has come: the last pivot's inverse, and the right side there.
struct Elimination {
  double inverse = 0.0, right = 0.0;
};

HWY_INLINE void eliminate(double entry, double shared, double& passed, double& multiplier,
                          Elimination& last) {
  passed = shared * last.inverse;
  last.inverse = 1.0 / mended_pivot(entry - shared * shared * last.inverse, entry);
  last.right = multiplier - passed * last.right;
  multiplier = last.right * last.inverse;
}

// Asks for what the sums of the masses from i on read, as many as fit a line of the cache: so memory works
// while divisions are waited for.
HWY_INLINE void fetch_masses(const PhaseSums& at, std::size_t i) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    hwy::Prefetch(at.position[axis] + i);
    hwy::Prefetch(at.velocity[axis] + i);
    for (std::size_t j = 0; j < at.sums.count; ++j) hwy::Prefetch(at.sums.terms[j].axes[axis] + i);
  }
}

// From both ends to the middle.
template <Wanted wanted>
HWY_INLINE void eliminate_all(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays) {
  BlockRows front_rows, back_rows;
  Elimination from_front, from_back;
  const ChainBlock none;
  for (std::size_t b = 0; b < std::max(links.front.size(), links.back.size()); ++b) {
    const ChainBlock& front = b < links.front.size() ? links.front[b] : none;
    const ChainBlock& back = b < links.back.size() ? links.back[b] : none;
    const double *back_entry = back_rows.entry, *back_shared = back_rows.shared;
    if (links.is_short) {
      gather_block<wanted>(links, at, links.whole, arrays, front_rows);
      back_entry = front_rows.entry + links.middle;
      back_shared = front_rows.shared + links.middle;
    } else {
      if (front.count > 0) gather_block<wanted>(links, at, front, arrays, front_rows);
      if (back.count > 0) gather_block<wanted>(links, at, back, arrays, back_rows);
    }
    const auto step_front = [&](std::size_t k) TAUT_INLINED {
      const std::size_t i = front.link + k;
      eliminate(front_rows.entry[k], front_rows.shared[k], arrays.passed[i], arrays.multiplier[i],
                from_front);
    };
    const auto step_back = [&](std::size_t k) TAUT_INLINED {
      const std::size_t i = back.link + k;
      eliminate(back_entry[k], back_shared[k + 1], arrays.passed[i + 1], arrays.multiplier[i], from_back);
    };
    const std::size_t both = std::min(front.count, back.count);
    const bool more = b + 1 < links.front.size() && b + 1 < links.back.size();
    for (std::size_t k = 0; k < both; ++k) {
      if (more && k % 8 == 0) {
        fetch_masses(at, links.front[b + 1].mass + k);
        fetch_masses(at, links.back[b + 1].mass + k);
      }
      step_front(k);
      step_back(back.count - 1 - k);
    }
    for (std::size_t k = both; k < front.count; ++k) step_front(k);
    for (std::size_t k = both; k < back.count; ++k) step_back(back.count - 1 - k);
  }
  const std::size_t middle = links.middle;
  if (middle == 0) return;
  // λ' = y' − p' λ and λ = y − p λ'
  double along = 0.0;
  for (const double* direction : arrays.direction) along += direction[middle - 1] * direction[middle];
  const double shared = links.coupling[middle] * along;
  const double to_front = shared * from_front.inverse, to_back = shared * from_back.inverse;
  arrays.passed[middle] = to_front;
  arrays.multiplier[middle] = (arrays.multiplier[middle] - to_back * arrays.multiplier[middle - 1]) /
                              mended_pivot(1.0 - to_front * to_back, 1.0);
}

// What a mass has before links pull at it.
template <Wanted wanted>
HWY_INLINE const double* unmoved(const PhaseSums& at, std::size_t axis) {
  return wanted == Wanted::length ? at.position[axis] : at.velocity[axis];
}

// Moves the masses between a block's links.
template <Wanted wanted>
HWY_INLINE void move_block(const ChainLinks& links, const PhaseSums& at, const ChainBlock& block,
                           const ChainArrays& arrays) {
  const std::size_t link = block.link;
  for_groups(Widest(), block.inner_begin, block.inner_end, [&](auto tag, std::size_t k) TAUT_INLINED {
    const auto before = hn::LoadU(tag, arrays.multiplier + link + k - 1),
               behind = hn::LoadU(tag, arrays.multiplier + link + k);
    const auto weight = hn::LoadU(tag, arrays.inverse_mass + block.mass + k);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* d = arrays.direction[axis] + link + k;
      const auto pull = hn::Sub(hn::Mul(before, hn::LoadU(tag, d - 1)), hn::Mul(behind, hn::LoadU(tag, d)));
      auto from = hn::Set(tag, links.gravity[static_cast<Eigen::Index>(axis)]);
      if constexpr (wanted != Wanted::acceleration)
        from = hn::LoadU(tag, unmoved<wanted>(at, axis) + block.mass + k);
      hn::StoreU(hn::Add(from, hn::Mul(weight, pull)), tag, arrays.moved[axis] + block.mass + k);
    }
  });
}

template <Wanted wanted>
HWY_INLINE void move_single(const ChainLinks& links, const PhaseSums& at, const SingleMass& single,
                            const ChainArrays& arrays) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double to = single.pinned ? 0.0 : links.gravity[static_cast<Eigen::Index>(axis)];
    if constexpr (wanted != Wanted::acceleration) to = unmoved<wanted>(at, axis)[single.mass];
    for (std::size_t i = 0; i < single.count; ++i)
      to += single.pull[i] * (arrays.multiplier[single.link[i]] * arrays.direction[axis][single.link[i]]);
    arrays.moved[axis][single.mass] = to;
  }
}

// From the middle to both ends; returns 0, unless a multiplier is not finite.
template <Wanted wanted>
HWY_INLINE double substitute_all(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays) {
  double unsound = 0.0;
  double on_front = arrays.multiplier[links.middle], on_back = on_front;
  const ChainBlock none;
  for (std::size_t b = std::max(links.front.size(), links.back.size()); b-- > 0;) {
    const ChainBlock& front = b < links.front.size() ? links.front[b] : none;
    const ChainBlock& back = b < links.back.size() ? links.back[b] : none;
    const auto step_front = [&](std::size_t k) TAUT_INLINED {
      const std::size_t i = front.link + k;
      arrays.multiplier[i] = on_front = arrays.multiplier[i] - arrays.passed[i + 1] * on_front;
      unsound += 0.0 * on_front;
    };
    const auto step_back = [&](std::size_t k) TAUT_INLINED {
      const std::size_t i = back.link + k;
      if (i != links.middle)
        arrays.multiplier[i] = on_back = arrays.multiplier[i] - arrays.passed[i] * on_back;
      unsound += 0.0 * on_back;
    };
    const std::size_t both = std::min(front.count, back.count);
    for (std::size_t k = 0; k < both; ++k) {
      step_front(front.count - 1 - k);
      step_back(k);
    }
    for (std::size_t k = both; k < front.count; ++k) step_front(front.count - 1 - k);
    for (std::size_t k = both; k < back.count; ++k) step_back(k);
    if (links.is_short) {
      move_block<wanted>(links, at, links.whole, arrays);
    } else {
      move_block<wanted>(links, at, front, arrays);
      move_block<wanted>(links, at, back, arrays);
    }
  }
  for (const SingleMass& single : links.singles) move_single<wanted>(links, at, single, arrays);
  return unsound;
}

template <Wanted wanted>
HWY_INLINE double solve(const ChainLinks& links, const PhaseSums& at, ChainRoom& room,
                        std::vector<double>& multipliers, Vectors& moved) {
  const ChainArrays arrays{
      links.coupling.data(),
      links.inverse_mass.data(),
      links.length.data(),
      {room.direction[0].data() + 1, room.direction[1].data() + 1, room.direction[2].data() + 1},
      room.passed.data(),
      multipliers.data(),
      {moved.x.data(), moved.y.data(), moved.z.data()}};
  eliminate_all<wanted>(links, at, arrays);
  return substitute_all<wanted>(links, at, arrays);
}

double solve_accelerations(const ChainLinks& links, const PhaseSums& at, ChainRoom& room,
                           std::vector<double>& multipliers, Vectors& moved) {
  return solve<Wanted::acceleration>(links, at, room, multipliers, moved);
}
double solve_lengths(const ChainLinks& links, const PhaseSums& at, ChainRoom& room,
                     std::vector<double>& multipliers, Vectors& moved) {
  return solve<Wanted::length>(links, at, room, multipliers, moved);
}
double solve_speeds(const ChainLinks& links, const PhaseSums& at, ChainRoom& room,
                    std::vector<double>& multipliers, Vectors& moved) {
  return solve<Wanted::speed>(links, at, room, multipliers, moved);
}

// The largest right side of all links, over the square of their lengths, or over their lengths.
template <Wanted wanted>
HWY_INLINE double largest_error(const ChainLinks& links, const PhaseSums& at) {
  constexpr std::size_t lanes = hn::MaxLanes(Widest());
  HWY_ALIGN double largest[lanes] = {}, unsound[lanes] = {};
  for (const auto* half : {&links.front, &links.back})
    for (const ChainBlock& block : *half)
      for_groups(Widest(), 0, block.count, [&](auto tag, std::size_t k) TAUT_INLINED {
        auto square = hn::Zero(tag), change = hn::Zero(tag);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto d = across(tag, at.position[axis] + block.mass + k);
          square = hn::Add(square, hn::Mul(d, d));
          if constexpr (wanted == Wanted::speed)
            change = hn::Add(change, hn::Mul(d, across(tag, at.velocity[axis] + block.mass + k)));
        }
        const double* length = links.length.data() + block.link + k;
        const auto l = hn::LoadU(tag, length);
        const auto scale = wanted == Wanted::length ? hn::Mul(l, l) : l;
        const auto error = hn::Div(hn::Abs(right_side<wanted>(tag, square, change, length)), scale);
        hn::Store(hn::Max(hn::Load(tag, largest), error), tag, largest);
        hn::Store(hn::Add(hn::Load(tag, unsound), hn::Mul(hn::Zero(tag), error)), tag, unsound);
      });
  double error = 0.0, lost = 0.0;
  for (std::size_t i = 0; i < lanes; ++i) {
    error = std::max(error, largest[i]);
    lost += unsound[i];
  }
  return lost == 0.0 ? error : std::numeric_limits<double>::quiet_NaN();
}

double largest_length_error(const ChainLinks& links, const PhaseSums& at) {
  return largest_error<Wanted::length>(links, at);
}
double largest_speed_along(const ChainLinks& links, const PhaseSums& at) {
  return largest_error<Wanted::speed>(links, at);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(solve_accelerations);
HWY_EXPORT(solve_lengths);
HWY_EXPORT(solve_speeds);
HWY_EXPORT(largest_length_error);
HWY_EXPORT(largest_speed_along);

namespace {

PhaseSums given(const Vectors& position, const Vectors& velocity) {
  PhaseSums at;
  at.start(position, velocity, 0.0);
  return at;
}

}  // namespace

ChainMotion::ChainMotion(ChainLinks links) : links_(std::move(links)) {
  for (auto& axis : room_.direction) axis.assign(links_.count + 2, 0.0);
  room_.passed.assign(links_.count + 1, 0.0);
  room_.strength.assign(links_.count, 0.0);
  room_.corrected.resize(links_.inverse_mass.size());
}

bool ChainMotion::evaluate(const PhaseSums& at, Vectors& acceleration, std::vector<double>& multipliers) {
  acceleration.resize(links_.inverse_mass.size());
  multipliers.resize(links_.count);
  return HWY_DYNAMIC_DISPATCH(solve_accelerations)(links_, at, room_, multipliers, acceleration) == 0.0;
}

double ChainMotion::length_error(const Vectors& position) const {
  return HWY_DYNAMIC_DISPATCH(largest_length_error)(links_, given(position, position));
}

double ChainMotion::speed_along(const Vectors& position, const Vectors& velocity) const {
  return HWY_DYNAMIC_DISPATCH(largest_speed_along)(links_, given(position, velocity));
}

bool ChainMotion::correct(Vectors& position) {
  const double unsound = HWY_DYNAMIC_DISPATCH(solve_lengths)(links_, given(position, position), room_,
                                                             room_.strength, room_.corrected);
  std::swap(position, room_.corrected);
  return unsound == 0.0;
}

bool ChainMotion::correct(const Vectors& position, Vectors& velocity) {
  const double unsound = HWY_DYNAMIC_DISPATCH(solve_speeds)(links_, given(position, velocity), room_,
                                                            room_.strength, room_.corrected);
  std::swap(velocity, room_.corrected);
  return unsound == 0.0;
}

}  // namespace taut

#endif
