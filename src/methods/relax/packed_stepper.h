#pragma once

#include <memory>

#include "relax/relaxation_stepper.h"

namespace taut {

/// Whether nothing acts on a model's masses but links, gravity, drag and pins.
bool only_links(const Model& model);

/// The steps of make_relaxation_stepper() for such models, quicker and, in double precision, with the same
/// bits: masses stay packed, and a State is made of them when one is asked for. Of Relaxation<float> all that
/// moves is a float. LinkRelaxation: a Relaxation, or LineRelaxation.
template <class LinkRelaxation>
std::unique_ptr<Stepper> make_packed_stepper(const Model& model, int passes, Kicks kicks,
                                             const Execution& execution);

}  // namespace taut
