#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/stop.h"
#include "measure/time_scales.h"
#include "measure/truth.h"
#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

// Short runs of one method with ever half the step, for quick_plan().

// What the runs are of, and when they are looked at.
struct ProbeScene {
  const Model& model;
  const State& start;
  ErrorKind kind = ErrorKind::trajectory;
  double reach = 0.0;         // m, longest_reach()
  std::vector<double> times;  // s, rising
};

// What is kept of a state: enough to compare it by any kind of error.
struct ProbeSample {
  Vectors position;
  Summary summary;
  double length_error = 0.0;  // mean |strain| of the rigid links times the scene's reach, over its size
};

// How far two samples of the same time are apart, by the scene's kind of error.
double distance(const ProbeScene& scene, const ProbeSample& a, const ProbeSample& b);

// A way to run a scene that is worth trying, and where on its ladder to begin. Its rates are paces (pace.h).
struct ProbeCandidate {
  Settings settings;                           // complete
  int order = 1;                               // with which errors fall with the step
  double first_rate = 60.0, rule_rate = 60.0;  // pace: where to begin, and what the rule says
};

// All that can do the scene, the method first that would be taken without any runs. Throws BadRequest where
// there is none.
std::vector<ProbeCandidate> probe_candidates(const Model& model, const State& start, const TimeScales& scales,
                                             double wanted, std::string_view only);

// A run, and what the next finer one tells about it.
struct Probe {
  double rate = 0.0;                 // pace
  double work = 0.0;                 // s, predicted
  std::vector<ProbeSample> samples;  // as many as were reached
  std::vector<double> distances;     // from the finer run, the largest up to each time that both have reached
  std::vector<double> errors;        // estimated from them
};

class ProbeLadder {
 public:
  explicit ProbeLadder(ProbeCandidate candidate)
      : candidate_(std::move(candidate)), rate_(candidate_.first_rate) {}

  const ProbeCandidate& candidate() const { return candidate_; }
  Settings settings_at(const Model& model, double rate) const;
  // Whether settings are of this ladder.
  bool plans(const Model& model, const Settings& settings) const;
  // Predicted seconds of so many seconds of the scene, before anything has run.
  double work_of(const Model& model, double rate, double seconds) const;

  // Makes the next run, with twice the steps of the last one, for at most so many predicted seconds.
  void climb(const ProbeScene& scene, double most_seconds, const StopTest& stop);
  double next_work(const ProbeScene& scene) const;
  // Forgets its runs, and starts where it did at first.
  void begin_again();
  double last_work() const { return last_work_; }
  bool ended() const { return ended_; }
  std::size_t runs() const { return runs_; }
  // Of the finest run that came as far as anything is looked at.
  double finest_rate() const { return last_ ? last_->rate : 0.0; }
  // Those runs that a finer one has told about.
  const std::vector<Probe>& probes() const { return probes_; }
  const Probe* finest_judged() const { return probes_.empty() ? nullptr : &probes_.back(); }
  // What came of it, for people.
  std::string account(const Model& model) const;

 private:
  std::optional<Probe> made(const ProbeScene& scene, double most_seconds, const StopTest& stop);
  void judge_last(const ProbeScene& scene, const Probe& finer);

  ProbeCandidate candidate_;
  double rate_;
  bool ended_ = false;
  std::size_t runs_ = 0, failed_ = 0;
  double last_work_ = 0.0;
  std::optional<Probe> last_;
  std::vector<Probe> probes_;
};

}  // namespace taut
