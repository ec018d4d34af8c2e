// Links that form trees, branches and all: block elimination from the leaves to the root, O(n).
//
// With p = W Cᵀ λ, the system A λ = b is  M p − Cᵀ λ = 0,  R p + D λ = b. A free mass starts with the block B
// = m·I. Once all links below it are eliminated, p = B⁻¹ (s c λ + f) with the link λ above it (s = ±1 its
// end), and that link's row gives
//   λ = (b − s r·B⁻¹ f − s' r·p') / δ,   δ = r·B⁻¹ c + D,
// with s', p' of the mass above. Put into that mass's equation: B' += c rᵀ/δ and f' += s' c (b − s r·B⁻¹
// f)/δ. A free tree's root mass ends with p = B⁻¹ f; a link to a pin has no mass above. (Deul et al., Direct
// Position-Based Solver for Stiff Rods, 2018, eliminate rods in the same way.)

#include <Eigen/Dense>

#include "direct/link_matrices.h"

namespace taut {
namespace {

using Matrix3 = Eigen::Matrix3d;

class TreeMatrix final : public LinkMatrix {
 public:
  TreeMatrix(const Model& model, const SystemLinks& links, const std::vector<TreeStep>& steps)
      : steps_(steps), block_(model.masses.size()), force_(model.masses.size()), shift_(model.masses.size()) {
    for (std::size_t i = 0; i < links.size(); ++i) {
      below_is_a_.push_back(links.a[i] == steps[i].below);
      for (const Index mass : {links.a[i], links.b[i]})
        if (!model.masses.pinned(mass)) masses_.push_back({mass, model.masses.mass[mass]});
    }
  }

  bool takes_unsymmetric() const override { return true; }

  bool factor(const Vectors& rows, const Vectors& columns, std::span<const double> diagonal) override {
    rows_ = rows;
    columns_ = columns;
    inverse_pivot_.resize(steps_.size());
    for (const auto& [mass, kilograms] : masses_) block_[mass] = kilograms * Matrix3::Identity();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const Vec3 row = rows.at(i), column = columns.at(i);
      // The block of the mass below is complete now; from here on its inverse is what is needed.
      block_[steps_[i].below] = block_[steps_[i].below].inverse().eval();
      const double pivot = row.dot(block_[steps_[i].below] * column) + diagonal[i];
      if (!std::isfinite(pivot) || pivot == 0.0) return false;
      inverse_pivot_[i] = 1.0 / pivot;
      if (steps_[i].above >= 0)
        block_[static_cast<std::size_t>(steps_[i].above)] += column * row.transpose() * inverse_pivot_[i];
    }
    for (const Index root : roots()) block_[root] = block_[root].inverse().eval();
    return true;
  }

  void solve(std::vector<double>& b) override {
    for (const auto& [mass, kilograms] : masses_) force_[mass].setZero();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const TreeStep& step = steps_[i];
      b[i] = (b[i] - sign(i) * rows_.at(i).dot(block_[step.below] * force_[step.below])) * inverse_pivot_[i];
      if (step.above >= 0) force_[static_cast<std::size_t>(step.above)] -= sign(i) * b[i] * columns_.at(i);
    }
    for (const Index root : roots()) shift_[root] = block_[root] * force_[root];
    for (std::size_t i = steps_.size(); i-- > 0;) {
      const TreeStep& step = steps_[i];
      if (step.above >= 0)
        b[i] += sign(i) * rows_.at(i).dot(shift_[static_cast<std::size_t>(step.above)]) * inverse_pivot_[i];
      shift_[step.below] = block_[step.below] * (force_[step.below] + sign(i) * b[i] * columns_.at(i));
    }
  }

 private:
  // +1 where the mass below is the link's end a; the mass above then is at −1.
  double sign(std::size_t i) const { return below_is_a_[i] ? 1.0 : -1.0; }

  // Masses that are below no link: the tops of free trees.
  const std::vector<Index>& roots() {
    if (roots_known_) return roots_;
    std::vector<bool> below(block_.size(), false);
    for (const TreeStep& step : steps_) below[step.below] = true;
    for (const auto& [mass, kilograms] : masses_)
      if (!below[mass]) {
        below[mass] = true;
        roots_.push_back(mass);
      }
    roots_known_ = true;
    return roots_;
  }

  struct FreeMass {
    Index mass;
    double kilograms;
  };
  std::vector<TreeStep> steps_;
  std::vector<bool> below_is_a_;
  std::vector<FreeMass> masses_;  // every free mass of the links, some more than once
  std::vector<Matrix3> block_;    // B, then B⁻¹
  std::vector<Vec3> force_, shift_;
  std::vector<double> inverse_pivot_;
  Vectors rows_, columns_;
  std::vector<Index> roots_;
  bool roots_known_ = false;
};

}  // namespace

std::unique_ptr<LinkMatrix> make_tree_matrix(const Model& model, const SystemLinks& links,
                                             const std::vector<TreeStep>& steps) {
  return std::make_unique<TreeMatrix>(model, links, steps);
}

}  // namespace taut
