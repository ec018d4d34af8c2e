#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/stop.h"
#include "command_line.h"
#include "frames/certifier.h"
#include "measure/plan.h"
#include "scene/scene.h"

namespace taut {

/// How good a run is asked to be.
struct PlanFlags {
  std::string accuracy, search = "20s";

  void add_to(Verb& verb);
};

/// Settles how a scene is run, and puts that into it. Where an accuracy is given, by a search of a stated
/// time; where the scene leaves its method open, by rule for its `accuracy`; else not at all. Says what was
/// chosen on stderr. `method`: what --method says; the plan keeps to it. Throws BadRequest for texts that are
/// no accuracy or no time, and Interrupted. `picture_bytes`: as run_note() takes it.
std::optional<Plan> settle_method(Scene& scene, const PlanFlags& flags, const std::string& method, bool quiet,
                                  const StopTest& stop, double picture_bytes = 0.0);

/// A plan for machines.
nlohmann::ordered_json plan_to_json(const Plan& plan);

/// What a manifest says of a plan.
std::string plan_text(const Plan& plan);

/// Adds the flag --certify.
void add_certify(Verb& verb, bool& certify);

/// What a second run says of the first, on stderr.
void print_certificate(const Certificate& certificate);

/// After the run: how accurate it is estimated to be and how much of it that holds for, on stderr.
void print_accuracy(const Plan& plan);

}  // namespace taut
