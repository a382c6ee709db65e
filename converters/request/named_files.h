#pragma once
// Files that a style names: drawings as motifs, pictures as textures.

#include <burin/illustrate/illustrate.h>

#include <filesystem>

namespace burin::detail {

/// Puts the lines of the SVG files that motifs of a style name in the place of the names, and makes
/// the names of its pictures absolute; both are looked for from `folder`. Throws as
/// `read_svg_lines`.
void find_named_files(Style& style, const std::filesystem::path& folder);

/// Reads the pictures of a style, as `find_named_files` left it, that are not there yet. Throws as
/// `read_png`.
void read_images(const Style& style, Images& images);

}  // namespace burin::detail
