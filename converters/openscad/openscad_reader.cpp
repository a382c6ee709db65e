#include <burin/base/error.h>
#include <burin/converters/mesh_info.h>
#include <burin/converters/mesh_reader.h>
#include <burin/converters/openscad_reader.h>

#include "messages.h"
#include "named_files.h"
#include "source.h"
#include "subprocess.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace burin {
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
        "OpenSCAD is needed to read .scad and .csg files and is not on PATH; install the package "
        "openscad (2021.01 or newer), or name the command in BURIN_OPENSCAD");
  }
  throw InputError(fmt::format("openscad cannot be run: {}", std::strerror(error)));
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
  detail::SubprocessRun run;
  run.arguments = {program.name, "--help"};
  run.timeout = kPatience;
  run.line = [&](const std::string& line) {
    exports = exports || line.find("binstl") != std::string::npos;
    program.has_backend = program.has_backend || line.find("--backend") != std::string::npos;
  };
  const detail::SubprocessEnd end = detail::run_subprocess(run, context);
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
  Verdict(const Path& path, std::int64_t lines, const detail::Messages& messages)
      : file_(path.string()),
        name_(path.filename().string()),
        folder_(path.parent_path().string()),
        lines_(lines),
        messages_(messages) {}

  void check(const detail::SubprocessEnd& end, double timeout, std::size_t bytes) const {
    if (end.timed_out) {
      throw InputError(fmt::format("OpenSCAD was not done after {:g} s and was ended; give it "
                                   "longer with `openscad_timeout`, or lower $fn with `define`",
                                   timeout),
                       file_);
    }
    if (end.signal != 0) {
      throw InputError(fmt::format("OpenSCAD crashed (signal {}, {}); too deep a recursion or too "
                                   "little memory do that",
                                   end.signal, ::strsignal(end.signal)),
                       file_);
    }
    if (end.ok() && bytes > 0) return;  // an echo of the model may say what is asked below
    // An error may end the model early and still leave it a 2-D or an empty object.
    if (const detail::Remark* error = messages_.first(Severity::Error)) fail(*error, "");
    if (messages_.two_dimensional()) {
      fail_with_warning(
          "OpenSCAD makes a 2-D object of it, which has no surface to draw; extrude "
          "it, say with linear_extrude(1)");
    }
    if (messages_.empty()) {
      fail_with_warning("OpenSCAD makes nothing of it: the top level object is empty");
    }
    throw InputError(fmt::format("OpenSCAD made no mesh of it (exit status {}): {}", end.status,
                                 messages_.last()),
                     file_);
  }

 private:
  [[noreturn]] void fail(const detail::Remark& remark, const std::string& before) const {
    const bool placed = remark.line > 0;
    // The definitions of -D stand behind the end of the file.
    const std::int64_t line = remark.file == name_ ? std::min(remark.line, lines_) : remark.line;
    throw InputError(before + remark.text, placed ? detail::in_folder(folder_, remark.file) : file_,
                     line);
  }
  /// Nothing came out: a warning may tell why.
  [[noreturn]] void fail_with_warning(const std::string& what) const {
    const detail::Remark* warning = messages_.first(Severity::Warning);
    if (!warning) throw InputError(what, file_);
    fail(*warning, what + "; its first warning: ");
  }

  std::string file_, name_, folder_;
  std::int64_t lines_;
  const detail::Messages& messages_;
};

/// Errors in what OpenSCAD made are about the user's file.
template <typename Read>
auto in_the_name_of(const Path& path, const Read& read) {
  try {
    return read();
  } catch (const InputError& e) {
    throw InputError(std::string("what OpenSCAD made of it: ") + e.what(), path.string());
  }
}

