#pragma once

namespace taut {

/// Processor time that the calling thread has used so far (s): what others run beside it makes no difference.
double processor_seconds();

}  // namespace taut
