// The kernel that solves lines of links, made once for every set of vector instructions, as those in
// kernels.cpp are, and with the same bits for each: a line's numbers stay in one lane.
//
// With n_i = d_i/|d_i| along link i, and w'_i = answer·w of mass i, the changes Δλ of a line's multipliers
// solve the tridiagonal system
//   −w'_i n_{i−1}·n_i Δλ_{i−1} + D_i Δλ_i − w'_{i+1} n_i·n_{i+1} Δλ_{i+1} = r_i
//   D_i = w'_i + w'_{i+1} + α̃_i/(1 + γ_i)
//   r_i = (l_i − |d_i| − α̃_i λ_i − γ_i n_i·(d_i − d⁰_i)) / (1 + γ_i)
// which says that all links of the line, as they are turned now, are as long as they should be once mass i
// has moved by w'_i (Δλ_i n_i − Δλ_{i−1} n_{i−1}). Elimination from the first link on (Thomas), with
// o_i = −w'_i n_{i−1}·n_i, gives
//   f_i = o_i/p_{i−1},  p_i = D_i − f_i o_i,  s_i = r_i − f_i s_{i−1},  Δλ_i = s_i/p_i − f_{i+1} Δλ_{i+1}
// Roots and the quotients 1/|d| of the links to come don't wait for the pivots p. Where there is no link, or
// one without a direction, n = 0 and r = 0: what lies on either side is apart.

#include "relax/line_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "relax/line_kernels.cpp"
// Vectors of unknown size can't be held in a struct.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#include <hwy/foreach_target.h>
// After it, as it asks.
#include <hwy/highway.h>

#include "relax/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace taut::HWY_NAMESPACE {

using LineLanes = Lanes<double>;
using LineVector = LineLanes::V;

// Pivots are above 0 but for rounding, and no share of D that is left of masses of such different weights can
// be told from it.
constexpr double smallest_pivot = 1e-14;

// Some lanes of a group, as many as a vector has.
struct LanesOfGroup {
  const LineArrays& lines;
  std::size_t slot, special;  // of its first row
  std::size_t rows;
  double* scratch;

  HWY_INLINE Scattered at(std::size_t row) const { return {lines.place + slot + lines_at_once * row}; }
  HWY_INLINE LineVector load(const double* values, std::size_t row) const {
    return hn::LoadU(LineLanes::Tag(), values + slot + lines_at_once * row);
  }
  HWY_INLINE LineVector load_special(const double* values, std::size_t row) const {
    return hn::LoadU(LineLanes::Tag(), values + special + lines_at_once * row);
  }
  // What elimination leaves for the way back: 1/|d_i|, f_i and s_i/p_i.
  HWY_INLINE double* kept(std::size_t row) const { return scratch + 3 * LineLanes::count * row; }
};

// r_i(1 + γ_i), from how much too short the links are.
template <bool soft, bool damped, bool first>
HWY_INLINE LineVector asked(const LanesOfGroup& lanes, std::size_t row, LineVector too_short,
                            const Transposed<LineVector>& normal,
                            [[maybe_unused]] const Transposed<LineVector>& d,
                            [[maybe_unused]] RoomView<const double> start) {
  using L = LineLanes;
  if constexpr (soft && !first)
    too_short = hn::Sub(too_short, hn::Mul(lanes.load_special(lanes.lines.scaled, row),
                                           lanes.load(lanes.lines.multiplier, row)));
  if constexpr (damped) {
    const Transposed<LineVector> d0 =
        L::transposed(L::minus(L::load(start, lanes.at(row)), L::load(start, lanes.at(row + 1))));
    const Transposed<LineVector> moved{hn::Sub(d.x, d0.x), hn::Sub(d.y, d0.y), hn::Sub(d.z, d0.z)};
    too_short = hn::Sub(too_short, hn::Mul(lanes.load_special(lanes.lines.gamma, row), dot(normal, moved)));
  }
  return too_short;
}