/// The file in memory has no suffix that would tell its kind: what is neither text nor a whole
/// binary STL is told here, as it came.
void check_mesh(const detail::MemoryFile& mesh, const Path& path) {
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  std::array<char, kHeader + sizeof(std::uint32_t)> head{};
  std::ifstream(mesh.path(), std::ios::binary).read(head.data(), head.size());
  if (std::ranges::find(head, '\0') == head.end()) return;
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, head.data() + kHeader, sizeof triangles);
  if (mesh.size() != head.size() + kTriangle * triangles) {
    throw InputError(fmt::format("what OpenSCAD made of it: {} bytes that are no whole STL; look "
                                 "at what openscad -o a.stl makes of the file",
                                 mesh.size()),
                     path.string());
  }
  if (triangles == 0) {
    throw InputError(
        "what OpenSCAD made of it: an STL without triangles; sizes and places must lie within the "
        "range of single precision (1e-38 to 1e38)",
        path.string());
  }
}

/// Runs OpenSCAD; the mesh is left in `mesh`.
Diagnostics run_openscad(const Path& path, const OpenscadOptions& options,
                         const detail::MemoryFile& mesh, RunContext& context) {
  check_openscad_defines(options.defines);
  std::int64_t lines = 0;
  Diagnostics unused;
  {
    const Source source(path, context);  // refuses what is missing, a folder, unreadable or empty
    const std::string_view bytes = source.bytes();
    detail::tell_named_files(bytes, path.parent_path());
    lines = source.line_of(bytes.data() + bytes.find_last_not_of(" \t\r\n") + 1);
    for (const std::string& name : unused_defines(bytes, options.defines)) {
      unused.add(Severity::Warning, "openscad.unused_define", 1,
                 fmt::format("{}: nothing is called {}, which -D defines; check its spelling",
                             path.string(), name));
    }
  }
  const Program program = find_program(context);
  detail::SubprocessRun run;
  // Binary STL: single precision, 20 times finer than the six digits of the text formats.
  run.arguments = {program.name, "-o", fmt::format("/dev/fd/{}", detail::kChildFile),
                   "--export-format", "binstl"};
  if (program.has_backend) run.arguments.emplace_back("--backend=Manifold");
  for (const std::string& define : options.defines) {
    run.arguments.emplace_back("-D");
    run.arguments.push_back(define);
  }
  run.arguments.push_back(std::filesystem::absolute(path).string());
  run.folder = std::filesystem::absolute(path).parent_path().string();
  run.file = &mesh;
  run.timeout = options.timeout;
  detail::Messages messages;
  run.line = [&](const std::string& line) { messages.add(line); };
  const detail::SubprocessEnd end = detail::run_subprocess(run, context);
  if (end.start_error != 0) fail_to_start(program, end.start_error);
  Verdict(path, lines, messages).check(end, options.timeout, mesh.size());
  check_mesh(mesh, path);
  unused.append(messages.diagnostics(path.parent_path().string()));
  return unused;
}

}  // namespace

bool is_openscad_suffix(const Path& path) {
  // Not by extension(), which is empty where nothing stands before the dot.
  const std::string name = lowered(path.filename().string());
  return name.ends_with(".scad") || name.ends_with(".csg");
}

Scene read_openscad(const Path& path, const OpenscadOptions& options, RunContext& context) {
  const detail::MemoryFile mesh;
  Diagnostics diagnostics = run_openscad(path, options, mesh, context);
  MeshFile file = in_the_name_of(path, [&] { return read_mesh_file(mesh.path(), context); });
  for (PolygonSoup& soup : file.objects) soup.name.clear();
  diagnostics.append(file.diagnostics);
  file.diagnostics = std::move(diagnostics);
  return repair_parts(std::move(file), path, context);
}

FileInfo inspect_openscad(const Path& path, const OpenscadOptions& options, RunContext& context) {
  const detail::MemoryFile mesh;
  Diagnostics diagnostics = run_openscad(path, options, mesh, context);
  FileInfo info = in_the_name_of(path, [&] { return inspect_mesh(mesh.path(), context); });
  info.file = path.string();
  info.format = "OpenSCAD";
  for (PartInfo& part : info.parts) part.name = clean_name(path.stem().string());
  diagnostics.append(info.diagnostics);
  info.diagnostics = std::move(diagnostics);
  return info;
}

}  // namespace burin
