#pragma once
/// Ctrl-C and SIGTERM: cancel the run, leave nothing half-written.

#include <burin/base/run_context.h>

namespace burin::cli::signals {

/// As long as it lives SIGINT, SIGTERM and SIGHUP cancel `context`. A run that has not ended 40 ms
/// after the first signal is ended with status 5; a second signal kills at once. Either way the
/// files that `guard` knows are removed. SIGPIPE is ignored, so that writing into a closed pipe
/// fails as any other write does. One at a time.
class Handlers {
 public:
  explicit Handlers(RunContext& context);
  ~Handlers();
  Handlers(const Handlers&) = delete;
  Handlers& operator=(const Handlers&) = delete;
};

/// From now on signals do nothing: the output is complete.
void finish();

/// One of several runs of a process: as long as it lives signals cancel `context`, those too that
/// came before; then, or where they came after `finish`, the context that they cancelled before.
class Turn {
 public:
  explicit Turn(RunContext& context);
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  RunContext* before_;
};

/// Whether this is the first to say that the run was cancelled.
bool may_report_cancelled();

/// Tells that a progress bar stands on the terminal's last line, or no more.
void bar_is_drawn(bool drawn);

/// A file to be removed should a signal end the run; `path` must stay valid until `release`.
void guard(const char* path);
void release(const char* path);

}  // namespace burin::cli::signals
