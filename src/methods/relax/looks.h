#pragma once

namespace taut {

/// Foretells after which steps a state is looked at: as many after the last time as between the two before.
/// So a look a frame is foreseen, and so are the two around a frame's time that lies between steps.
class Looks {
 public:
  bool expected_after_next_step() const { return since_ + 1 == before_; }
  void step_made() { ++since_; }
  void looked() {
    before_ = last_;
    last_ = since_;
    since_ = 0;
  }

 private:
  int since_ = 0;              // steps since the last look
  int last_ = 1, before_ = 1;  // steps between the last looks, and between those before them
};

}  // namespace taut
