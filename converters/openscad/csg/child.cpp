#include "child.h"

#include <burin/base/parallel.h>
#include <burin/base/platform.h>

#include "beside.h"
#include "exchange.h"
#include "subprocess.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>

namespace burin::csg {
namespace {

/// What the lines of the process say; see program/main.cpp, which writes them.
class Listener {
 public:
  Listener(RunContext& context, Diagnostics& diagnostics, const ChildOptions& options)
      : context_(context), diagnostics_(diagnostics), options_(options), file_(options.file) {}

  void hear(const std::string& line) {
    const std::size_t blank = line.find(' ');
    const std::string word = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (word == "share") {
      double share = 0;
      std::from_chars(rest.data(), rest.data() + rest.size(), share);
      const std::size_t words = rest.find(' ');
      context_.progress(share, words == std::string::npos ? "" : rest.substr(words + 1));
    } else if (word == "say") {
      say(rest);
    } else if (word == "input" || word == "failed") {
      error_ = word;
      what_ = rest;
    }
  }

  /// Throws what it said of an error.
  void raise() const {
    if (error_ == "failed") throw NotEvaluated(what_);
    if (error_ != "input") return;
    const std::size_t blank = what_.find(' ');
    std::int64_t line = 0;
    std::from_chars(what_.data(), what_.data() + blank, line);
    const std::string what = what_.substr(blank + 1);
    throw InputError(line > 0 ? placed(line, what) : what, file_);
  }

 private:
  /// "SEVERITY CODE COUNT MESSAGE"
  void say(const std::string& rest) {
    const std::size_t a = rest.find(' '), b = rest.find(' ', a + 1), c = rest.find(' ', b + 1);
    if (c == std::string::npos) return;
    std::int64_t count = 1;
    std::from_chars(rest.data() + b + 1, rest.data() + c, count);
    const Severity severity = rest[0] == 'i'   ? Severity::Info
                              : rest[0] == 'e' ? Severity::Error
                                               : Severity::Warning;
    diagnostics_.add(severity, rest.substr(a + 1, b - a - 1), count,
                     with_place(rest.substr(c + 1)));
  }

  /// The tree is no file that the user knows: its lines mean nothing to him.
  std::string placed(std::int64_t line, const std::string& what) const {
    const std::string where =
        options_.where ? options_.where(line) : fmt::format("line {} of the evaluated tree", line);
    return where.empty() ? what : where + ": " + what;
  }

  /// A message about a node, with the place that the user knows.
  std::string with_place(const std::string& message) const {
    constexpr std::string_view kLine = "line ";
    const std::size_t of = message.find(kOfTree);
    if (!message.starts_with(kLine) || of == std::string::npos) return message;
    std::int64_t line = 0;
    const auto [end, error] =
        std::from_chars(message.data() + kLine.size(), message.data() + of, line);
    if (error != std::errc() || end != message.data() + of) return message;
    return options_.file + ": " + placed(line, message.substr(of + kOfTree.size()));
  }

  RunContext& context_;
  Diagnostics& diagnostics_;
  const ChildOptions& options_;
  std::string file_, error_, what_;
};

}  // namespace

std::vector<Solid> evaluate_in_child(const std::string& text, std::span<const std::uint32_t> nodes,
                                     const ChildOptions& options, RunContext& context,
                                     Diagnostics& diagnostics) {
  const detail::MemoryFile file;
  write_text(file.descriptor(), text);
  Listener listener(context, diagnostics, options);
  detail::SubprocessRun run;
  run.arguments = {program_beside(BURIN_CSG_PROGRAM), fmt::format("{}", fmt::join(nodes, ",")),
                   fmt::format("{}", thread_limit())};
  run.folder = options.folder.string();
  run.file = &file;
  run.timeout = options.timeout_seconds;
  run.reports_progress = true;
  run.line = [&](const std::string& line) { listener.hear(line); };
  const detail::SubprocessEnd end = run_subprocess(run, context);
  if (end.start_error != 0) {
    throw NotEvaluated(fmt::format("the evaluator {} does not start: {}", run.arguments[0],
                                   std::strerror(end.start_error)));
  }
  if (end.timed_out) {
    throw NotEvaluated(fmt::format("not done after {:g} s", options.timeout_seconds));
  }
  listener.raise();
  if (end.signal != 0) {
    throw NotEvaluated(
        fmt::format("the evaluator crashed ({})", platform::signal_name(end.signal)));
  }
  if (end.status != 0) {
    throw NotEvaluated(fmt::format("the evaluator ended with status {}", end.status));
  }
  return read_solids(file.descriptor());
}

}  // namespace burin::csg
