#include "frames/kept_run.h"

#include <fmt/format.h>

#include <string_view>
#include <system_error>
#include <utility>

#include "base/failure.h"
#include "base/hash.h"
#include "frames/hidden_folder.h"
#include "output/atomic_file.h"
#include "wanted_manifest.h"

namespace taut {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view hidden_lock = ".lock";
constexpr double short_run = 1.0;  // s: what is made anew sooner than it is looked for
// A moment is written as one piece, of which there are bytes for as many.
constexpr std::size_t most_masses_kept = 5'000'000;

// A hash of all that decides the moments.
std::string inputs_of_moments(const Scene& scene, const std::vector<double>& times) {
  Hash hash;
  hash.add(motion_inputs(scene, FrameRate{})).add("\n");
  for (const double time : times) hash.add(fmt::format("{}\n", time));
  return hash.hex();
}

}  // namespace

KeptRun::KeptRun(const Scene& scene, std::vector<double> times, fs::path folder, const Execution& execution)
    : scene_(scene),
      times_(std::move(times)),
      folder_(std::move(folder)),
      execution_(execution),
      inputs_(inputs_of_moments(scene, times_)),
      simulation_(std::in_place, scene, execution) {
  look_at_what_was_kept();
}

void KeptRun::look_at_what_was_kept() {
  std::error_code error;
  if (!fs::exists(checkpoint_file(), error)) return;
  try {
    resume_ = read_checkpoint(checkpoint_file(), inputs_);
    if (!resume_) return;
    lock_ = std::make_unique<FolderLock>(folder_, hidden_lock);
    writer_ = std::make_unique<MotionWriter>(motion_file(), inputs_, false);
    reader_ = std::make_unique<MotionReader>(motion_file());
    // From the first that was kept on, all before the checkpoint are there.
    if (reader_->records().empty()) throw BadRequest("all moments are missing");
    for (int number = reader_->records().begin()->first; number < resume_->frame; ++number)
      if (kept(number) == nullptr) throw BadRequest("a moment is missing");
  } catch (const OutputConflict&) {
    resume_.reset();  // of something else
  } catch (const BadRequest&) {
    resume_.reset();  // damaged
  } catch (const RunFailure&) {
    resume_.reset();  // another program works there
  }
  if (resume_) return;
  reader_.reset();
  writer_.reset();
  lock_.reset();
}

const MotionRecord* KeptRun::kept(int number) const {
  if (!reader_) return nullptr;
  const auto found = reader_->records().find(number);
  return found == reader_->records().end() ? nullptr : &found->second;
}

KeptRun::~KeptRun() {
  if (writer_ && !has_checkpoint(folder_)) remove();
}

std::optional<State> KeptRun::next(const StopTest& stop) {
  const int number = static_cast<int>(done_) + 1;
  std::optional<State> state;
  if (const MotionRecord* record = kept(number); record != nullptr && number < resume_->frame) {
    stored_ = reader_->read(*record, scene_.model);
    state = stored_->state;
  } else {
    stored_.reset();
    state = simulated(number, stop);
  }
  if (state) ++done_;
  return state;
}

std::optional<State> KeptRun::simulated(int number, const StopTest& stop) {
  const double time = times_[done_];
  // What came before anything was kept is made again: that took a second.
  const bool again = resume_ && number < resume_->frame;
  if (resume_ && number == resume_->frame) simulation_.emplace(scene_, resume_->state, execution_);
  if (!again) keep_checkpoint(number, stop);
  try {
    last_ = simulation_->at(time, stop);
  } catch (const RunFailure&) {
    remove();  // going on would end in the same way
    throw;
  }
  if (!last_) return std::nullopt;
  State reported = simulation_->reported(*last_);
  if (writer_ && !again && !writer_->records().contains(number))
    if_there_is_room([&] {
      writer_->add(number, {reported, simulation_->run().report(), simulation_->run().work()});
    });
  return reported;
}

void KeptRun::keep_checkpoint(int number, const StopTest& stop) {
  if (gave_up_) return;
  if (!writer_) {
    if (watch_.seconds() > short_run && scene_.model.masses.size() <= most_masses_kept)
      if_there_is_room([&] { begin_to_keep(); });
    return;
  }
  if (!clock_.due()) return;
  const Stopwatch watch;
  const std::optional<SavedSimulation> saved = simulation_->save_before(times_[done_], stop);
  if (!saved) return;
  if_there_is_room([&] {
    writer_->sync();
    write_checkpoint(checkpoint_file(), inputs_, {number, to_bytes(*saved)});
  });
  clock_.begun(watch.seconds());
}

// A checkpoint follows when there are moments that it spares: those before the first are made again anyway.
void KeptRun::begin_to_keep() {
  make_folder(folder_);
  hidden_.emplace(folder_);
  lock_ = std::make_unique<FolderLock>(folder_, hidden_lock);
  remove_file(checkpoint_file());  // which is of something else
  writer_ = std::make_unique<MotionWriter>(motion_file(), inputs_, true);
  clock_.begun(0.0);
}

// What helps a run that may never come must not end this one.
void KeptRun::if_there_is_room(const std::function<void()>& keep) {
  try {
    keep();
  } catch (const RunFailure&) {
    gave_up_ = true;
    remove();
  }
}

RunMeasures KeptRun::measures() const {
  if (!stored_) return simulation_->measures(*last_);
  const EnergyBase base{energy(scene_.model, scene_.start), energy_scale(scene_.model, scene_.start)};
  return measure_run(scene_.model, base, stored_->state, stored_->work, stored_->report);
}

void KeptRun::remove() {
  writer_.reset();
  reader_.reset();
  if (!lock_) lock_ = lock_unless_held(folder_, hidden_lock);
  if (lock_) remove_hidden_folder(folder_, std::move(lock_));
}

}  // namespace taut
