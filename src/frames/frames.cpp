#include "frames/frames.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <future>
#include <list>
#include <memory>
#include <thread>
#include <utility>

#include "base/processor_time.h"
#include "base/stopwatch.h"
#include "bounded_queue.h"
#include "film_making.h"
#include "first_failure.h"
#include "frame_on_its_way.h"
#include "frames/captions.h"
#include "frames/film_frames.h"
#include "frames/metrics.h"
#include "frames/panels.h"
#include "frames/picture_notes.h"
#include "frames/picture_price.h"
#include "frames/settled_colours.h"
#include "frames/settled_view.h"
#include "metrics_recorder.h"
#include "output/atomic_file.h"
#include "output/film.h"
#include "output/frame_file.h"
#include "panel_runs.h"
#include "render_job.h"
#include "sinks.h"
#include "stage_clock.h"
#include "thread_budget.h"

namespace taut {
namespace {

// How Mesa names the threads that fill pixels.
constexpr std::string_view rasteriser_threads = "llvmpipe-";

// One run from scene to frames. Each stage hands on to the next through a queue; whoever ends closes the
// queue it hands to, and whoever fails makes all others stop.
class Pipeline {
 public:
  Pipeline(std::span<const Scene> scenes, const RenderRequest& request, RenderJob& job, Progress& progress,
           const StopTest& stop)
      : scenes_(scenes), request_(request), job_(job), progress_(progress), stop_(stop) {}

  RenderOutcome run();

 private:
  void run_stages(PanelRuns& runs, PanelPainter& painter);
  void simulate(PanelRuns& runs);
  void shape(PanelPainter& painter);
  void draw(PanelPainter& painter);
  std::optional<Submitted> next_to_draw();
  void fetch(Submitted frame, PanelPainter& painter);
  void finish_frames(const PanelPainter& painter);
  void serve(Lane& lane);
  PanelRuns begin_runs();
  void foretell() const;
  std::shared_ptr<const Checkpoint> checkpoint(PanelRuns& runs, int frame, double time);
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

  std::span<const Scene> scenes_;
  const RenderRequest& request_;
  RenderJob& job_;
  Progress& progress_;
  const StopTest& stop_;

