#include "program.h"

#include <burin/base/error.h>
#include <burin/base/platform.h>

#include "beside.h"
#include "exchange.h"
#include "messages.h"
#include "named_files.h"
#include "program_text.h"
#include "source.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

namespace burin::detail {
namespace {

using Path = std::filesystem::path;

/// The program, and what it can do by its own help.
struct Program {
  std::string name;
  bool named_by_user = false;
  bool has_backend = false;
};

[[noreturn]] void fail_to_start(const Program& program, int error) {
  if (program.named_by_user) {
    throw InputError(
        fmt::format("BURIN_OPENSCAD names {}, which cannot be run ({}); name the "
                    "openscad command",
                    in_quotes(program.name), std::strerror(error)));
  }
  if (error == ENOENT) {
    throw InputError(
        "OpenSCAD is needed to read this file and is not on PATH; install the package openscad "
        "(2021.01 or newer), or name the command in BURIN_OPENSCAD");
  }
  throw InputError(fmt::format("openscad cannot be run: {}", std::strerror(error)));
}

/// Where OpenSCAD looks for libraries: as the user has it, then where burin.scad came with Burin,
/// so that `use <burin.scad>` works without a copy of it.
std::string library_path() {
  const char* users = std::getenv("OPENSCADPATH");
  std::string path = "OPENSCADPATH=";
  if (users && *users) path += std::string(users) + ":";
  return path + program_beside("burin/openscad");
}

/// Asks the program what it is: a newer OpenSCAD has a second kernel, which is much faster.
Program find_program(RunContext& context) {
  constexpr double kPatience = 30;  // a cold start reads all fonts
  Program program;
  const char* named = std::getenv("BURIN_OPENSCAD");
  program.named_by_user = named && *named;
  program.name = program.named_by_user ? named : "openscad";
  if (program.named_by_user && program.name.find('/') != std::string::npos) {
    program.name = std::filesystem::absolute(program.name).string();
  }
  bool exports = false;
  SubprocessRun run;
  run.arguments = {program.name, "--help"};
  run.timeout = kPatience;
  run.line = [&](const std::string& line) {
    exports = exports || line.find("binstl") != std::string::npos;
    program.has_backend = program.has_backend || line.find("--backend") != std::string::npos;
  };
  const SubprocessEnd end = run_subprocess(run, context);
  if (end.start_error != 0) fail_to_start(program, end.start_error);
  if (!exports) {
    throw InputError(fmt::format(
        "{} is no OpenSCAD of 2021.01 or newer ({}); install the package "
        "openscad, or name the command in BURIN_OPENSCAD",
        in_quotes(program.name), end.timed_out ? "it does not answer" : "by its --help"));
  }
  return program;
}

/// Throws what went wrong, where something did.
class Verdict {
 public:
  Verdict(const Path& path, std::int64_t lines, const Messages& messages)
      : file_(path.string()),
        name_(path.filename().string()),
        folder_(path.parent_path().string()),
        lines_(lines),
        messages_(messages) {}

  void check(const SubprocessEnd& end, double timeout, std::size_t bytes) const {
    if (end.timed_out) {
      throw InputError(fmt::format("OpenSCAD was not done after {:g} s and was ended; give it "
                                   "longer with `openscad_timeout`, or lower $fn with `define`",
                                   timeout),
                       file_);
    }
    if (end.signal != 0) {
      throw InputError(fmt::format("OpenSCAD crashed (signal {}, {}); too deep a recursion or too "
                                   "little memory do that",
                                   end.signal, platform::signal_name(end.signal)),
                       file_);
    }
    if (end.ok() && bytes > 0) return;  // an echo of the model may say what is asked below
    // An error may end the model early and still leave it a 2-D or an empty object.
    if (const Remark* error = messages_.first(Severity::Error)) fail(*error, "");
    if (messages_.two_dimensional()) {
      fail_with_warning(kTwoDimensional);
    }
    if (messages_.empty()) {
      fail_with_warning(kEmpty);
    }
    throw InputError(fmt::format("OpenSCAD made nothing of it (exit status {}): {}", end.status,
                                 messages_.last()),
                     file_);
  }

  ProgramOutput said() const {
    ProgramOutput out{messages_.diagnostics(folder_)};
    const Remark* error = messages_.first(Severity::Error);
    const Remark* warning = messages_.first(Severity::Warning);
    if (error) out.error = error->text;
    if (warning) out.warning = warning->text;
    if (error || warning) place(error ? *error : *warning, out.file, out.line);
    return out;
  }

