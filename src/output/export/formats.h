#pragma once

#include <string>
#include <string_view>

#include "output/export.h"

namespace taut {

// The formats of the list in registry.cpp, each in a file of its own.
extern const ExportFormat csv_format, npz_format, vtp_format, obj_format, ply_format, pc2_format, usda_format,
    glb_format;

/// "frame-000012" and the ending: the file of one frame.
std::string export_frame_name(int frame, std::string_view ending);

/// Whether a file's name is one of those.
bool is_export_frame_name(std::string_view name, std::string_view ending);

}  // namespace taut
