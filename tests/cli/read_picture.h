#pragma once

#include <string>
#include <vector>

namespace taut::testing {

/// A picture read from a file: three bytes a pixel, row by row.
struct Pixels {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
};

/// Nothing (0 by 0 pixels) where there is no picture.
Pixels read_picture(const std::string& file);

}  // namespace taut::testing
