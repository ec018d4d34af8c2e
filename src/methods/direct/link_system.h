#pragma once

#include <memory>
#include <span>
#include <vector>

#include "direct/link_kernels.h"
#include "extent.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Links that follow each other in a solver's order, whose masses do so, too: link begin + k joins the masses
/// a + k and b + k.
struct LinkRow {
  std::size_t begin = 0, count = 0;
  std::size_t a = 0, b = 0;
};

/// What a solve reads of its links, side by side in the solver's order.
struct SystemLinks {
  std::vector<Index> link;                 ///< index in the Model
  std::vector<Index> a, b;                 ///< masses
  std::vector<double> weight_a, weight_b;  ///< inverse masses, 1/kg; 0 for pins
  std::vector<double> length;              ///< m
  std::vector<double> compliance;          ///< m/N; 0 = rigid
  std::vector<double> damping;             ///< N s/m
  std::vector<LinkRow> rows;  ///< all of the links, several at once; empty where rows are too short to pay

  std::size_t size() const { return link.size(); }
  Extent all() const { return {0, size()}; }
};

/// The rigid links with a free end that are whole in a state.
std::vector<Index> whole_rigid_links(const Model& model, const State& state);

/// Copies what belongs to the given links out of the model.
SystemLinks gather(const Model& model, std::span<const Index> links);

// What follows is done to all links, or to some of them: those beside them are then left as they are.

/// d = x_a − x_b of every link.
void link_vectors(const SystemLinks& links, const Vectors& position, Vectors& difference);
void link_vectors(const SystemLinks& links, const Vectors& position, Vectors& difference, Extent some);

/// l² and 1/l² of every link.
struct SquaredLengths {
  std::vector<double> square, inverse_square;  // m², 1/m²
};

/// d and g = (|d|² − l²)/2 of every link, and what there is to say of all (link_kernels.h).
Misfit measure_lengths(const SystemLinks& links, const Vectors& position, const Vectors& start_direction,
                       const SquaredLengths& lengths, Vectors& direction, std::vector<double>& misfit,
                       Extent some);

/// d/|d|, |d| and |d| − l of every link, and what there is to say of all.
Misfit measure_stretches(const SystemLinks& links, const Vectors& position,
                         const std::vector<double>& inverse_length, Vectors& direction,
                         std::vector<double>& distance, std::vector<double>& stretch, Extent some);

/// c·(u_a − u_b) of every link: C u.
void along_links(const SystemLinks& links, const Vectors& columns, const Vectors& u,
                 std::vector<double>& result);
void along_links(const SystemLinks& links, const Vectors& columns, const Vectors& u,
                 std::vector<double>& result, Extent some);

/// c·(u_a − u_b) + |v_a − v_b|² of every link: C u, and what moving directions add to it.
void along_links_moving(const SystemLinks& links, const Vectors& columns, const Vectors& u, const Vectors& v,
                        std::vector<double>& result);

/// The same, and true, where the masses fall with gravity and drag alone; false where the links have no rows.
bool along_links_falling(const Model& model, const SystemLinks& links, const Vectors& columns,
                         const Vectors& v, std::vector<double>& result);

/// x_a += f w_a s_i c_i and x_b −= f w_b s_i c_i for every link i: adds f W Cᵀ s.
void apply_impulses(const SystemLinks& links, const Vectors& columns, std::span<const double> strength,
                    Vectors& target, double factor = 1.0);

/// What the caller of a solve does to links while they are at hand there.
struct LinkVisits {
  ExtentVisit before;  ///< with links whose right sides are to be read next: time to write them
  ExtentVisit after;   ///< with all the links that have been solved so far, ever more of them
};

/// The linear system of links that pull on shared masses,
///   A_ij = Σ over shared masses m of ± w_m r_i·c_j (+ where both links hold the mass by the same end), plus
///   a diagonal,
/// that is A = R W Cᵀ + diag, with R and C the matrices of link gradients along `rows` and `columns`.
class LinkMatrix {
 public:
  virtual ~LinkMatrix() = default;
  /// Factorises. False when the matrix is singular beyond what a tiny diagonal addition can mend.
  virtual bool factor(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal) = 0;
  /// Solves A x = b in place.
  virtual void solve(std::vector<double>& b) = 0;
  /// Both, one after the other.
  bool factor_and_solve(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal,
                        std::vector<double>& b) {
    return factor_and_solve_by_blocks(rows, columns, diagonal, b, {});
  }
  /// The same with what the caller does to the same links.
  virtual void solve_by_blocks(std::vector<double>& b, const LinkVisits& visits) {
    const Extent all{0, b.size()};
    visits.before(all);
    solve(b);
    visits.after(all);
  }
  virtual bool factor_and_solve_by_blocks(const Vectors& rows, const Vectors& columns,
                                          std::span<const double> diagonal, std::vector<double>& b,
                                          const LinkVisits& visits) {
    visits.before({0, b.size()});
    if (!factor(rows, columns, diagonal)) return false;
    solve(b);
    visits.after({0, b.size()});
    return true;
  }
  /// Whether rows and columns may differ.
  virtual bool takes_unsymmetric() const = 0;
};

/// Links in an order that suits their matrix, and that matrix: O(n) elimination where the links form paths or
/// trees, sparse LDLᵀ elsewhere.
struct LinkSystem {
  SystemLinks links;
  std::unique_ptr<LinkMatrix> matrix;
  bool along_paths = false;  ///< links share free masses with none but those beside them
};

/// The system of the given links, which must be whole and have a free end each.
LinkSystem make_link_system(const Model& model, const std::vector<Index>& links);

}  // namespace taut
