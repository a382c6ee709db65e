#pragma once
/// Any file that Burin reads, as a scene: used by the command line, the Python module and other
/// programs.

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/converters/openscad_reader.h>
#include <burin/converters/read_result.h>
#include <burin/converters/volume_reader.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/options/declared.h>
#include <burin/options/request.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What no file says of itself. A reader takes what concerns its formats and ignores the rest.
struct ReadOptions {
  /// "stl", "step" ...: what standard input is, and files whose names do not tell it; their bytes
  /// go before it where they are clear.
  std::string input_format = {};
  /// The domain of functions; volumes are clipped to it.
  std::optional<Box3> bounds = {};
  /// How the triangles of functions are made.
  Mesher mesher = Mesher::Auto;
  /// OpenSCAD files: definitions `NAME=VALUE`, and the seconds after which OpenSCAD is ended.
  std::vector<std::string> defines = {};
  double openscad_timeout = 300;
  CsgBy csg = CsgBy::Auto;
  /// OpenSCAD files: implicit functions instead of solids.
  bool as_implicit = false;
  /// FreeCAD documents: names or labels of the objects to draw (none: all that are visible);
  /// whether FreeCAD recomputes a copy first, and the seconds after which it is ended.
  std::vector<std::string> objects = {};
  bool recompute = false;
  double freecad_timeout = 300;
  /// Volumes; trivariate splines of IRIT files take the level (0) and what is inside (below).
  VolumeReadOptions volume = {};
  /// Of names in files that do not say in which encoding these are, as iconv knows it; empty: it is
  /// found out.
  std::string encoding = {};
  /// CAD files: whether dimensions, tolerances, datums and notes that they carry are read.
  bool pmi = false;
  /// Whether the round surfaces that facets stand for are recognised and drawn; absent: those of
  /// OpenSCAD files are, those of meshes not.
  std::optional<bool> heal = {};
  /// Of the options that readers and forms of plug-ins declare.
  DeclaredValues declared = {};
  /// What the user set of all this: the name without dashes ("volume_degree"), and as messages call
  /// it ("option --volume-degree"). What no file of a scene looks at becomes a diagnostic.
  struct Given {
    std::string name;
    std::string spelled;
  };
  std::vector<Given> given = {};
};

/// The options about reading, each with the way to its member.
const std::vector<RequestRow<ReadOptions>>& read_option_rows();

/// What a request asks of reading. Throws UsageError that names the option.
ReadOptions make_read_options(const Request& request, Spelling spelling);

/// Whether an option about reading may concern a file, by the format that it has.
bool concerns(const std::string& option, const std::filesystem::path& path);

/// Whether our own readers know the suffix (".stl").
bool is_own_suffix(std::string_view suffix);

/// Whether some reader knows the suffix, those of plug-ins too.
bool is_read_suffix(std::string_view suffix);

/// Throws MissingFile or InputError for the first path that is no file that can be opened, and
/// UsageError where one names a form ("form:NAME") that no plug-in has.
void check_inputs(const std::vector<std::string>& paths);

/// Reads each file by the reader of its format (known by its content where that is clear, else by
/// its suffix); "-" is standard input, and what gzip packed is unpacked; the parts of all of them,
/// in order, and the diagnostic "option.unused" for each option that was given and concerns none of
/// them. Warnings of a reader begin with the name of their file. Stage "read". Throws InputError.
ReadResult read_files(const std::vector<std::string>& paths, const ReadOptions& options,
                      RunContext& context);
/// The same without what the files ask of their drawing.
Scene read_scene(const std::vector<std::string>& paths, const ReadOptions& options,
                 RunContext& context);

/// What `burin info` prints about a file. Throws InputError.
FileInfo inspect_file(const std::filesystem::path& path, const ReadOptions& options,
                      RunContext& context);

}  // namespace burin
