#pragma once

#include <string_view>

namespace taut {

/// Processor time that the calling thread has used so far (s): what others run beside it makes no difference.
double processor_seconds();

/// Processor time that those threads of this process have used so far (s) whose names begin like that.
double seconds_of_threads(std::string_view beginning);

}  // namespace taut
