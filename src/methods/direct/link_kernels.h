#pragma once

#include <cstddef>

#include "axes.h"
#include "extent.h"

namespace taut {

/// `count` links that follow each other and whose masses do so, too: link i joins the masses i of `a` and of
/// `b`.
struct EndsToRead {
  std::size_t count;
  AxesToRead a, b;  ///< b may be null for measure_lengths(): then a has the links' vectors already
};

/// u_a − u_b of every link.
void measure_across(const EndsToRead& u, const AxesToWrite& difference);

/// How far links are from their lengths.
struct Misfit {
  double worst = 0.0;    ///< the largest share of its length or its square, of those that are numbers
  bool finite = true;    ///< whether all are
  bool directed = true;  ///< whether all have a direction, which is not against that at the step's start

  void add(const Misfit& other);
};

/// d of every link, from where its masses are, and g = (|d|² − l²)/2, of which |g|/l² is judged; d·d₀ > 0 is
/// a direction.
Misfit measure_lengths(const EndsToRead& position, const AxesToRead& start_direction,
                       const double* squared_length, const double* inverse_square,
                       const AxesToWrite& direction, double* residual);

/// d/|d| of every link, |d|, and |d| − l, of which | |d| − l|/l is judged; d ≠ 0 is a direction.
struct LinkStretches {
  const double *length, *inverse_length;  ///< m, 1/m
  AxesToWrite direction;
  double *distance, *stretch;  ///< m
};
Misfit measure_stretches(const EndsToRead& position, const LinkStretches& links);

/// c·(u_a − u_b) of every link.
void measure_along(const EndsToRead& u, const AxesToRead& columns, double* result);

/// c·(u_a − u_b) + |v_a − v_b|² of every link.
void measure_along_moving(const EndsToRead& u, const EndsToRead& v, const AxesToRead& columns,
                          double* result);

/// How masses fall that only gravity and drag act on: their accelerations are gravity − drag·v, and none
/// where they are pins.
struct Falling {
  Vec3 gravity;                                   ///< m/s²
  double drag;                                    ///< 1/s
  const double *inverse_mass_a, *inverse_mass_b;  ///< 1/kg, of each link's ends
};

/// The same with u the accelerations of masses that fall so.
void measure_along_falling(const Falling& falling, const EndsToRead& v, const AxesToRead& columns,
                           double* result);

/// What links do to masses of which they are a row: link i joins the masses i and i + 1.
struct RowPush {
  std::size_t count;                              ///< of links
  const double *inverse_mass_a, *inverse_mass_b;  ///< 1/kg, of each link's ends
  AxesToRead columns;
  const double* strength;
  double factor;
};

/// u_i += f w_a s_i c_i, u_{i+1} −= f w_b s_i c_i for every link i, in those of the row's masses.
void push_row(const RowPush& push, const AxesToWrite& target, Extent masses);

}  // namespace taut
