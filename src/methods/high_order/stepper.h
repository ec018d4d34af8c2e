#pragma once

#include <memory>
#include <span>
#include <vector>

#include "high_order/event_watch.h"
#include "high_order/runge_kutta_step.h"
#include "methods/method.h"

namespace taut {

/// Steps of DOP853, as long as a tolerance on positions (m) allows, that end where something happens.
///
/// Where something is past at the end of a step or within it (EventWatch), the moment is looked for on the
/// step's interpolant, and the step made again exactly as far as that. Its end is projected onto the links
/// and the held stops. Then it is settled which stops are held from there on; links that have come to their
/// thresholds are told of, and it is the run that breaks them.
class HighOrderStepper final : public Stepper {
 public:
  HighOrderStepper(const Model& model, double tolerance, std::shared_ptr<Workers> workers);

  void load(const State& state) override;
  StepReport step(double h, double end_time) override;
  void undo() override {}
  const State& store() override { return state_; }
  State between(double time) override;
  std::span<const Index> breaking() const override { return breaking_; }

 private:
  // How far beyond the first event the masses are at a moment of a step, in s from its start.
  struct Sample {
    double h, past;
  };
  // What is between the first and the last moment of a step before an event and behind it.
  struct Bracket {
    double low, high;
  };
  // A step as it was tried: the estimate of its error over what is allowed.
  struct Attempt {
    StepStatus status = StepStatus::done;
    double error = infinity;
    bool good = false;  // made to its end, with an error that is allowed
  };
  // The last step, for between(). Its end is the state's, until that becomes something else.
  struct LastStep {
    std::shared_ptr<Equations> equations;
    std::vector<HeldStop> held;
    double begin = 0.0, end = 0.0;  // s
    bool end_is_kept = false;
    Phase phase;  // at its end, with its accelerations, if kept
    Vectors acceleration;
    bool interpolant = false;
  };

  bool begin(StepReport& report);
  bool look_again(StepReport& report);
  double first_length() const;
  double time_after(double h) const;
  Attempt attempt(double h, double most_error, StepReport& report);
  double good_step(double h, double longest, StepReport& report);
  bool may_have_passed() const;
  bool find_bracket(double h, StepReport& report, Bracket& bracket);
  double step_to_event(Bracket bracket, double h, StepReport& report);
  double past_between(double share, StepReport& report);
  bool prepare_interpolant(StepReport& report);
  void take_over(double h);
  void keep_end();
  bool prepare_last_interpolant();
  void pass_event(StepReport& report);

  const Model& model_;
  double tolerance_;
  std::shared_ptr<Workers> workers_;
  std::vector<double> kinks_;  // s, rising: where a force or a driven pin's path is not smooth
  State state_;
  std::shared_ptr<Equations> equations_;  // of what is whole in it; made when the first step is
  EventWatch watch_;
  RungeKuttaStep runge_kutta_;
  bool begun_ = false;
  Vectors acceleration_;  // at the state
  double past_ = -infinity;
  // The step in hand: its end, and what is past there and on the way.
  double goal_ = 0.0;  // s, the time that the longest step allowed ends at
  double longest_ = 0.0;
  Phase end_;
  Vectors end_acceleration_;
  std::vector<double> end_tension_;
  double end_past_ = -infinity;
  std::vector<Sample> samples_;
  std::vector<Index> breaking_;
  LastStep last_;
  Phase between_;
  Vectors between_acceleration_;
  int crowded_ = 0;  // events of stops in a row with hardly any time between them
  double last_event_ = -infinity;
};

}  // namespace taut
