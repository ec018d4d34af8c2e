#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/frame_rate.h"
#include "base/image.h"
#include "output/atomic_file.h"
#include "output/child_process.h"

namespace taut {

/// A film to be made.
struct FilmSettings {
  std::filesystem::path file;  ///< its ending chooses the format: .mp4, .webm, .gif, .webp or .mov
  Size size;
  FrameRate rate;
  bool transparent = false;  ///< frames are RGBA instead of RGB
  int threads = 0;           ///< that the encoder may use; 0: as it likes
  int bits = 8;              ///< of a frame's channels: 8 or 16
};

/// Whether a film of that name goes into a pipe or a device: "-" is standard output, "webm:-" says in which
/// format.
bool is_film_stream(const std::filesystem::path& name);
bool goes_to_standard_output(const std::filesystem::path& name);

/// Throws BadRequest when the format does not exist or can't hold films of that size, of that rate or with
/// transparency.
void check_film_settings(const FilmSettings& settings);

/// A film that grows frame by frame, encoded by ffmpeg while it grows. It gets its name only at the end;
/// until then nothing of that name is touched. Into a pipe it goes as it grows.
class Film {
 public:
  /// Starts the encoder. Throws BadRequest as check_film_settings() does, and RunFailure when ffmpeg is not
  /// installed or the folder can't be written.
  explicit Film(const FilmSettings& settings);

  /// Adds the next frame, of the size set. Throws RunFailure with the encoder's last lines when it gave
  /// up, and Interrupted.
  void add(const Image& frame, const StopTest& stop = {});
  /// Waits for the encoder, and looks whether the film is whole and has all frames that were added; what goes
  /// into a pipe can't be looked at. Returns the processor time (s) that the encoder took. Throws RunFailure
  /// with the encoder's last lines, and Interrupted.
  double finish(const StopTest& stop = {});
  /// Where a finished film lies until it has its name; empty for what went into a pipe.
  std::filesystem::path file() const;
  /// Gives a finished film its name. Throws RunFailure with the system's reason.
  void commit();

 private:
  [[noreturn]] void fail(std::string_view how, const ProcessEnd& end) const;

  std::filesystem::path name_;
  std::optional<PendingFile> file_;  // absent where it goes into a pipe
  std::optional<ChildProcess> encoder_;
  std::string_view ending_;  // of its format
  std::size_t frames_ = 0;
};

/// Throws RunFailure when the program that encodes films is not installed.
void require_film_encoder();

}  // namespace taut
