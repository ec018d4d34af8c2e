#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "model/description.h"

namespace taut {

/// What the tables of points hold, placed as their entry says.
struct PointsReading {
  std::shared_ptr<const PointsData> data;
  std::string content;  ///< hash of the files' bytes
};

/// Reads tables of comma-separated values (RFC 4180) with a line of headings.
///
/// Masses: x, y, z (m), and optionally name, vx, vy, vz (m/s), mass (kg), radius (m), pinned (0, 1, false or
/// true). Links: a, b (names or numbers of masses), and optionally length (m), stiffness (N/m), damping
/// (N s/m), break_stretch, break_tension (N). An empty field leaves the value open. The tables that `taut
/// export` writes of one moment are read as well: of those `mass` is a number, and broken links are left out.
/// Throws BadRequest, one sentence that begins with the file as the entry names it, line and column.
PointsReading read_points(const std::filesystem::path& masses, const std::filesystem::path& links,
                          const PointsSpec& spec);

}  // namespace taut
