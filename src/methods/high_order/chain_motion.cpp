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

// Moves the masses [begin, end) between a block's links.
template <Wanted wanted>
HWY_INLINE void move_masses(const ChainLinks& links, const PhaseSums& at, const ChainBlock& block,
                            std::size_t begin, std::size_t end, const ChainArrays& arrays) {
  const std::size_t link = block.link;
  for_groups(Widest(), begin, end, [&](auto tag, std::size_t k) TAUT_INLINED {
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

// So many multipliers are worked out before masses are moved that are so many links behind.
constexpr std::size_t multipliers_at_once = 8, links_behind = 16;

// The way out of one half: multipliers from the middle to its end, and masses some links behind them. Each
// multiplier waits for the one before; masses are moved while they do.
template <Wanted wanted, bool front>
class HalfSubstitution {
 public:
  HWY_INLINE HalfSubstitution(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays)
      : links_(links), at_(at), arrays_(arrays), known_(arrays.multiplier[links.middle]) {}

  HWY_INLINE void begin_block(const ChainBlock& block) {
    block_ = block;
    done_ = 0;
    moved_ = front ? block.inner_end : block.inner_begin;
  }
  // A multiplier: of the front half from the one behind it, and of the back half from the one before it.
  HWY_INLINE void substitute() {
    const std::size_t i = front ? block_.link + block_.count - 1 - done_ : block_.link + done_;
    ++done_;
    if (!front && i == links_.middle) return;
    const std::size_t passed = front ? i + 1 : i;
    arrays_.multiplier[i] = known_ = arrays_.multiplier[i] - arrays_.passed[passed] * known_;
  }
  // Those of the masses between multipliers that are known which are some links behind the last.
  HWY_INLINE void move_masses_behind() {
    if (done_ < links_behind) return;
    if (front)
      move_down_to(std::max(block_.inner_begin, block_.count - done_ + 1 + links_behind));
    else
      move_up_to(std::min(block_.inner_end, done_ - links_behind));
  }
  HWY_INLINE void end_block() {
    if (front)
      move_down_to(block_.inner_begin);
    else
      move_up_to(block_.inner_end);
  }
  // 0, unless a multiplier is not finite: then all that come from it are not.
  HWY_INLINE double unsound() const { return 0.0 * known_; }

 private:
  HWY_INLINE void move_down_to(std::size_t k) {
    if (k >= moved_) return;
    move_masses<wanted>(links_, at_, block_, k, moved_, arrays_);
    moved_ = k;
  }
  HWY_INLINE void move_up_to(std::size_t k) {
    if (k <= moved_) return;
    move_masses<wanted>(links_, at_, block_, moved_, k, arrays_);
    moved_ = k;
  }

  const ChainLinks& links_;
  const PhaseSums& at_;
  const ChainArrays arrays_;
  ChainBlock block_;
  double known_;
  std::size_t done_ = 0;   // links of the block
  std::size_t moved_ = 0;  // of its masses, from there on (front), or those before
};

template <class... Halves>
HWY_INLINE void substitute(std::size_t count, Halves&... halves) {
  std::size_t k = 0;
  for (; k + multipliers_at_once <= count; k += multipliers_at_once) {
    for (std::size_t i = 0; i < multipliers_at_once; ++i) (halves.substitute(), ...);
    (halves.move_masses_behind(), ...);
  }
  for (; k < count; ++k) (halves.substitute(), ...);
}

// From the middle to the end of one half, for a thread of its own.
template <Wanted wanted, bool front>
HWY_INLINE double substitute_half(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays) {
  HalfSubstitution<wanted, front> half(links, at, arrays);
  const std::vector<ChainBlock>& blocks = front ? links.front : links.back;
  for (std::size_t b = blocks.size(); b-- > 0;) {
    half.begin_block(blocks[b]);
    substitute(blocks[b].count, half);
    half.end_block();
  }
  return half.unsound();
}

// The same of both halves, in turn.
template <Wanted wanted>
HWY_INLINE double substitute_both(const ChainLinks& links, const PhaseSums& at, const ChainArrays& arrays) {
  HalfSubstitution<wanted, true> on_front(links, at, arrays);
  HalfSubstitution<wanted, false> on_back(links, at, arrays);
  const ChainBlock none;
  for (std::size_t b = std::max(links.front.size(), links.back.size()); b-- > 0;) {
    const ChainBlock& front = b < links.front.size() ? links.front[b] : none;
    const ChainBlock& back = b < links.back.size() ? links.back[b] : none;
    on_front.begin_block(front);
    on_back.begin_block(back);
    const std::size_t both = std::min(front.count, back.count);
    substitute(both, on_front, on_back);
    substitute(front.count - both, on_front);
    substitute(back.count - both, on_back);
    on_front.end_block();
    on_back.end_block();
  }
  return on_front.unsound() + on_back.unsound();
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
      of_halves[half] = half == 0 ? substitute_half<wanted, true>(links, at, arrays)
                                  : substitute_half<wanted, false>(links, at, arrays);
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
