#include <burin/base/error.h>
#include <burin/base/run_context.h>

#include <algorithm>
#include <utility>

namespace burin {

RunContext::RunContext(ProgressCallback callback) : callback_(std::move(callback)) {}

void RunContext::check() const {
  if (cancelled()) throw Cancelled();
}

void RunContext::begin_stage(RunStage stage) {
  end_stage();
  check();
  const auto it = std::find_if(stages_.begin(), stages_.end(),
                               [&](const StageTime& s) { return s.stage == stage; });
  current_ = static_cast<int>(it - stages_.begin());
  if (it == stages_.end()) stages_.push_back({stage, 0});
  stage_start_ = Clock::now();
  last_report_ = {};
  progress(0);
}

void RunContext::end_stage() {
  if (current_ < 0) return;
  stages_[static_cast<std::size_t>(current_)].seconds +=
      std::chrono::duration<double>(Clock::now() - stage_start_).count();
  current_ = -1;
}

void RunContext::progress(double share, std::string doing) {
  if (!callback_ || current_ < 0) return;
  doing_ = std::move(doing);
  const auto now = Clock::now();
  if (now - last_report_ < std::chrono::milliseconds(20)) return;
  last_report_ = now;
  callback_(to_string(stages_[static_cast<std::size_t>(current_)].stage),
            std::clamp(share, 0.0, 1.0));
}

}  // namespace burin
