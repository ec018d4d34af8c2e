#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// A parameter that a chart varies, at values of equal ratio.
struct ChartAxis {
  std::string param;
  double first = 1.0, ratio = 2.0;
  int count = 1;

  double value(int place) const;  ///< first · ratio^place
};

/// A method with one choice for each of its parameters that are words, and what a chart varies of it: one
/// curve.
struct MethodVariant {
  std::string name;                 ///< the method, and the choice where it has one: "rattle order 4"
  Settings settings;                ///< complete; what is varied as the method has it by default
  Capabilities can;                 ///< the method's
  std::size_t method = 0;           ///< place in the registry
  ChartAxis finer;                  ///< from coarse to fine: steps per second, or a tolerance
  std::optional<ChartAxis> passes;  ///< where the method makes passes, and they matter for the model

  bool relaxes() const { return passes.has_value(); }
};

/// The variants that a model can be run by, and a sentence for each that it can't.
struct MethodVariants {
  std::vector<MethodVariant> variants;
  std::vector<std::string> omissions;
};

/// Which choices of parameters make variants: those that plans choose among, or, for charts, also those that
/// a scene has to ask for.
enum class Choices { planned, charted };

/// Every method of the registry with every choice of its worded parameters; those left out that refuse the
/// model. `methods` names those wanted; empty: all. Throws BadRequest for a name that is no method's.
MethodVariants variants_of(const Model& model, const State& start,
                           const std::vector<std::string>& methods = {}, Choices choices = Choices::planned);

/// The variant's settings at a pace (pace.h) and, where it relaxes, with passes.
Settings settings_at(const Model& model, const MethodVariant& variant, double steps_per_second, int passes);

/// The variant's settings at places along its axes.
Settings settings_at_place(const MethodVariant& variant, int fineness, int row);

}  // namespace taut
