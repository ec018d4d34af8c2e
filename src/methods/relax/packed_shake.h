#pragma once

#include <memory>

#include "methods/method.h"

namespace taut {

/// shake for models of which only_links() is true and all links are rigid, with no tolerance; masses stay
/// packed between steps. The same bits as the stepper in the order of the file.
std::unique_ptr<Stepper> make_packed_shake(const Model& model, int passes, const Execution& execution);

}  // namespace taut
