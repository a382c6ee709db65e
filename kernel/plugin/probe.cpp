#include "probe.h"

#include <burin/base/error.h>
#include <burin/base/library_folder.h>
#include <burin/base/platform.h>
#include <burin/base/run_context.h>
#include <burin/base/subprocess.h>
#include <burin/plugin/plugins.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace burin::plugin {
namespace {

constexpr std::string_view kGreeting = "burin-probe 1\n";
constexpr const char* kNoAnswer = "the trial gave no answer";
// Sanitizers map more than any machine has.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif
constexpr std::size_t kLongestReport = 4000;

std::string report_in(const detail::MemoryFile& file) {
  std::string report;
  return platform::read_content(file.descriptor(), report, kLongestReport) ? report : std::string();
}

/// Programs that unpack the add-on of FreeCAD may forget that a file is one.
void make_runnable(const std::filesystem::path& program) {
  using std::filesystem::perms;
  if (platform::may_run(program)) return;
  std::error_code error;  // then the start says why not
  std::filesystem::permissions(program, perms::owner_exec, std::filesystem::perm_options::add,
                               error);
}

}  // namespace

std::filesystem::path probe_program() { return library_folder() / "burin-probe"; }

std::string read_report(const std::string& report) {
  constexpr std::size_t kLongestFault = 1000;
  constexpr std::string_view kFault = "fault ";
  std::string_view line = report;
  if (!line.starts_with(kGreeting)) return kNoAnswer;
  line.remove_prefix(kGreeting.size());
  line = line.substr(0, line.find('\n'));
  if (line == "ok") return {};
  if (!line.starts_with(kFault) || line.size() == kFault.size()) return kNoAnswer;
  std::string fault(line.substr(kFault.size(), kLongestFault));
  for (char& c : fault) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return fault;
}

std::string probe(const std::filesystem::path& file, double timeout) {
  make_runnable(probe_program());
  const detail::MemoryFile report;
  detail::SubprocessRun run;
  run.arguments = {probe_program().string(), file.string()};
  run.folder = std::string("/");  // nothing is found by where one stands
  run.file = &report;
  run.timeout = timeout;
  run.bounded = !kSanitized;
  RunContext context;
  const detail::SubprocessEnd end = detail::run_subprocess(run, context);
  if (end.start_error != 0) {
    return fmt::format("it cannot be tried out: {}: {}; install it beside libburin",
                       probe_program().string(), std::strerror(end.start_error));
  }
  if (end.timed_out) return fmt::format("it did not end its trial within {} s", timeout);
  if (end.signal != 0) {
    return fmt::format("it crashes when it is tried out (signal {}, {})", end.signal,
                       platform::signal_name(end.signal));
  }
  std::string fault = read_report(report_in(report));
  if (fault.empty() && end.status != 0) {
    fault = fmt::format("it ends the program that tries it, with status {}", end.status);
  }
  return fault;
}

}  // namespace burin::plugin
