#include "frames/frames.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "bounded_queue.h"
#include "frames/colouring.h"
#include "frames/frame_selection.h"
#include "frames/ground_note.h"
#include "frames/panels.h"
#include "output/film.h"
#include "panel_runs.h"
#include "render_job.h"

namespace taut {
namespace {

// A moment on its way from the simulation to the painter.
struct Posed {
  int frame = 0;
  std::string hash;
  std::vector<PanelState> panels;
  std::vector<std::vector<std::string>> lines;  // what is said of each, where there are several
};

// A picture on its way from the painter to the frame folder and the film.
struct Painted {
  int frame = 0;
  std::string hash;
  std::shared_ptr<const Image> image;
};

// Keeps the first thing that went wrong in any of several threads.
class FirstFailure {
 public:
  template <class Work>
  void watch(const Work& work) {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }
  bool any() const { return failed_; }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::atomic<bool> failed_ = false;
};

// One run from scene to frames. Each thread hands on to the next through a queue; whoever ends closes the
// queue it hands to, and whoever fails also the one it takes from, so that nobody waits for ever.
class Pipeline {
 public:
  Pipeline(std::span<const Scene> scenes, const RenderRequest& request, RenderJob& job, Progress& progress,
           const StopTest& stop)
      : scenes_(scenes),
        request_(request),
        job_(job),
        progress_(progress),
        stop_(stop),
        already_there_(job.folder ? job.folder->manifest().frames : std::map<int, std::string>{}) {}

  RenderOutcome run();

 private:
  void simulate(PanelRuns& runs);
  void paint(PanelPainter& painter);
  Image picture(const Posed& posed, PanelPainter& painter) const;
  void save_frames();
  void shoot_film(Film& film);
  void start_film(std::optional<Film>& film) const;
  void finish(std::optional<Film>& film);

  bool shows_ground() const { return !request_.picture.render.transparent; }
  bool told_to_stop() const { return failure_.any() || (stop_ && stop_()); }
  template <class Work>
  void unless_stopped(const Work& work) {
    try {
      work();
    } catch (const Interrupted&) {
      stopped_ = true;
    }
  }
  bool frame_wanted(const Posed& posed) const {
    const auto there = already_there_.find(posed.frame);
    return job_.folder && (there == already_there_.end() || there->second != posed.hash);
  }

  std::span<const Scene> scenes_;
  const RenderRequest& request_;
  RenderJob& job_;
  Progress& progress_;
  const StopTest& stop_;
  // A copy: the folder's own list grows in another thread than the one that asks.
  const std::map<int, std::string> already_there_;

