#pragma once
/// Kinds of strokes from elsewhere: what stands on points in the place of a stroke. Each is a way
/// to place strokes, too: its name is one of `HatchOptions::placing`.

#include <burin/camera/camera.h>
#include <burin/options/declared.h>
#include <burin/stroke/options.h>
#include <burin/surface/visible_surfaces.h>

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace burin {

/// A point that a mark stands on: the normal turned to the viewer, the unit way of the strokes, the
/// ink that the tone asks for, and a number in [0, 1) of its own.
struct MarkPlace {
  Vec3 position{0}, normal{0, 0, 1}, direction{1, 0, 0};
  double ink = 0, random = 0;
};

/// Lines of points in shares of `HatchOptions::length`: along the way, and to its left for the
/// viewer.
using MarkLines = std::vector<std::vector<Vec2>>;

/// May be called from many threads.
using Marks = std::function<MarkLines(const MarkPlace&)>;

struct MarkRequest {
  const Camera& camera;
  const HatchOptions& options;
  const VisibleSurfaces& shown;
};

struct MarkKind {
  std::string_view name;
  /// What stands on points, in a few words.
  std::string_view meaning;
  std::function<Marks(const MarkRequest&)> make;
  /// The values stand in `HatchOptions::declared`.
  std::vector<DeclaredOption> options{};
};

/// All that were added.
std::span<const MarkKind> mark_kinds();

/// Adds a kind, or puts it in the place of one of its name. Its texts live as long as the program.
/// Throws UsageError where a way to place strokes of our own has the name.
void add(MarkKind kind);

}  // namespace burin
