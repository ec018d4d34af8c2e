#pragma once

#include "methods/method.h"
#include "model/model.h"

namespace taut {

/// How many steps a second settings make: steps_per_second; or what a method that chooses its steps makes of
/// its tolerance by rule, as its steps are proportional to the eighth root of that:
///   (l/tolerance)^⅛ / √(l/g),   l: mean length of a link.
double pace_of(const Model& model, const Settings& settings);

/// Makes settings run at a pace: sets steps_per_second, or by the same rule the tolerance, as near as it may
/// be. Twice the pace is half the step either way.
void set_pace(const Model& model, Settings& settings, double steps_per_second);

/// How small the error of a method gets when its pace is doubled: the order of a method's error in its step,
/// as far as plans count on it.
int order_in_step(const Settings& settings);

}  // namespace taut
