#include <burin/base/error.h>
#include <burin/base/library_folder.h>
#include <burin/base/run_context.h>
#include <burin/base/subprocess.h>
#include <burin/plugin/plugins.h>

#include "probe.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>

namespace burin::plugin {
namespace {

constexpr const char* kGreeting = "burin-probe 1\n";
constexpr std::size_t kLongestReport = 4000;

std::string report_in(const detail::MemoryFile& file) {
  std::string report(std::min(file.size(), kLongestReport), '\0');
  const ssize_t n = ::pread(file.descriptor(), report.data(), report.size(), 0);
  report.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  return report;
}

}  // namespace

std::filesystem::path probe_program() { return library_folder() / "burin-probe"; }

std::string read_report(const std::string& report) {
  const char* const none = "the trial gave no answer";
  if (!report.starts_with(kGreeting)) return none;
  std::string line = report.substr(std::strlen(kGreeting));
  line = line.substr(0, line.find('\n'));
  if (line == "ok") return {};
  if (!line.starts_with("fault ") || line.size() == 6) return none;
  line = line.substr(6, 1000);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

std::string probe(const std::filesystem::path& file, double timeout) {
  const detail::MemoryFile report;
  detail::SubprocessRun run;
  run.arguments = {probe_program().string(), file.string()};
  run.folder = "/";
  run.file = &report;
  run.timeout = timeout;
  RunContext context;
  const detail::SubprocessEnd end = detail::run_subprocess(run, context);
  if (end.start_error != 0) {
    return fmt::format("it cannot be tried out: {}: {}; install it beside libburin",
                       probe_program().string(), std::strerror(end.start_error));
  }
  if (end.timed_out) return fmt::format("it did not end its trial within {} s", timeout);
  if (end.signal != 0) {
    return fmt::format("it crashes when it is tried out (signal {}, {})", end.signal,
                       ::strsignal(end.signal));
  }
  std::string fault = read_report(report_in(report));
  if (fault.empty() && end.status != 0) {
    fault = fmt::format("it ends the program that tries it, with status {}", end.status);
  }
  return fault;
}

}  // namespace burin::plugin
