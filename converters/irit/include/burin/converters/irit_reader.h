#pragma once
/// Files of spline patches: IRIT data (.itd, .irt), Geomview Bezier patches (.bez, .bbp) and plain
/// patch lists.

#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <optional>
#include <string_view>

namespace burin {

/// Whether the suffix (any case) is one of this reader's: .itd .irt .bez .bbp.
bool is_irit_suffix(const std::filesystem::path& path);

/// Whether the first bytes of a file can only be this reader's.
bool is_irit_content(std::string_view head);

struct IritReadOptions {
  /// Trivariates: the value that their surface has, whether larger values are inside, and a box
  /// that clips it.
  double level = 0;
  bool inside_above = false;
  std::optional<Box3> bounds = {};
  /// Of names, as iconv knows it; empty: it is found out.
  std::string encoding = {};
};

/// Reads exact parts (ParametricForm; BrepForm of objects with trimmed surfaces). The files know no
/// unit: coordinates are taken as mm.
///
/// IRIT data: one part a named object. Surfaces of one object are one part, and so are those of
/// objects of the same list that have no names, or whose sides fit together: a vase in four named
/// patches is one vase. Enclosing lists that have names become Part::assembly; RGB and COLOR become
/// Part::color. Polygons become mesh parts, trivariates of points with one coordinate the surface
/// where they take `level` (ImplicitForm; parameters are mm). An INSTANCE is its original at
/// another place ("irit.no_original": the file has none). What is no surface (curves, polylines,
/// points) or not yet read (other trivariates, multivariates, triangular
/// patches) is left out and named in the diagnostics ("irit.no_surface", "irit.unread"), with its
/// first line.
///
/// Geomview patches and patch lists: all patches are one part, named by the file. A patch list is
/// what the teapot of Newell is passed on as: bicubic patches over shared points. Either the
/// numbers of points and of patches, for each point its number and coordinates, for each patch the
/// numbers of its 16 points; or the number of patches, the patches, the number of points, the
/// points. # begins a comment.
///
/// Throws InputError with line, and column in the text, for what is damaged, and where no surface
/// is left. Never allocates for what the file cannot hold. Cost: 0.1 s for 10 MB and 1 us per span
/// of a surface.
/// @cite Elber2009, Geomview2014
Scene read_irit(const std::filesystem::path& path, const RunContext& context,
                const IritReadOptions& options = {});

/// Reads and measures: faces are patches, edges their borders (each once); area, volume and open
/// edges are those of triangles within a ten-thousandth of the size. Of trimmed surfaces all are
/// those of the exact faces.
FileInfo inspect_irit(const std::filesystem::path& path, RunContext& context,
                      const IritReadOptions& options = {});

}  // namespace burin