template <bool soft, bool damped, bool first>
HWY_INLINE void eliminate(const LanesOfGroup& lanes, RoomView<const double> start,
                          RoomView<const double> position) {
  using L = LineLanes;
  const L::Tag tag;
  const LineVector zero = hn::Zero(tag), one = hn::Set(tag, 1.0), smallest = hn::Set(tag, smallest_pivot);
  const LineArrays& lines = lanes.lines;
  Transposed<LineVector> normal_before{zero, zero, zero};
  LineVector inverse_pivot = zero, side = zero;
  auto here = L::load(position, lanes.at(0));
  for (std::size_t row = 0; row + 1 < lanes.rows; ++row) {
    const auto next = L::load(position, lanes.at(row + 1));
    const Transposed<LineVector> d = L::transposed(L::minus(here, next));
    const LineVector distance = hn::Sqrt(dot(d, d)), length = lanes.load(lines.length, row);
    const auto has_direction = hn::And(hn::Gt(distance, zero), hn::Gt(length, zero));
    const LineVector inverse_distance = hn::IfThenElseZero(has_direction, hn::Div(one, distance));
    const Transposed<LineVector> normal{hn::Mul(d.x, inverse_distance), hn::Mul(d.y, inverse_distance),
                                        hn::Mul(d.z, inverse_distance)};
    LineVector right = asked<soft, damped, first>(lanes, row, hn::Sub(length, distance), normal, d, start);
    if constexpr (damped) right = hn::Mul(right, lanes.load_special(lines.damped, row));
    right = hn::IfThenElseZero(has_direction, right);
    const LineVector other = hn::Neg(hn::Mul(lanes.load(lines.move, row), dot(normal_before, normal)));
    const LineVector factor = hn::Mul(other, inverse_pivot), diagonal = lanes.load(lines.diagonal, row);
    inverse_pivot =
        hn::Div(one, hn::Max(hn::Sub(diagonal, hn::Mul(factor, other)), hn::Mul(smallest, diagonal)));
    side = hn::Sub(right, hn::Mul(factor, side));
    double* kept = lanes.kept(row);
    hn::StoreU(inverse_distance, tag, kept);
    hn::StoreU(factor, tag, kept + L::count);
    hn::StoreU(hn::Mul(side, inverse_pivot), tag, kept + 2 * L::count);
    normal_before = normal;
    here = next;
  }
}

// Each mass is moved when the links on both of its sides are known.
template <bool first>
HWY_INLINE void substitute(const LanesOfGroup& lanes, double* multipliers, RoomView<double> position) {
  using L = LineLanes;
  const L::Tag tag;
  LineVector change = hn::Zero(tag), factor = hn::Zero(tag);
  auto below = L::load(read(position), lanes.at(lanes.rows - 1));
  auto push_below = L::scaled(change, L::minus(below, below));
  for (std::size_t row = lanes.rows - 1; row-- > 0;) {
    const double* kept = lanes.kept(row);
    change = hn::Sub(hn::LoadU(tag, kept + 2 * L::count), hn::Mul(factor, change));
    factor = hn::LoadU(tag, kept + L::count);
    double* multiplier = multipliers + lanes.slot + lines_at_once * row;
    hn::StoreU(first ? change : hn::Add(hn::LoadU(tag, multiplier), change), tag, multiplier);
    const auto here = L::load(read(position), lanes.at(row));
    const auto push = L::scaled(hn::Mul(change, hn::LoadU(tag, kept)), L::minus(here, below));
    const LineVector move = lanes.load(lanes.lines.move, row + 1);
    L::store(L::plus(below, L::scaled(move, L::minus(push_below, push))), position, lanes.at(row + 1));
    below = here;
    push_below = push;
  }
  L::store(L::plus(below, L::scaled(lanes.load(lanes.lines.move, 0), push_below)), position, lanes.at(0));
}

template <bool soft, bool damped, bool first>
HWY_NOINLINE void relax_group(const LineArrays& all_lines, const LineGroup& group,
                              RoomView<const double> start, double* scratch, RoomView<double> position) {
  const LineArrays lines = all_lines;  // which no store can change
  for (std::size_t lane = 0; lane < lines_at_once; lane += LineLanes::count) {
    const LanesOfGroup lanes{lines, group.begin + lane, group.special + lane, group.rows, scratch};
    eliminate<soft, damped, first>(lanes, start, read(position));
    substitute<first>(lanes, lines.multiplier, position);
  }
}

template <bool first>
HWY_INLINE void relax_soft_or_rigid(const LineArrays& lines, const LineGroup& group,
                                    RoomView<const double> start, double* scratch,
                                    RoomView<double> position) {
  if (group.damped)
    relax_group<true, true, first>(lines, group, start, scratch, position);
  else if (group.soft)
    relax_group<true, false, first>(lines, group, start, scratch, position);
  else
    relax_group<false, false, first>(lines, group, start, scratch, position);
}

void relax_line_groups(const LineArrays& lines, std::span<const LineGroup> groups,
                       RoomView<const double> start, bool first, double* scratch, RoomView<double> position) {
  for (const LineGroup& group : groups)
    first ? relax_soft_or_rigid<true>(lines, group, start, scratch, position)
          : relax_soft_or_rigid<false>(lines, group, start, scratch, position);
}

}  // namespace taut::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace taut {

HWY_EXPORT(relax_line_groups);

void relax_lines(const LineArrays& lines, std::span<const LineGroup> groups, RoomView<const double> start,
                 bool first, double* scratch, RoomView<double> position) {
  HWY_DYNAMIC_DISPATCH(relax_line_groups)(lines, groups, start, first, scratch, position);
}

}  // namespace taut

#endif
