#pragma once

#include <string>
#include <vector>

namespace taut {

/// One HTML page that shows charts (each as chart_json() gives it) and needs nothing but itself: a point
/// tells its settings under the pointer, methods can be switched off, errors and axes changed. What is shown
/// stands in the address after #, so that it can be linked to.
std::string chart_page(const std::vector<std::string>& charts);

}  // namespace taut
