#pragma once
// Pieces of paths; internal to the module.

#include <burin/drawing/drawing.h>

#include <vector>

namespace burin {

/// A path as one that is open: a closed one has its first point again at its end. Places along it
/// are the index of a segment and the share of it. Holds the path by reference.
class OpenedPath {
 public:
  explicit OpenedPath(const Path& path);

  const Path& path() const { return path_; }
  const std::vector<Vec2>& points() const { return points_; }
  /// Paper mm between two places.
  double length(double begin, double end) const;
  /// What stands between two places, with its widths, model points and faces.
  Path piece(double begin, double end) const;

 private:
  const Path& path_;
  std::vector<Vec2> points_;
  std::vector<Vec3> points3_;
  std::vector<double> width_;
  /// Paper mm up to each point.
  std::vector<double> along_;
};

/// Adds what a path stands for, too, unless it is its own source or known already.
void add_also(Path& path, const PathSource& source);

/// Adds a piece that begins where another ends.
void append(Path& to, const Path& more);

}  // namespace burin
