#pragma once
/// OpenSCAD models (`.scad`, `.csg`), by the installed `openscad`.

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct OpenscadOptions {
  /// `NAME=VALUE` as OpenSCAD's own -D takes it; a later one of the same name wins.
  std::vector<std::string> defines = {};
  /// After so many seconds the run is ended.
  double timeout = 300;
};

/// Whether the suffix (any case) is `.scad` or `.csg`.
bool is_openscad_suffix(const std::filesystem::path& path);

/// Throws UsageError where one is no `NAME=VALUE` whose brackets and quotes close.
void check_openscad_defines(const std::vector<std::string>& defines);

/// The variables of definitions that a program neither names nor could get from another file; those
/// of OpenSCAD itself ($fn ...) always have an effect.
std::vector<std::string> unused_defines(std::string_view program,
                                        const std::vector<std::string>& defines);

/// Runs the program named by BURIN_OPENSCAD, else `openscad` on PATH (2021.01 or newer), without a
/// shell and in the folder of the file, and reads what it makes: one part, named by the file. Its
/// warnings, errors and ECHO lines become diagnostics "openscad.*". The result stays in memory; no
/// file is written. The program may take three quarters of the memory of the machine, and is ended
/// with its children within 0.05 s of a cancellation, after the time limit, and with this process.
/// Throws InputError, with the line where OpenSCAD names one, also where the result is empty or
/// two-dimensional; UsageError for bad definitions. Cost: 0.1 s more than OpenSCAD takes.
Scene read_openscad(const std::filesystem::path& path, const OpenscadOptions& options,
                    RunContext& context);

/// As `inspect_mesh` of what OpenSCAD makes.
FileInfo inspect_openscad(const std::filesystem::path& path, const OpenscadOptions& options,
                          RunContext& context);

}  // namespace burin
