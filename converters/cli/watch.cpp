#include "watch.h"

#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/missing_file.h>
#include <burin/base/piped_input.h>
#include <burin/converters/live_page.h>
#include <burin/converters/output.h>

#include "draw.h"
#include "report.h"
#include "signals.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace burin::cli {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// How often files are looked at; where there are many, so that it takes a tenth of the time.
constexpr milliseconds kOften{50};
constexpr int kShare = 10;
/// So long no file has changed any more before it is drawn: who saves writes more than once.
constexpr milliseconds kCalm{100};
/// After so many drawings in a row that ended early one is drawn to its end, so that a file that
/// never rests is drawn too.
constexpr int kEndedEarly = 3;
/// So long a file may be gone: editors write another one and rename it.
constexpr milliseconds kGone{1000};

/// A signal ends it early.
void sleep_for(milliseconds time, const RunContext& context) {
  ::poll(nullptr, 0, static_cast<int>(time.count()));
  context.check();
}

InputFiles::Stamps looked_at(const InputFiles::Stamps& files) {
  InputFiles::Stamps now;
  for (const auto& [name, stamp] : files) now[name] = stamp_of(name);
  return now;
}

bool any_gone(const InputFiles::Stamps& before, const InputFiles::Stamps& now) {
  return std::ranges::any_of(
      before, [&](const auto& one) { return one.second.there && !now.at(one.first).there; });
}

/// Waits until files are others than they were, and have been so for a while. Throws Cancelled.
void wait_for_change(const InputFiles::Stamps& files, const RunContext& context) {
  InputFiles::Stamps last = files;
  Clock::time_point since = Clock::now();
  for (;;) {
    const Clock::time_point start = Clock::now();
    InputFiles::Stamps now = looked_at(files);
    const Clock::time_point end = Clock::now();
    if (now != last) {
      last = std::move(now);
      since = end;
    } else if (last != files && end - since >= (any_gone(files, last) ? kGone : kCalm)) {
      return;
    }
    sleep_for(std::max(kOften, std::chrono::ceil<milliseconds>(kShare * (end - start))), context);
  }
}

/// What is drawn is no reason to draw.
void leave_out(const std::vector<std::string>& outputs, InputFiles::Stamps& files) {
  std::erase_if(files, [&](const auto& one) {
    return std::ranges::any_of(
        outputs, [&](const std::string& output) { return same_file(one.first, output); });
  });
}

/// Ends a drawing whose files have changed since it read them. From its reports, which come in its
/// own thread.
class Newer {
 public:
  Newer(const InputFiles& read, const std::vector<std::string>& outputs)
      : read_(read), outputs_(outputs) {}

  /// Looks at the files, as often as `wait_for_change` does.
  void look(RunContext& run) {
    const Clock::time_point start = Clock::now();
    if (!name_.empty() || start < next_) return;
    InputFiles::Stamps files = read_.stamps();
    leave_out(outputs_, files);
    for (const auto& [name, stamp] : files) {
      if (stamp_of(name) == stamp) continue;
      name_ = name;
      run.cancel();
      break;
    }
    const Clock::time_point end = Clock::now();
    next_ = end + std::max<Clock::duration>(kOften, kShare * (end - start));
  }
  /// The first file that has changed, or empty.
  const std::string& name() const { return name_; }

 private:
  const InputFiles& read_;
  const std::vector<std::string>& outputs_;
  std::string name_;
  Clock::time_point next_{};
};

/// The outputs that are pages, which learn of each drawing.
class Pages {
 public:
  explicit Pages(const DrawArguments& arguments) {
    for (const Output& output : plan_outputs(arguments.outputs, arguments.format, {})) {
      if (&output.format() == format_named("html")) names_.push_back(output.name());
    }
  }
  ~Pages() {
    for (const std::string& name : names_) forget_drawn(name);
  }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;

  /// Numbers are times, so that a page of an earlier run is drawn anew too.
  void drawn() const {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    for (const std::string& name : names_) {
      note_drawn(name, std::chrono::duration_cast<milliseconds>(now).count());
    }
  }

 private:
  std::vector<std::string> names_;
};

std::string only_input(const DrawArguments& arguments) {
  return arguments.inputs.size() == 1 ? arguments.inputs.front() : "";
}

/// Whether the error under way cannot be mended by changing a model.
bool is_of_the_call() {
  try {
    throw;
  } catch (const UsageError&) {
    return true;
  } catch (const MissingFile&) {
    return true;
  } catch (const OutputError&) {
    return true;
  } catch (...) {
    return false;
  }
}

/// Draws once. Returns whether it was drawn; reports errors, but throws the first drawing's where
/// no change of a model can mend it.
bool try_draw(const DrawArguments& arguments, bool first, RunContext& context, Console& console,
              KeptScene& kept) {
  const signals::Turn turn(context);
  try {
    run_draw(arguments, context, console, &kept);
    return true;
  } catch (const Cancelled&) {
    throw;
  } catch (...) {
    if (first && is_of_the_call()) throw;
    console.clear();
    report(only_input(arguments));
  }
  return false;
}

}  // namespace

void run_watch(const DrawArguments& arguments, RunContext& context, Console& console) {
  if (std::ranges::find(arguments.outputs, "-") != arguments.outputs.end()) {
    throw UsageError("burin watch replaces files; name one instead of - (standard output)");
  }
  if (std::ranges::any_of(arguments.inputs, [](const auto& input) { return is_piped(input); })) {
    throw UsageError("burin watch looks at files; name one instead of what is piped into it");
  }
  InputFiles::Stamps files;
  KeptScene kept;
  kept.live = true;
  const Pages pages(arguments);
  int ended_early = 0;
  bool first = true;
  for (;;) {
    const Clock::time_point start = Clock::now();
    const InputFiles read;
    Newer newer(read, arguments.outputs);
    // One a drawing: it has times of its own.
    RunContext run([&](const std::string& stage, double share) {
      console.progress(stage, share, run.doing());
      if (ended_early < kEndedEarly) newer.look(run);
    });
    bool drawn = false;
    try {
      drawn = try_draw(arguments, first, run, console, kept);
    } catch (const Cancelled&) {
      if (newer.name().empty()) throw;
      context.check();  // a signal, too
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    // Where it ended early, the files that would have come after count as they were.
    InputFiles::Stamps now = read.stamps();
    if (!drawn) now.merge(files);
    files = std::move(now);
    leave_out(arguments.outputs, files);
    if (drawn) pages.drawn();
    if (drawn) console.stages(run, seconds);
    ended_early = !drawn && !newer.name().empty() ? ended_early + 1 : 0;
    if (ended_early > 0) {
      console.begins_again(newer.name());
    } else {
      first = false;
      console.watching(drawn, seconds, files.size());
    }
    try {
      wait_for_change(files, context);
    } catch (const Cancelled&) {
      // Ctrl-C is how one ends it: no error, if nothing was being drawn.
      if (signals::may_report_cancelled()) console.stopped_watching();
      throw;
    }
  }
}

}  // namespace burin::cli
