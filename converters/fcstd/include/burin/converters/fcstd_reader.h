#pragma once
/// FreeCAD documents (`.FCStd`), read without FreeCAD.

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct FcstdOptions {
  /// Names or labels of the objects to take, visible or not; none = all that are visible.
  std::vector<std::string> objects = {};
  /// Lets FreeCAD open and recompute a copy first: the program that BURIN_FREECAD names, else
  /// `freecadcmd` or `FreeCADCmd` on PATH.
  bool recompute = false;
  /// After so many seconds FreeCAD is ended.
  double timeout = 300;
};

/// Whether the suffix (any case) is `.fcstd`.
bool is_fcstd_suffix(const std::filesystem::path& path);
/// Whether the first bytes are those of a zip archive whose first member is `Document.xml`, as
/// FreeCAD writes them.
bool is_fcstd_content(std::string_view head);

/// One part for each visible object with faces, named by its label, in the order of the document's
/// tree, at its place through parts, groups and links (links into other documents too, which are
/// looked for beside this one); `assembly` holds the labels of what contains it. A body is its own
/// shape, features inside it are not drawn. Colours are those of the last save with a window. An
/// object that cannot be read becomes a diagnostic "fcstd.*". Throws InputError where nothing is
/// left to draw, where an object that was asked for does not exist (naming the nearest), and for
/// archives that are broken or unpack to absurd sizes. kernel/docs/freecad.md has the details.
Scene read_fcstd(const std::filesystem::path& path, const FcstdOptions& options,
                 RunContext& context);

/// Counts and measures of the same parts. Throws InputError as `read_fcstd` does.
FileInfo inspect_fcstd(const std::filesystem::path& path, const FcstdOptions& options,
                       RunContext& context);

}  // namespace burin
