#pragma once
// Files that a tree names; for converters/openscad alone.

#include <burin/base/missing_file.h>

#include "at_node.h"
#include "flat/flat.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace burin::csg {

/// The file of a node's argument "file"; relative ones begin at the folder of the evaluation.
std::filesystem::path file_of(const Evaluation& e, std::uint32_t node);
/// A name or layer as it was before OpenSCAD put backslashes before its quotes.
std::string unescaped(std::string_view text);
/// Its suffix, lowered, with the dot.
std::string suffix_of(const std::filesystem::path& path);

/// What `read` returns; where the file is not there (or the name is empty, which leaves a folder)
/// nothing, which the diagnostics tell.
template <typename Read>
auto if_there(Evaluation& e, std::uint32_t node, Read&& read) -> decltype(read()) {
  const auto missing = [&](const std::string& file) -> decltype(read()) {
    report(e, node, "openscad.no_file", file + ": no such file; it is left out, as OpenSCAD does");
    return {};
  };
  if (std::error_code no; std::filesystem::is_directory(file_of(e, node), no)) {
    return missing(file_of(e, node).string());
  }
  try {
    if (e.tree.nodes[node].text("file").empty()) throw MissingFile("no file is named", "import()");
    return std::forward<Read>(read)();
  } catch (const MissingFile& error) {
    return missing(error.file());
  }
}

/// Outlines of a DXF file by the node's layer, origin and scale, as OpenSCAD reads them: lines,
/// light polylines, circles, arcs, ellipses and blocks; what is open is closed. Throws InputError
/// with the line where the file is no DXF.
Region import_dxf(Evaluation& e, std::uint32_t node);
/// The shapes of an SVG file, as OpenSCAD reads them. Throws InputError where it is no XML.
Region import_svg(Evaluation& e, std::uint32_t node);
/// The block below a grid of heights, from text or a PNG.
Solid height_map(Evaluation& e, std::uint32_t node);

}  // namespace burin::csg