 private:
  void place(const Remark& remark, std::string& file, std::int64_t& line) const {
    // The definitions of -D stand behind the end of the file.
    line = remark.file == name_ ? std::min(remark.line, lines_) : remark.line;
    file = remark.line > 0 ? in_folder(folder_, remark.file) : file_;
  }
  [[noreturn]] void fail(const Remark& remark, const std::string& before) const {
    std::string file;
    std::int64_t line = 0;
    place(remark, file, line);
    throw InputError(before + remark.text, file, line);
  }
  /// Nothing came out: a warning may tell why.
  [[noreturn]] void fail_with_warning(const std::string& what) const { said().fail(what, file_); }

  std::string file_, name_, folder_;
  std::int64_t lines_;
  const Messages& messages_;
};

/// The definition that gives `$preview` the value asked for; empty where OpenSCAD gives it that of
/// itself (true to a tree, false to a mesh), or the user or the program says what it is.
std::string preview_define(const OpenscadOptions& options, Makes makes, std::string_view program) {
  const auto says = [](const std::string& define) { return define.starts_with("$preview="); };
  if (options.preview == (makes == Makes::Tree) || std::ranges::any_of(options.defines, says) ||
      assigns_at_top(program, "$preview")) {
    return {};
  }
  return options.preview ? "$preview=true" : "$preview=false";
}

}  // namespace

void ProgramOutput::fail(const std::string& what, const std::string& path) const {
  if (!error.empty()) throw InputError(error, file, line);
  if (warning.empty()) throw InputError(what, path);
  throw InputError(what + "; its first warning: " + warning, file, line);
}

std::string contents(const MemoryFile& file) {
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ProgramOutput run_openscad(const Path& path, const OpenscadOptions& options, Makes makes,
                           const MemoryFile& out, RunContext& context, const std::string* instead) {
  check_openscad_defines(options.defines);
  std::int64_t lines = 0;
  std::vector<std::string> defines = options.defines;
  Diagnostics unused;
  {
    const Source source(path, context);  // refuses what is missing, a folder, unreadable or empty
    const std::string_view bytes = source.bytes();
    note_named_files(bytes, path.parent_path());
    lines = source.line_of(bytes.data() + bytes.find_last_not_of(" \t\r\n") + 1);
    for (const std::string& name : unused_defines(bytes, options.defines)) {
      unused.add(Severity::Warning, "openscad.unused_define", 1,
                 fmt::format("{}: nothing is called {}, which -D defines; check its spelling",
                             path.string(), name));
    }
    if (std::string preview = preview_define(options, makes, bytes); !preview.empty()) {
      defines.push_back(std::move(preview));
    }
  }
  const Program program = find_program(context);
  SubprocessRun run;
  // Binary STL: single precision, 20 times finer than the six digits of the text formats.
  run.arguments = {program.name, "-o", fmt::format("/dev/fd/{}", kChildFile), "--export-format",
                   makes == Makes::Mesh ? "binstl" : "csg"};
  if (program.has_backend) run.arguments.emplace_back("--backend=Manifold");
  for (const std::string& define : defines) {
    run.arguments.emplace_back("-D");
    run.arguments.push_back(define);
  }
  std::optional<MemoryFile> input;
  if (instead) {
    csg::write_text(input.emplace().descriptor(), *instead);
    run.input = &*input;
  }
  run.arguments.push_back(instead ? "-" : std::filesystem::absolute(path).string());
  run.folder = std::filesystem::absolute(path).parent_path().string();
  run.environment = {library_path()};
  run.file = &out;
  run.timeout = options.timeout;
  run.doing = makes == Makes::Mesh ? "OpenSCAD makes the mesh" : "OpenSCAD runs the program";
  Messages messages(path.filename().string());
  run.line = [&](const std::string& line) { messages.add(line); };
  const SubprocessEnd end = run_subprocess(run, context);
  messages.end();
  if (end.start_error != 0) fail_to_start(program, end.start_error);
  const Verdict verdict(path, lines, messages);
  verdict.check(end, options.timeout, out.size());
  ProgramOutput said = verdict.said();
  unused.append(said.diagnostics);
  said.diagnostics = std::move(unused);
  return said;
}

}  // namespace burin::detail
