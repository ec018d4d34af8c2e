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
#include <array>
#include <utility>
#include <vector>

#include "base/workers.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "high_order/chain_motion.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "high_order/chain_elimination-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

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

// A multiplier of the front half, from the one behind it, and of the back half, from the one before it, down
// to which `known` is; adds 0 to `unsound`, unless it is not finite.
HWY_INLINE void substitute_downwards(std::size_t i, const ChainArrays& arrays, double& known,
                                     double& unsound) {
  arrays.multiplier[i] = known = arrays.multiplier[i] - arrays.passed[i + 1] * known;
  unsound += 0.0 * known;
}
HWY_INLINE void substitute_upwards(const ChainLinks& links, std::size_t i, const ChainArrays& arrays,
                                   double& known, double& unsound) {
  if (i != links.middle) arrays.multiplier[i] = known = arrays.multiplier[i] - arrays.passed[i] * known;
  unsound += 0.0 * known;
}

// From the middle to the end of one half, for a thread of its own; returns 0, unless a multiplier is not
// finite.
template <Wanted wanted>
HWY_INLINE double substitute_half(const ChainLinks& links, bool front, const PhaseSums& at,
                                  const ChainArrays& arrays) {
  double unsound = 0.0, known = arrays.multiplier[links.middle];
  const std::vector<ChainBlock>& blocks = front ? links.front : links.back;
  for (std::size_t b = blocks.size(); b-- > 0;) {
    const ChainBlock& block = blocks[b];
    for (std::size_t k = 0; k < block.count; ++k) {
      if (front)
        substitute_downwards(block.link + block.count - 1 - k, arrays, known, unsound);
      else
        substitute_upwards(links, block.link + k, arrays, known, unsound);
    }
    move_block<wanted>(links, at, block, arrays);
  }
  return unsound;
}

// The same of both halves, in turn.
template <Wanted wanted>
HWY_INLINE double substitute_both(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays) {
  double unsound = 0.0;
  double on_front = arrays.multiplier[links.middle], on_back = on_front;
  const ChainBlock none;
  for (std::size_t b = std::max(links.front.size(), links.back.size()); b-- > 0;) {
    const ChainBlock& front = b < links.front.size() ? links.front[b] : none;
    const ChainBlock& back = b < links.back.size() ? links.back[b] : none;
    const auto step_front = [&](std::size_t k) TAUT_INLINED {
      substitute_downwards(front.link + front.count - 1 - k, arrays, on_front, unsound);
    };
    const auto step_back = [&](std::size_t k) TAUT_INLINED {
      substitute_upwards(links, back.link + k, arrays, on_back, unsound);
    };
    const std::size_t both = std::min(front.count, back.count);
    for (std::size_t k = 0; k < both; ++k) {
      step_front(k);
      step_back(k);
    }
    for (std::size_t k = both; k < front.count; ++k) step_front(k);
    for (std::size_t k = both; k < back.count; ++k) step_back(k);
    if (links.is_short) {
      move_block<wanted>(links, at, links.whole, arrays);
    } else {
      move_block<wanted>(links, at, front, arrays);
      move_block<wanted>(links, at, back, arrays);
    }
  }
  return unsound;
}

// Where there are workers, a thread takes each half. Both ways every number is put together alike.
template <Wanted wanted>
HWY_INLINE double solve(const ChainLinks& links, const PhaseSums& at, Workers* workers, ChainRoom& room,
                        std::vector<double>& multipliers, Vectors& moved) {
  const ChainArrays arrays{
      links.coupling.data(),
      links.inverse_mass.data(),
      links.length.data(),
      {room.direction[0].data() + 1, room.direction[1].data() + 1, room.direction[2].data() + 1},
      room.passed.data(),
      multipliers.data(),
      to_write(moved)};
  double unsound = 0.0;
  if (workers == nullptr) {
    meet(links, eliminate_halves<wanted>(links, at, arrays), arrays);
    unsound = substitute_both<wanted>(links, at, arrays);
  } else {
    LastInverses last;
    run_jobs(workers, 2, [&](std::size_t half) {
      if (half == 0)
        last.front = eliminate_half<wanted, true>(links, at, arrays);
      else
        last.back = eliminate_half<wanted, false>(links, at, arrays);
    });
    meet(links, last, arrays);
    std::array<double, 2> of_halves{};
    run_jobs(workers, 2, [&](std::size_t half) {
      of_halves[half] = substitute_half<wanted>(links, half == 0, at, arrays);
    });
    unsound = of_halves[0] + of_halves[1];
  }
  for (const SingleMass& single : links.singles) move_single<wanted>(links, at, single, arrays);
  return unsound;
}

