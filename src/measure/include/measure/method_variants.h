#pragma once

#include <string>
#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// A curve of a chart: a method with one choice for each of its parameters that are words.
struct Curve {
  std::string name;        ///< the method, and the choice where it has one: "rattle order 4"
  Settings settings;       ///< complete; steps and passes as the method has them by default
  bool relaxes = false;    ///< makes passes, and they matter for the model
  std::size_t method = 0;  ///< place in the registry
};

/// The curves that a model can have, and a sentence for each that it can't.
struct Curves {
  std::vector<Curve> curves;
  std::vector<std::string> omissions;
};

/// Every method of the registry with every choice of its worded parameters; those left out that can't do what
/// the model needs. `methods` names those wanted; empty: all. Throws BadRequest for a name that is no
/// method's.
Curves curves_for(const Model& model, const State& start,
                  const std::vector<std::string>& methods = {});

/// The curve's settings with a step and, where it relaxes, passes.
Settings settings_at(const Curve& curve, double steps_per_second, int passes);

}  // namespace taut
