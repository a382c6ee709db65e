#pragma once
/// Progress and cancellation of one run, passed to everything that may take longer than 0.1 s.

#include <burin/base/run_stage.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace burin {

/// Seconds that one stage took.
struct StageTime {
  RunStage stage = RunStage::Read;
  double seconds = 0;
};

/// One run: a flag that any thread (or a signal handler) may set, a progress callback and stage
/// timings. `cancel`, `cancelled` and `check` may be called from any thread; the rest from the
/// thread that runs.
class RunContext {
 public:
  /// Called with the stage's name (`run_stage_names`) and the share done in [0,1], at most every 20
  /// ms, from the running thread.
  using ProgressCallback = std::function<void(const std::string& stage, double share)>;

  explicit RunContext(ProgressCallback callback = {});
  RunContext(const RunContext&) = delete;
  RunContext& operator=(const RunContext&) = delete;
  /// For a piece of work that another thread does for `run`, which must live as long. It is
  /// cancelled with `run`. Its stages are its own and are not reported.
  static RunContext piece_of(const RunContext& run) { return RunContext(&run); }

  /// Asks the run to stop; async-signal-safe.
  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ && whole_->cancelled());
  }
  /// Throws Cancelled once `cancel` was called. Cheap enough for inner loops of a microsecond.
  void check() const;

  /// Ends the stage under way and begins the next; one that comes again adds to its time.
  void begin_stage(RunStage stage);
  void end_stage();
  /// Reports the share of the present stage that is done; where one step of it takes long, with a
  /// few words on what is done and how much there is of it.
  void progress(double share, std::string doing = {});
  /// The words of the present report, or empty; for the callback.
  const std::string& doing() const { return doing_; }

  const std::vector<StageTime>& stages() const { return stages_; }

 private:
  explicit RunContext(const RunContext* whole) : whole_(whole) {}

  using Clock = std::chrono::steady_clock;
  std::atomic<bool> cancelled_{false};
  ProgressCallback callback_;
  std::vector<StageTime> stages_;
  int current_ = -1;
  std::string doing_;
  Clock::time_point stage_start_{};
  Clock::time_point last_report_{};
  /// What this is a piece of, or nothing.
  const RunContext* whole_ = nullptr;
};

}  // namespace burin
