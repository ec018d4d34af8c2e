#pragma once

#include <string>

#include "methods/method.h"
#include "model/measures.h"
#include "motion/run_report.h"
#include "motion/work_ledger.h"

namespace taut {

/// The state as reports show it: where the method leaves half a kick in velocities, projected onto what links
/// allow. Nets of more than 250,000 links answer the kick with the tensions that the state has instead, which
/// is as near as these are (Capabilities::tension_order).
State reported_state(const Model& model, const Capabilities& can, const State& state);

/// What was measured of a run from its start to a later state.
struct RunMeasures {
  double time = 0.0;             ///< s
  Strain strain;                 ///< at the end
  double largest_tension = 0.0;  ///< N, of the whole links at the end
  Energy energy_at_start, energy;
  double pin_work = 0.0;       ///< J
  double load_work = 0.0;      ///< J
  double contact_work = 0.0;   ///< J
  double broken_energy = 0.0;  ///< J
  /// (gain − pin work − load work − contact work + broken energy) over the energy scale; what drag and
  /// friction take counts as error.
  double energy_error = 0.0;
  Vec3 linear_momentum = Vec3::Zero();   ///< kg m/s
  Vec3 angular_momentum = Vec3::Zero();  ///< kg m²/s
  double sag = 0.0;                      ///< m
  double fastest_speed = 0.0;            ///< m/s
  double limit_excess = 0.0;             ///< rad
  double penetration = 0.0;              ///< m
  std::size_t tangled = 0;               ///< places where faces go through faces
  std::size_t broken_links = 0;
  RunReport report;
};

/// Why a run that came to its end is ruined all the same: steps had to be halved, and it has a tenth of the
/// energy scale more than it can have come by. Empty where it isn't, and where wind may have given it.
std::string ruin_sentence(const Model& model, const RunMeasures& measures);

/// What the energy of a run is compared with.
struct EnergyBase {
  Energy at_start;
  double scale = 0.0;  ///< J, energy_scale()
};

/// Measures the reported state `end` of a run.
RunMeasures measure_run(const Model& model, const EnergyBase& base, const State& end, const Work& work,
                        const RunReport& report);

}  // namespace taut
