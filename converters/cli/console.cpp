#include "console.h"

#include "signals.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace burin::cli {
namespace {

constexpr int kBarWidth = 30;
constexpr int kShortBar = 10;

/// One write, past stdio: lines of different threads do not mix.
void say(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(STDERR_FILENO, text.data(), text.size());
    if (n <= 0) return;  // nobody listens
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

/// Columns, 80 where the terminal does not tell.
std::size_t terminal_width() {
  winsize size{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return 80;
  return size.ws_col;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

}  // namespace

void print_error(const std::string& message) {
  say(fmt::format("burin: error: {}\n", one_line(message)));
}

Console::Console(const Chatter& chatter)
    : quiet_(chatter.quiet), verbose_(chatter.verbose), terminal_(::isatty(STDERR_FILENO) == 1) {
  progress_ = !quiet_ && !chatter.no_progress && (chatter.progress || terminal_);
}

void Console::progress(const std::string& stage, double share, const std::string& doing) {
  const int percent = static_cast<int>(std::lround(100 * share));
  if (!progress_ || (stage == last_stage_ && percent == last_percent_ && doing == last_doing_)) {
    return;
  }
  last_stage_ = stage;
  last_percent_ = percent;
  last_doing_ = doing;
  const std::string words = doing.empty() ? "" : " " + one_line(doing);
  if (!terminal_) return say(fmt::format("burin: progress {} {:.2f}{}\n", stage, share, words));
  // A line that wraps could not be taken back: words take room from the bar, and end at the edge.
  const int width = words.empty() ? kBarWidth : kShortBar;
  const int done = std::clamp(static_cast<int>(width * share), 0, width);
  const std::string bar = fmt::format("burin: {:<10} [{:#<{}}{:-<{}}] {:3} %{}", stage, "", done,
                                      "", width - done, percent, words);
  say("\r\x1b[K" + bar.substr(0, terminal_width() - 1));
  drawn_ = true;
  signals::bar_is_drawn(true);
}

void Console::clear() {
  if (!drawn_) return;
  say("\r\x1b[K");
  drawn_ = false;
  signals::bar_is_drawn(false);
}

void Console::diagnostics(const Diagnostics& diagnostics) {
  if (quiet_) return;
  clear();
  for (const Diagnostic& d : diagnostics.entries()) {
    if (d.severity == Severity::Info && !verbose_) continue;
    const char* word = d.severity == Severity::Info ? "note" : "warning";
    say(fmt::format("burin: {}: {}\n", word, one_line(d.message)));
  }
}

void Console::verification(const Verification& v) {
  if (quiet_) return;
  clear();
  const std::string areas =
      v.area > 0 ? fmt::format("; {:.1f} of {:.0f} mm2 of areas contradicted in {} places",
                               v.wrong_area, v.area, v.wrong_patches)
                 : "";
  say(fmt::format(
      "burin: verify: {:.1f} of {:.1f} mm contradicted ({:.3f} %) in {} places, {} "
      "loose ends of the outline; {} spans tested{}\n",
      v.contradicted, v.length, 100 * v.share(), v.count, v.loose_ends, v.spans, areas));
}

void Console::watching(bool drawn, double seconds, std::size_t files) {
  if (quiet_) return;
  clear();
  say(fmt::format("burin: {}; watching {} {}\n",
                  drawn ? fmt::format("drawn in {:.2f} s", seconds) : "not drawn", files,
                  files == 1 ? "file" : "files"));
}

void Console::begins_again(const std::string& file) {
  if (quiet_) return;
  clear();
  say(fmt::format("burin: {} has changed; drawing again\n", file));
}

void Console::stopped_watching() {
  if (quiet_) return;
  clear();
  say("burin: stopped watching\n");
}

void Console::stages(const RunContext& context, double total) {
  if (!verbose_ || quiet_) return;
  clear();
  const std::vector<std::string>& names = run_stage_names();
  std::vector<double> seconds(names.size(), 0);
  // Programs read these lines: the stage that an option adds is there with the option alone.
  constexpr double kNever = -1;
  seconds[static_cast<std::size_t>(RunStage::Verify)] = kNever;
  for (const StageTime& s : context.stages()) {
    seconds[static_cast<std::size_t>(s.stage)] = s.seconds;
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (seconds[i] == kNever) continue;
    text += fmt::format("burin: stage {} {:.4f}\n", names[i], seconds[i]);
  }
  say(text + fmt::format("burin: total {:.4f}\n", total));
}

}  // namespace burin::cli
