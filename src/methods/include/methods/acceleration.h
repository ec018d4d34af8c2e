#pragma once

#include <memory>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The equations of motion at acceleration level: with d·d̈ + |ḋ|² = 0 in every whole rigid link (index
/// reduction: the second derivative of |d|² = l²), the multipliers follow from
///   (J W Jᵀ) λ = J a_free + |ḋ|²,    a = a_free − W Jᵀ λ,
/// where a_free holds gravity, loads, drag, wind, links with stiffness, and the driven pins' accelerations.
/// Ground planes and breaking are left out.
class AccelerationField {
 public:
  /// For the links that are whole in `state`.
  AccelerationField(const Model& model, const State& state);
  ~AccelerationField();
  AccelerationField(AccelerationField&&) noexcept;

  /// Accelerations (m/s²) of all masses for positions and velocities at a time; pins get those of their
  /// motion. False when the links' system is singular.
  bool evaluate(double time, const Vectors& position, const Vectors& velocity, Vectors& acceleration);

  /// The multipliers of the last evaluation as tensions (N) in their links, one a link of the model; 0
  /// elsewhere.
  std::vector<double> tensions() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// Velocities without what links would stop at once: v − W Jᵀ μ with (J W Jᵀ) μ = J v over the whole rigid
/// links. This is what a report shows of methods that keep half a kick in their velocities
/// (Capabilities::half_kicked). Returned as they are where the system is singular.
Vectors projected_velocities(const Model& model, const State& state);

}  // namespace taut