double solve_accelerations(const ChainLinks& links, const PhaseSums& at, Workers* workers, ChainRoom& room,
                           std::vector<double>& multipliers, Vectors& moved) {
  return solve<Wanted::acceleration>(links, at, workers, room, multipliers, moved);
}
double solve_lengths(const ChainLinks& links, const PhaseSums& at, Workers* workers, ChainRoom& room,
                     std::vector<double>& multipliers, Vectors& moved) {
  return solve<Wanted::length>(links, at, workers, room, multipliers, moved);
}
double solve_speeds(const ChainLinks& links, const PhaseSums& at, Workers* workers, ChainRoom& room,
                    std::vector<double>& multipliers, Vectors& moved) {
  return solve<Wanted::speed>(links, at, workers, room, multipliers, moved);
}

// The largest right side of a half's links, over the square of their lengths, or over their lengths.
template <Wanted wanted>
HWY_INLINE double largest_error_of(const std::vector<ChainBlock>& half, const ChainLinks& links,
                                   const PhaseSums& at) {
  LargestMet met;
  for (const ChainBlock& block : half)
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
      met.look(tag, hn::Div(hn::Abs(right_side<wanted>(tag, square, change, length)), scale));
    });
  return met.of_all();
}

template <Wanted wanted>
HWY_INLINE double largest_error(const ChainLinks& links, const PhaseSums& at, Workers* workers) {
  std::array<double, 2> of_halves{};
  run_jobs(workers, 2, [&](std::size_t half) {
    of_halves[half] = largest_error_of<wanted>(half == 0 ? links.front : links.back, links, at);
  });
  return larger_or_none(of_halves[0], of_halves[1]);
}

double largest_length_error(const ChainLinks& links, const PhaseSums& at, Workers* workers) {
  return largest_error<Wanted::length>(links, at, workers);
}
double largest_speed_along(const ChainLinks& links, const PhaseSums& at, Workers* workers) {
  return largest_error<Wanted::speed>(links, at, workers);
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

ChainMotion::ChainMotion(ChainLinks links, std::shared_ptr<Workers> workers)
    : links_(std::move(links)),
      workers_(links_.count < fewest_to_share_in_halves ? nullptr : std::move(workers)) {
  for (auto& axis : room_.direction) axis.assign(links_.count + 2, 0.0);
  room_.passed.assign(links_.count + 1, 0.0);
  room_.strength.assign(links_.count, 0.0);
  room_.corrected.resize(links_.inverse_mass.size());
}

bool ChainMotion::evaluate(const PhaseSums& at, Vectors& acceleration, std::vector<double>& multipliers) {
  acceleration.resize(links_.inverse_mass.size());
  multipliers.resize(links_.count);
  return HWY_DYNAMIC_DISPATCH(solve_accelerations)(links_, at, workers_.get(), room_, multipliers,
                                                   acceleration) == 0.0;
}

double ChainMotion::length_error(const Vectors& position) const {
  return HWY_DYNAMIC_DISPATCH(largest_length_error)(links_, given(position, position), workers_.get());
}

double ChainMotion::speed_along(const Vectors& position, const Vectors& velocity) const {
  return HWY_DYNAMIC_DISPATCH(largest_speed_along)(links_, given(position, velocity), workers_.get());
}

bool ChainMotion::correct(Vectors& position) {
  const double unsound = HWY_DYNAMIC_DISPATCH(solve_lengths)(
      links_, given(position, position), workers_.get(), room_, room_.strength, room_.corrected);
  std::swap(position, room_.corrected);
  return unsound == 0.0;
}

bool ChainMotion::correct(const Vectors& position, Vectors& velocity) {
  const double unsound = HWY_DYNAMIC_DISPATCH(solve_speeds)(links_, given(position, velocity), workers_.get(),
                                                            room_, room_.strength, room_.corrected);
  std::swap(velocity, room_.corrected);
  return unsound == 0.0;
}

}  // namespace taut

#endif
