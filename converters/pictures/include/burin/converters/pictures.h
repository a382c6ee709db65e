#pragma once
/// Files that styles name: drawings as motifs, pictures as textures.

#include <burin/base/image.h>

#include <filesystem>
#include <string>

namespace burin {

/// The lines of an SVG file as one text of path data (burin/drawing/path_data.h), in the file's own
/// units, y down: paths, lines, polylines, polygons, rectangles, circles and ellipses with their
/// transformations. What is defined for later use (defs, symbol, clipPath, mask, marker, pattern),
/// texts and what has display="none" are left out. Throws InputError, MissingFile where it draws
/// nothing, is no SVG, or is larger than 8 MB; names the line.
std::string read_svg_lines(const std::filesystem::path& path);

/// A PNG file as lightness: linear in what the pixels say (no gamma), colours by their luminance
/// (ITU-R BT.709), transparent ones on white. Throws InputError, MissingFile where it is no PNG,
/// damaged or cut off, or has more than 16 million pixels, which is tested before it is decoded.
Image read_png(const std::filesystem::path& path);

}  // namespace burin