  BoundedQueue<Posed> posed_{4};
  BoundedQueue<Painted> to_save_{3}, to_film_{3};
  FirstFailure failure_;
  const StopTest told_to_stop_ = [this] { return told_to_stop(); };
  FirstFailure step_failure_;  // no reason to throw away the frames before it, so it stops nobody else
  std::atomic<bool> stopped_ = false;
  std::size_t let_go_ = 0;  // painted, but not saved: at the size of a cinema's screen that takes too long
  RenderOutcome outcome_;
};

void Pipeline::simulate(PanelRuns& runs) {
  for (const int frame : job_.frames) {
    std::optional<std::vector<PanelState>> now =
        runs.at(frame_time(frame, request_.frames_per_second), [&] { return told_to_stop(); });
    if (!now || told_to_stop()) {
      stopped_ = true;
      return;
    }
    if (request_.watch) request_.watch(now->front().state);
    Posed posed{frame, panels_hash(*now), {}, {}};
    for (std::size_t i = 0; i < now->size() && shows_ground() && !outcome_.note; ++i)
      outcome_.note = ground_note(scenes_[i], (*now)[i].state);
    for (std::size_t i = 0; i < now->size() && (now->size() > 1 || frame == job_.frames.back()); ++i) {
      const PanelOutcome outcome{runs.measures(i), (*now)[i].failure};
      posed.lines.push_back(panel_lines(scenes_[i], outcome.measures, outcome.failure));
      if (frame == job_.frames.back()) outcome_.panels.push_back(outcome);
    }
    posed.panels = *std::move(now);
    if (!posed_.push(std::move(posed))) return;
  }
}

Image Pipeline::picture(const Posed& posed, PanelPainter& painter) const {
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < posed.panels.size(); ++i) {
    Panel& panel = panels.emplace_back();
    panel.state = &posed.panels[i].state;
    if (posed.panels.size() == 1) continue;
    panel.title = panel_title(scenes_[i]);
    panel.lines = posed.lines[i];
    panel.failed = !posed.panels[i].failure.empty();
    panel.plain = !colour_problem(scenes_[i]).empty();
  }
  return painter.draw(panels);
}

void Pipeline::paint(PanelPainter& painter) {
  while (std::optional<Posed> posed = posed_.pop()) {
    if (told_to_stop()) {  // what is posed already is let go
      stopped_ = true;
      continue;
    }
    const bool wanted = frame_wanted(*posed);
    if (wanted || job_.make_film) {
      Painted painted{posed->frame, posed->hash, std::make_shared<const Image>(picture(*posed, painter))};
      if (job_.make_film) to_film_.push(painted);
      if (wanted) to_save_.push(std::move(painted));
    }
    if (!wanted && job_.folder) ++outcome_.kept;
    outcome_.last_state_hash = std::move(posed->hash);
    progress_.update(static_cast<int>(++outcome_.shown));
  }
}

void Pipeline::save_frames() {
  while (const std::optional<Painted> painted = to_save_.pop()) {
    if (!told_to_stop()) {
      job_.folder->write(painted->frame, *painted->image, painted->hash);
      continue;
    }
    stopped_ = true;
    ++let_go_;
  }
}

void Pipeline::shoot_film(Film& film) {
  while (const std::optional<Painted> painted = to_film_.pop())
    unless_stopped([&] { film.add(*painted->image, told_to_stop_); });
}

RenderOutcome Pipeline::run() {
  const auto start = std::chrono::steady_clock::now();
  PanelRuns runs(
      scenes_, request_.execution);  // first of all: what a method refuses is said before anything is written
  if (job_.folder) job_.folder->begin();
  std::optional<Film> film;
  if (job_.make_film) start_film(film);
  PanelPainter painter(scenes_.front(), request_.picture);
  progress_.start(static_cast<int>(job_.frames.size()));

  std::thread simulating([&] {
    step_failure_.watch([&] { simulate(runs); });
    posed_.close();
  });
  std::thread saving([&] {
    failure_.watch([&] { save_frames(); });
    to_save_.close();
  });
  std::thread filming([&] {
    if (film) failure_.watch([&] { shoot_film(*film); });
    to_film_.close();
  });
  failure_.watch([&] { paint(painter); });
  posed_.close();
  to_save_.close();
  to_film_.close();
  simulating.join();
  saving.join();
  filming.join();

  outcome_.shown -= let_go_;
  progress_.finish();
  finish(film);
  outcome_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome_;
}

void Pipeline::start_film(std::optional<Film>& film) const {
  if (request_.film->has_parent_path()) make_folder(request_.film->parent_path());
  film.emplace(film_settings(request_, scenes_.size()));
}

void Pipeline::finish(std::optional<Film>& film) {
  const bool whole = !stopped_ && !failure_.any() && !step_failure_.any();
  if (film && whole) {
    failure_.watch([&] {
      unless_stopped([&] { film->finish(told_to_stop_); });
      if (stopped_) return;
      job_.film.bytes = std::filesystem::file_size(*request_.film);
      if (job_.folder) job_.folder->add_film(job_.film);
    });
  }
  if (job_.folder && !outcome_.panels.empty()) {
    std::vector<std::string> halvings;
    for (std::size_t i = 0; i < outcome_.panels.size(); ++i)
      halvings.push_back(halving_sentence(scenes_[i].model, outcome_.panels[i].measures.report));
    job_.folder->set_halvings(fmt::format("{}", fmt::join(halvings, "\n")));
  }
  outcome_.stopped = stopped_;
  // Whatever happened, the manifest says which frames there are.
  if (job_.folder) failure_.watch([&] { job_.folder->save(); });
  failure_.rethrow();
  step_failure_.rethrow();
}

}  // namespace

RenderOutcome render_frames(std::span<const Scene> scenes, const RenderRequest& request, Progress& progress,
                            const StopTest& stop) {
  RenderJob job = make_render_job(scenes, request);
  RenderOutcome outcome;
  if (job.complete())
    outcome.shown = outcome.kept = job.frames.size();
  else
    outcome = Pipeline(scenes, request, job, progress, stop).run();
  outcome.asked = job.frames.size();
  outcome.inputs = job.inputs;
  outcome.size = sheet_size(request.picture.render.size, scenes.size());
  outcome.film_kept = request.film && !job.make_film;
  return outcome;
}

}  // namespace taut
