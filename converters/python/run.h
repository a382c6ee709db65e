#pragma once
/// Long work: on a thread of its own, without the GIL, while the thread that called waits and does
/// what needs Python.

#include <burin/base/run_context.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <set>

namespace burin::python {

namespace py = pybind11;

/// What Python calls `Cancel`: a flag, and the runs that it ends.
class CancelFlag {
 public:
  void cancel() {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
    for (RunContext* run : runs_) run->cancel();
  }
  bool cancelled() const { return cancelled_; }

  void add(RunContext& run) {
    const std::lock_guard lock(mutex_);
    runs_.insert(&run);
    if (cancelled_) run.cancel();
  }
  void remove(RunContext& run) {
    const std::lock_guard lock(mutex_);
    runs_.erase(&run);
  }

 private:
  std::mutex mutex_;
  std::atomic<bool> cancelled_{false};
  std::set<RunContext*> runs_;
};

/// None, or a Cancel; throws TypeError for anything else.
std::shared_ptr<CancelFlag> cancel_flag(const py::object& cancel);

/// Runs `work` on another thread; to be called with the GIL, which is released meanwhile. Every
/// 20 ms the calling thread looks for signals (Ctrl-C), and tells `progress` (or None) the stage;
/// an exception of either ends the run and is thrown when the run has ended. So are those of
/// `work`.
void run(const py::object& progress, const std::shared_ptr<CancelFlag>& cancel,
         const std::function<void(RunContext&)>& work);

/// Names a call of `run`.
using RunId = const void*;

/// For code below `run`, on any thread, without the GIL: has `body` called with the GIL, by a
/// thread that waits in `run` (with `own`: in that very run), and waits for it. Exceptions are
/// passed on. Calls that many threads ask for at once take the GIL once. Where nobody waits the GIL
/// is taken here.
void in_python(const std::function<void()>& body, RunId own = nullptr);

/// The run whose work this thread does; nullptr on others, TBB's among them.
RunId this_run();

}  // namespace burin::python
