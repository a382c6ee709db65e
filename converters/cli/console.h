#pragma once
/// Everything that the command says on standard error.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include "arguments.h"

#include <string>

namespace burin::cli {

/// One line, `burin: error: MESSAGE`.
void print_error(const std::string& message);

/// Progress, warnings and timings of one run, as much as is wanted of them.
class Console {
 public:
  explicit Console(const Chatter& chatter);
  ~Console() { clear(); }
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Whether only errors are printed.
  bool quiet() const { return quiet_; }

  /// For RunContext: draws the bar, or prints a line where no terminal is; behind it what is being
  /// done, where that takes long.
  void progress(const std::string& stage, double share, const std::string& doing);
  /// Takes the bar away.
  void clear();

  /// One line an entry, `burin: warning: ...`; mere information with --verbose only.
  void diagnostics(const Diagnostics& diagnostics);
  /// One line, `burin: verify: ...`: how much of the drawing rays contradict.
  void verification(const Verification& verification);
  /// One line after each drawing of `burin watch`, with what it took; `files`: how many are
  /// watched.
  void watching(bool drawn, double seconds, std::size_t files);
  /// One line where a drawing of `burin watch` was ended, as a file has changed.
  void begins_again(const std::string& file);
  /// One line where a signal ends `burin watch` while it waits.
  void stopped_watching();
  /// The lines of --verbose: the stages in their order, then the total.
  void stages(const RunContext& context, double total);

 private:
  bool quiet_;
  bool verbose_;
  bool progress_;
  bool terminal_;
  bool drawn_ = false;
  std::string last_stage_;
  int last_percent_ = -1;
  std::string last_doing_;
};

}  // namespace burin::cli
