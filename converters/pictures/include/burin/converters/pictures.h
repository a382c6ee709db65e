#pragma once
/// Files that styles and sheets name: drawings as motifs, pictures as textures, title blocks.

#include <burin/annotate/title_block.h>
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

/// A title block, or a whole sheet with one, from an SVG file: its lines (shapes that are filled
/// are outlined) and its level texts. A text with an attribute `freecad:editable`, or with the name
/// of a field as its `id`, is a field; names of TechDraw's templates that mean one of
/// `title_block_fields` become that. Colours and fonts are those of the drawing. Throws InputError,
/// MissingFile where it is no SVG, has no size or draws nothing; names the line.
TitleBlockLayout read_title_block(const std::filesystem::path& path);

/// A PNG file as lightness: linear in what the pixels say (no gamma), colours by their luminance
/// (ITU-R BT.709), transparent ones on white. Throws InputError, MissingFile where it is no PNG,
/// damaged or cut off, or has more than 16 million pixels, which is tested before it is decoded.
Image read_png(const std::filesystem::path& path);

}  // namespace burin
