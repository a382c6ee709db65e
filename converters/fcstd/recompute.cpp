#include "recompute.h"

#include <burin/base/error.h>
#include <burin/base/platform.h>

#include "subprocess.h"
#include "text.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace burin::detail {
namespace {

using Path = std::filesystem::path;

constexpr const char* kWords = "BURIN ";  // before what the script says to us

// Paths come as digits, so that no name of a file is a program. An exception that gets out makes
// FreeCAD run the script a second time. A document that is saved keeps its own path in links.
constexpr const char* kScript = R"(import os, sys
def run(source, target):
    import FreeCAD
    document = FreeCAD.openDocument(source)
    for o in document.Objects:
        o.touch()
    document.recompute(None, True)
    for o in document.Objects:
        if "Invalid" in o.State or not o.isValid():
            print("BURIN invalid " + o.Label, flush=True)
    document.saveCopy(target)
try:
    run(*[os.fsdecode(bytes.fromhex(x)) for x in ("{}", "{}")])
    status = 0
except BaseException as e:
    print("BURIN error " + " ".join(str(e).split())[:300], flush=True)
    status = 3
sys.stdout.flush()
os._exit(status)
)";

std::string hex_text(const std::string& text) {
  std::string out;
  for (const char c : text) out += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return out;
}

std::vector<std::string> programs() {
  const char* named = std::getenv("BURIN_FREECAD");
  if (named == nullptr || *named == 0) return {"freecadcmd", "FreeCADCmd"};
  const std::string name = named;
  return {name.find('/') == std::string::npos ? name : std::filesystem::absolute(name).string()};
}

[[noreturn]] void fail_to_start(const std::string& program, std::size_t tried, int error) {
  if (tried == 1) {
    throw InputError(
        fmt::format("BURIN_FREECAD names {}, which cannot be run ({}); name the command freecadcmd",
                    in_quotes(program), std::strerror(error)));
  }
  if (error == ENOENT) {
    throw InputError(
        "FreeCAD is needed to recompute and freecadcmd is not on PATH; install the package "
        "freecad, name the command in BURIN_FREECAD, or draw without `recompute`");
  }
  throw InputError(fmt::format("freecadcmd cannot be run: {}", std::strerror(error)));
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "burin-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw InputError(fmt::format("no temporary folder can be made: {}", std::strerror(errno)));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(path_, error);
}

Path recompute(const Path& document, double timeout, const TemporaryFolder& folder,
               Diagnostics& diagnostics, RunContext& context) {
  Path copy = folder.path() / "copy.FCStd";
  const Path script = folder.path() / "recompute_copy.py";
  std::ofstream(script) << fmt::format(fmt::runtime(kScript),
                                       hex_text(std::filesystem::absolute(document).string()),
                                       hex_text(copy.string()));
  std::string reason, last;
  SubprocessRun run;
  run.folder = folder.path().string();
  run.timeout = timeout;
  run.line = [&](const std::string& line) {
    const std::string text = clean_name(line);
    if (line.starts_with(std::string(kWords) + "invalid ")) {
      diagnostics.add(Severity::Warning, "fcstd.recompute", 1,
                      text.substr(std::strlen(kWords) + 8) +
                          ": FreeCAD could not recompute it; its last shape is drawn");
    } else if (line.starts_with(std::string(kWords) + "error ")) {
      reason = text.substr(std::strlen(kWords) + 6);
    } else {
      last = text;
    }
  };
  const std::vector<std::string> names = programs();
  SubprocessEnd end;
  for (const std::string& name : names) {
    run.arguments = {name, script.string()};
    end = run_subprocess(run, context);
    if (end.start_error != ENOENT) break;
  }
  if (end.start_error != 0) fail_to_start(names.front(), names.size(), end.start_error);
  const std::string file = document.string();
  if (end.timed_out) {
    throw InputError(fmt::format("FreeCAD was not done after {:g} s and was ended; give it longer "
                                 "with `freecad_timeout`, or draw without `recompute`",
                                 timeout),
                     file);
  }
  if (end.signal != 0) {
    throw InputError(fmt::format("FreeCAD crashed (signal {}, {}); draw without `recompute`",
                                 end.signal, platform::signal_name(end.signal)),
                     file);
  }
  std::error_code error;
  if (!end.ok() || !std::filesystem::is_regular_file(copy, error)) {
    const std::string& why = reason.empty() ? last : reason;
    throw InputError(
        fmt::format("FreeCAD made no copy of it (exit status {}){}{}", end.status,
                    why.empty() ? "; is BURIN_FREECAD the command freecadcmd?" : ": ", why),
        file);
  }
  return copy;
}

}  // namespace burin::detail
