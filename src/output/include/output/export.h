#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/frame_rate.h"
#include "model/model.h"
#include "model/state.h"
#include "motion/run_measures.h"
#include "output/folder_lock.h"

namespace taut {

/// What of a motion a table holds. `usual` is the format's own choice: masses as CSV, all but orientations as
/// NPZ.
enum class ExportTable { usual, masses, links, orientations, energy };

/// What the colours of an export are, red, green and blue as displayed, 0 to 1.
struct ExportColours {
  std::vector<std::array<double, 3>> sheets;  ///< one a sheet of the model
  std::array<double, 3> links{0.32, 0.36, 0.42}, masses{0.80, 0.55, 0.20};
};

/// All that is known of an export before anything moves. Model and start must outlive it.
struct ExportSubject {
  const Model& model;
  const State& start;
  std::string title;
  std::vector<double> times;  ///< s, of every instant to come, rising
  FrameRate rate;             ///< of the film whose frames they are
  bool evenly = true;         ///< whether they are an equal time apart, in the film if not in the scene
  std::vector<bool> faces{};  ///< one a sheet of the model: whether it is cloth; else it is a net, of links
  ExportTable table = ExportTable::usual;
  ExportColours colours{};
};

/// One instant of a motion.
struct ExportMoment {
  int frame = 1;                          ///< its number
  const State& state;                     ///< as reports show it
  bool tension_known = false;             ///< whether its tensions mean anything
  std::optional<RunMeasures> measures{};  ///< given where the table is of energy
};

/// Where an export goes. Formats of one file hand it on through `write`, piece by piece in the file's order;
/// what they must keep until the end lies in a nameless file in `folder`. Formats of many files write them
/// there.
struct ExportTarget {
  std::function<void(std::string_view)> write;
  std::filesystem::path folder;
};

/// Writes a motion in some format, instant by instant. Every function throws RunFailure for what can't be
/// written.
class MotionExport {
 public:
  virtual ~MotionExport() = default;
  virtual void add(const ExportMoment& moment) = 0;
  /// After the last instant.
  virtual void finish() = 0;
  /// In place of finish() where the run was stopped before its last instant: what is whole becomes usable.
  virtual void end_early() {}
};

/// What files an export is.
enum class ExportLayout {
  one_file,      ///< which may be standard output
  file_a_frame,  ///< in a folder; those that are whole are of use without the others
  folder,        ///< files in a folder that belong together
};

/// One entry of the list of formats.
struct ExportFormat {
  std::string_view name;
  std::string_view ending;   ///< of its file, or of its many, with the dot
  std::string_view carries;  ///< what of a motion, for people
  std::string_view summary;  ///< what it is good for, in a line
  ExportLayout layout = ExportLayout::one_file;
  bool text = false;         ///< may go to standard output without being told to
  bool streams = false;      ///< its bytes come as the motion does, not all at its end
  bool tables = false;       ///< heeds ExportSubject::table
  bool shows_breaks = true;  ///< what is broken shows as such
  bool evenly = false;       ///< takes only instants that are an equal time apart
  /// Whether a file of such a name may be of a folder that the format wrote.
  bool (*writes)(std::string_view file_name) = nullptr;
  /// Throws BadRequest for what the format can't hold, before anything is written.
  std::unique_ptr<MotionExport> (*make)(const ExportSubject& subject, const ExportTarget& target);
};

/// Every format, in the order in which they are listed.
std::span<const ExportFormat> export_formats();

/// The format of that name. Throws BadRequest with the nearest one.
const ExportFormat& export_format(std::string_view name);

/// The format whose files have the name's ending; null where none has.
const ExportFormat* export_format_of_file(const std::filesystem::path& file);

/// Gets a folder ready for an export, whose files from an earlier one go away, and holds it. Throws
/// OutputConflict where the folder holds anything that the format doesn't write, BadRequest where it is a
/// file, RunFailure where it can't be made or another program works in it.
std::unique_ptr<FolderLock> make_export_folder(const ExportFormat& format,
                                               const std::filesystem::path& folder);

}  // namespace taut