  StageClock clock_;
  MetricsRecorder metrics_;
  CheckpointClock checkpoints_;
  std::weak_ptr<const Checkpoint> last_checkpoint_;
  std::size_t most_waiting_ = most_waiting(scenes_);  // frames before a stage
  BoundedQueue<Posed> posed_{most_waiting_};
  BoundedQueue<Shaped> shaped_{most_waiting_};
  BoundedQueue<DrawnFrame> to_finish_{2};
  std::list<Lane> lanes_;
  PictureNotes notes_;
  FirstFailure failure_;
  const StopTest told_to_stop_ = [this] { return told_to_stop(); };
  FirstFailure step_failure_;  // no reason to throw away the frames before it, so it stops nobody else
  std::atomic<bool> stopped_ = false;
  RenderOutcome outcome_;
};

PanelRuns Pipeline::begin_runs() {
  if (request_.motion) return {scenes_.front(), *request_.motion};
  if (job_.resume) {
    const std::string state = std::move(job_.resume->state);  // as large as the scene, and not needed again
    return {scenes_, state, request_.execution};
  }
  return PanelRuns(scenes_, request_.execution);
}

void Pipeline::foretell() const {
  if (!request_.foretell) return;
  double seconds = 0.0;
  for (const Scene& scene : scenes_)
    seconds += predicted_picture_seconds(scene.model, request_.picture.render);
  const std::size_t pictures = job_.to_draw();
  request_.foretell(pictures, seconds * static_cast<double>(pictures));
}

std::shared_ptr<const Checkpoint> Pipeline::checkpoint(PanelRuns& runs, int frame, double time) {
  // They are as large as the scene: one at a time is on its way.
  if (!job_.folder || !last_checkpoint_.expired() || !checkpoints_.due()) return nullptr;
  std::optional<std::string> state = clock_.time(
      Stage::simulate, [&] { return runs.save_before(time, told_to_stop_); }, frame);
  if (!state) return nullptr;
  checkpoints_.begun(0.0);
  auto taken = std::make_shared<const Checkpoint>(Checkpoint{frame, *std::move(state)});
  last_checkpoint_ = taken;
  return taken;
}

void Pipeline::simulate(PanelRuns& runs) {
  const std::vector<int> done = job_.done_before();
  for (const int frame : std::span(job_.frames).subspan(done.size())) {
    const double time = shown_time(scenes_.front(), frame, request_.rate);
    std::shared_ptr<const Checkpoint> checkpoint = this->checkpoint(runs, frame, time);
    std::optional<std::vector<PanelState>> now = clock_.time(
        Stage::simulate, [&] { return runs.at(time, told_to_stop_); }, frame);
    if (!now || told_to_stop()) {
      stopped_ = true;
      return;
    }
    if (request_.watch) request_.watch(*now->front().state);
    Posed posed{frame, panels_hash(*now), std::move(checkpoint), {}, {}};
    for (std::size_t i = 0; i < now->size(); ++i)
      notes_.see(scenes_[i], request_.picture.drawn_size(), shows_ground(), *(*now)[i].state);
    const bool last = frame == job_.frames.back();
    const bool measured = request_.picture.captions || job_.metrics.make || last;
    for (std::size_t i = 0; i < now->size() && measured; ++i) {
      const PanelOutcome outcome{runs.measures(i), (*now)[i].failure};
      if (job_.metrics.make) metrics_.add(frame_metrics(scenes_[i], frame, outcome.measures));
      posed.captions.push_back(panel_caption(scenes_[i], outcome.measures, film_time_text(scenes_[i], time),
                                             outcome.failure, now->size() == 1));
      if (last) outcome_.panels.push_back(outcome);
    }
    posed.panels = *std::move(now);
    if (!posed_.push(std::move(posed))) return;
  }
}

void Pipeline::shape(PanelPainter& painter) {
  while (std::optional<Posed> posed = posed_.pop()) {
    if (told_to_stop()) {  // what is posed already is let go
      stopped_ = true;
      continue;
    }
    std::vector<Pose> states;
    for (const PanelState& panel : posed->panels) states.push_back({panel.state.get(), panel.trails.get()});
    Shaped shaped{
        posed->frame, std::move(posed->hash), std::move(posed->checkpoint), {}, std::move(posed->captions)};
    shaped.shapes = clock_.time(
        Stage::shape, [&] { return painter.shape(states); }, shaped.frame);
    posed.reset();
    if (!shaped_.push(std::move(shaped))) return;
  }
}

void Pipeline::draw(PanelPainter& painter) {
  std::deque<Submitted> submitted;
  while (std::optional<Submitted> frame = next_to_draw()) {
    clock_.time(
        Stage::draw, [&] { painter.submit(frame->shapes); }, frame->frame);
    frame->shapes.clear();  // OpenGL has them now
    submitted.push_back(*std::move(frame));
    // While a frame is fetched the next one is being drawn.
    if (submitted.size() < most_waiting_) continue;
    fetch(std::move(submitted.front()), painter);
    submitted.pop_front();
  }
  for (Submitted& frame : submitted) fetch(std::move(frame), painter);
}

std::optional<Submitted> Pipeline::next_to_draw() {
  while (std::optional<Shaped> shaped = shaped_.pop()) {
    if (told_to_stop()) {
      stopped_ = true;
      continue;
    }
    progress_.update(static_cast<int>(++outcome_.shown));
    outcome_.last_state_hash = shaped->hash;
    Submitted frame{*std::move(shaped), {}, false};
    bool wanted = false;
    const std::shared_future<Finished> finished = frame.finished.get_future().share();
    for (Lane& lane : lanes_) {
      if (!lane.sink.wants(frame.frame, frame.hash)) continue;
      wanted = true;
      frame.as_file = frame.as_file || lane.sink.wants_file();
      lane.frames.push(finished);
    }
    if (job_.folder && !frame.as_file) ++outcome_.kept;
    outcome_.drawn += wanted ? 1 : 0;
    if (wanted) return frame;
  }
  return std::nullopt;
}

void Pipeline::fetch(Submitted frame, PanelPainter& painter) {
  PanelPainter::Drawn drawn = clock_.time(
      Stage::draw, [&] { return painter.fetch(); }, frame.frame);
  to_finish_.push({std::move(frame), std::move(drawn)});
}

void Pipeline::finish_frames(const PanelPainter& painter) {
  while (std::optional<DrawnFrame> drawn = to_finish_.pop()) {
    Submitted& frame = drawn->frame;
    try {
      FinishedFrame finished{frame.frame, frame.hash, {}, {}, frame.checkpoint};
      finished.image = clock_.time(
          Stage::flatten, [&] { return painter.finish(drawn->panels, frame.captions); }, frame.frame);
      if (frame.as_file)
        finished.file = clock_.time(
            Stage::compress, [&] { return encode_frame(finished.image); }, frame.frame);
      frame.finished.set_value(std::make_shared<const FinishedFrame>(std::move(finished)));
    } catch (...) {
      frame.finished.set_exception(std::current_exception());
    }
  }
}

void Pipeline::serve(Lane& lane) {
  failure_.watch([&] { unless_stopped([&] { lane.sink.begin(told_to_stop_); }); });
  while (const std::optional<std::shared_future<Finished>> frame = lane.frames.pop()) {
    if (told_to_stop()) {
      stopped_ = true;
      ++lane.let_go;
      continue;
    }
    failure_.watch([&] {
      if (const Finished finished = unless_lost(*frame))
        unless_stopped([&] { lane.sink.take(*finished, told_to_stop_); });
      else
        ++lane.let_go;
    });
  }
}

void Pipeline::run_stages(PanelRuns& runs, PanelPainter& painter) {
  const double rasterised_before = seconds_of_threads(rasteriser_threads);
  std::vector<std::thread> moving, finishing, serving;
  // The system may give no more threads. Then those there are find that something failed, and end.
  failure_.watch([&] {
    for (Lane& lane : lanes_) serving.emplace_back([&] { serve(lane); });
    for (int i = 0; i < thread_budget(request_.cores).finishing; ++i)
      finishing.emplace_back([&] { finish_frames(painter); });
    moving.emplace_back([&] {
      failure_.watch([&] { shape(painter); });
      posed_.close();
      shaped_.close();
    });
    moving.emplace_back([&] {
      step_failure_.watch([&] { simulate(runs); });
      posed_.close();
    });
  });
  if (failure_.any()) {
    posed_.close();
    shaped_.close();
  }

  failure_.watch([&] { draw(painter); });
  const auto join = [](std::vector<std::thread>& threads) {
    for (std::thread& thread : threads) thread.join();
  };
  shaped_.close();
  to_finish_.close();
  for (Lane& lane : lanes_) lane.frames.close();
  join(moving);
  join(finishing);
  join(serving);
  clock_.add(Stage::rasterise, seconds_of_threads(rasteriser_threads) - rasterised_before);
}

RenderOutcome Pipeline::run() {
  const Stopwatch watch;
  PanelRuns runs = begin_runs();  // first of all: what a method refuses is said before anything is written
  // So is that there is no way to draw, or no exact shape.
  PanelPainter painter(scenes_, request_.picture);
  foretell();
  std::optional<Film> film;
  // What is hidden only helps a film that can be begun.
  if (job_.film.make) begin_film(film, film_settings(request_, scenes_.size(), job_.frames));
  if (job_.folder) {
    job_.folder->set_colour_range(scenes_.front().look.colour_range);
    job_.folder->begin();
  }
  outcome_.drawn_by = painter.drawn_by();
  if (job_.folder) job_.folder->set_drawn_by(outcome_.drawn_by);
  progress_.start(static_cast<int>(job_.frames.size()));

  std::optional<FolderSink> files;
  std::optional<FilmSink> shots;
  const std::vector<int> done = job_.done_before();
  outcome_.shown = outcome_.kept = done.size();
  if (job_.resume) outcome_.resumed_at = job_.resume->frame;
  if (job_.metrics.make) clock_.keep_frames();
  if (job_.metrics.make && job_.resume) metrics_.restore(job_.resume->metrics);
  if (job_.folder)
    lanes_.emplace_back(files.emplace(*job_.folder, checkpoints_, clock_,
                                      job_.metrics.make ? &metrics_ : nullptr,
                                      job_.hides_frames && done.empty()));
  if (film) lanes_.emplace_back(shots.emplace(*film, job_.folder ? &*job_.folder : nullptr, done, clock_));
  run_stages(runs, painter);
  // What stands in the film only, or is there already, doesn't count as lost.
  if (job_.folder) outcome_.shown -= lanes_.front().let_go;

  progress_.finish();
  outcome_.note = notes_.text();
  finish(film);
  outcome_.stages = clock_.seconds();
  outcome_.seconds = watch.seconds();
  return outcome_;
}

void Pipeline::finish(std::optional<Film>& film) {
  const bool whole = !stopped_ && !failure_.any() && !step_failure_.any();
  if (film && whole) {
    failure_.watch([&] { unless_stopped([&] { finish_film(*film, job_, clock_, told_to_stop_); }); });
  }
  if (job_.folder && !outcome_.panels.empty()) {
    std::vector<std::string> halvings;
    for (std::size_t i = 0; i < outcome_.panels.size(); ++i)
      halvings.push_back(halving_sentence(scenes_[i].model, outcome_.panels[i].measures.report));
    job_.folder->set_halvings(fmt::format("{}", fmt::join(halvings, "\n")));
  }
  outcome_.stopped = stopped_;
  // Whatever happened, so far as it went.
  if (job_.metrics.make) failure_.watch([&] { leave_metrics(job_, metrics_.rows(clock_)); });
  // Whatever happened, the manifest says which frames there are.
  if (job_.folder) failure_.watch([&] { job_.folder->save(); });
  if (job_.folder && whole && !failure_.any() && !stopped_) job_.folder->remove_checkpoint();
  // Going on after a step that couldn't be made would end in the same way.
  if (job_.hides_frames && (step_failure_.any() || !job_.folder->has_checkpoint())) job_.folder->remove();
  failure_.rethrow();
  step_failure_.rethrow();
}

RenderOutcome settle_and_run(std::span<Scene> scenes, const RenderRequest& request, RenderJob& job,
                             Progress& progress, const StopTest& stop) {
  try {
    settle_views(scenes, request.picture.drawn_size(), stop);
    if (job.folder && job.folder->manifest().colour_range > 0.0)
      for (Scene& scene : scenes) scene.look.colour_range = job.folder->manifest().colour_range;
    if (request.motion) settle_colours(scenes.front(), *request.motion);
    settle_colours(scenes, request.execution, stop);
  } catch (const Interrupted&) {
    RenderOutcome outcome;
    outcome.stopped = true;
    return outcome;
  }
  return Pipeline(scenes, request, job, progress, stop).run();
}

}  // namespace

RenderOutcome render_frames(std::span<Scene> scenes, const RenderRequest& request, Progress& progress,
                            const StopTest& stop) {
  RenderJob job = make_render_job(scenes, request);
  RenderOutcome outcome;
  if (job.complete())
    outcome.shown = outcome.kept = job.frames.size();
  else if (job.only_film)
    outcome = film_from_files(request, scenes.size(), job, progress, stop);
  else
    outcome = settle_and_run(scenes, request, job, progress, stop);
  outcome.asked = job.frames.size();
  outcome.inputs = job.inputs;
  outcome.size = sheet_size(request.picture.render.size, scenes.size());
  if (request.film && !request.folder && !outcome.stopped) remove_hidden_frames(job);
  outcome.goes_on = job.folder && (!job.hides_frames || job.folder->has_checkpoint());
  outcome.film_kept = request.film && !job.film.make;
  return outcome;
}

}  // namespace taut
