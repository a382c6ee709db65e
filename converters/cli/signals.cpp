#include "signals.h"

#include <burin/converters/output.h>

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <string_view>

namespace burin::cli::signals {
namespace {

constexpr long kPatience =
    80'000'000;  // ns from the first signal to the end of a run that does not listen
constexpr int kCancelledStatus = 5;

// Handlers may use lock-free atomics and system calls alone.
std::atomic<RunContext*> g_context{nullptr};
std::atomic<int> g_count{0};
std::atomic<bool> g_finished{false};
std::atomic<bool> g_late{false};
std::atomic<bool> g_reported{false};
std::atomic<bool> g_bar{false};
std::array<std::atomic<const char*>, 64> g_files{};
timer_t g_timer;
bool g_has_timer = false;

void remove_files() {
  for (auto& slot : g_files) {
    if (const char* path = slot.load()) ::unlink(path);
  }
}

void write_all(std::string_view text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // nobody listens
}

extern "C" void on_signal(int signal) {
  const int saved = errno;
  if (g_finished) {
    g_late = true;
  } else {
    if (g_count++ == 0) {
      if (RunContext* context = g_context) context->cancel();
      const itimerspec once{{0, 0}, {0, kPatience}};
      if (g_has_timer) ::timer_settime(g_timer, 0, &once, nullptr);
    } else {
      remove_files();
      std::signal(signal, SIG_DFL);
      ::raise(signal);
    }
  }
  errno = saved;
}

extern "C" void on_timer(int) {
  if (g_finished) return;
  remove_files();
  if (g_bar) write_all("\r\x1b[K");
  if (!g_reported.exchange(true)) write_all("burin: error: cancelled\n");
  ::_exit(kCancelledStatus);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

Handlers::Handlers(RunContext& context) {
  set_output_guard({guard, release});
  g_context = &context;
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  g_has_timer = ::timer_create(CLOCK_MONOTONIC, &event, &g_timer) == 0;
  handle(SIGALRM, on_timer);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    // A shell that starts a command in the background, and nohup, ignore signals for it: keep to
    // that.
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) handle(signal, on_signal);
  }
  handle(SIGPIPE, SIG_IGN);
}

Handlers::~Handlers() { g_context = nullptr; }

void finish() { g_finished = true; }

Turn::Turn(RunContext& context) : before_(g_context.exchange(&context)) {
  if (g_count > 0) context.cancel();
}

Turn::~Turn() {
  g_context = before_;
  g_finished = false;
  if (before_ != nullptr && (g_late || g_count > 0)) before_->cancel();
}

bool may_report_cancelled() { return !g_reported.exchange(true); }

void bar_is_drawn(bool drawn) { g_bar = drawn; }

void guard(const char* path) {
  for (auto& slot : g_files) {
    const char* empty = nullptr;
    if (slot.compare_exchange_strong(empty, path)) return;
  }
}

void release(const char* path) {
  for (auto& slot : g_files) {
    const char* expected = path;
    if (slot.compare_exchange_strong(expected, nullptr)) return;
  }
}

}  // namespace burin::cli::signals
