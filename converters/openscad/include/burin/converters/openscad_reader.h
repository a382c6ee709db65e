#pragma once
/// OpenSCAD models (`.scad`, `.csg`): the installed `openscad` evaluates the program, and the tree
/// that it makes is evaluated here.

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/converters/read_result.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Who makes solids of a tree.
enum class CsgBy : std::uint8_t {
  /// Burin; OpenSCAD where Burin cannot, which is told.
  Auto,
  Burin,
  Openscad
};

struct OpenscadOptions {
  /// `NAME=VALUE` as OpenSCAD's own -D takes it; a later one of the same name wins.
  std::vector<std::string> defines = {};
  /// After so many seconds the run is ended.
  double timeout = 300;
  CsgBy csg = CsgBy::Auto;
  /// Whether facets are drawn as the surfaces that they stand for; by OpenSCAD's own mesh they are
  /// recognised.
  bool round = true;
  /// Whether parts become implicit functions instead of solids: of their true surfaces, not of
  /// their facets; a part that has none is refused.
  bool implicit = false;
  /// What the program finds in `$preview`, unless its definitions or it itself say otherwise: true
  /// in OpenSCAD's window, which drawings show, false in what it exports.
  bool preview = true;
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
/// shell and in the folder of the file; a `.csg` that needs no program is read as it is. Objects at
/// the top are parts, and those within that color() or burin.scad tell apart
/// (kernel/docs/openscad.md); what burin.scad says of the drawing is in the marks.
/// Where OpenSCAD makes the mesh it is one part, named by the file. Its
/// warnings, errors and ECHO lines become diagnostics "openscad.*". The result stays in memory; no
/// file is written. The programs may take three quarters of the memory of the machine, and are
/// ended with their children within 0.05 s of a cancellation, after the time limit, and with this
/// process. Throws InputError, with the line where OpenSCAD names one, also where the result is
/// empty or two-dimensional; UsageError for bad definitions. Cost: 0.1 s and that of the tree.
ReadResult read_openscad(const std::filesystem::path& path, const OpenscadOptions& options,
                         RunContext& context);

/// All that a file makes, united: what OpenSCAD itself exports, so `$preview` is false whatever the
/// options say.
struct OpenscadMesh {
  TriMesh mesh;
  Diagnostics diagnostics;
};
/// Throws as `read_openscad`.
OpenscadMesh openscad_mesh(const std::filesystem::path& path, const OpenscadOptions& options,
                           RunContext& context);

/// What is in it, part by part.
FileInfo inspect_openscad(const std::filesystem::path& path, const OpenscadOptions& options,
                          RunContext& context);

}  // namespace burin
