#pragma once
/// What a picture shows, for directions and laws of tone that look at it as a whole.

#include <burin/base/box.h>
#include <burin/surface/surface.h>

#include <functional>
#include <optional>
#include <span>

namespace burin {

/// A place of a proxy that is seen.
struct VisiblePlace {
  std::int32_t part = -1;
  ProxyPoint point;
};

/// All of it lives as long as strokes are placed.
struct VisibleSurfaces {
  /// One a part; empty ones where a part has no such strokes.
  std::span<const Surface* const> surfaces{};
  /// What is seen of them at a point of the paper; empty: nobody knows. From many threads.
  std::function<std::optional<VisiblePlace>(Vec2 paper)> at{};
  /// The run that it is shown in; null: none that can be cancelled.
  const RunContext* context = nullptr;
};

/// The box of all proxies in model mm; empty where they have no triangles.
Box3 box_of(std::span<const Surface* const> surfaces);

}  // namespace burin
