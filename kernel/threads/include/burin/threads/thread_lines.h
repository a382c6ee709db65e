#pragma once
/// The lines that stand for threads.

#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/surface/thread.h>

#include <span>
#include <vector>

namespace burin {

/// The threads of a part that are drawn.
struct DrawnThreads {
  std::vector<Thread> threads = {};
  /// Paper mm from the thin lines to the outline of the modelled cylinder, at the least.
  double gap = 0.7;

  bool operator==(const DrawnThreads&) const = default;
};

/// Adds lines of kind Thread and ThreadEnd as ISO 6410 has them to the lines of the parts, in the
/// order of parts and threads; they go through visibility as other lines on a surface. `threads`:
/// one a part, or none at all; those without a face are left out. Thin (Thread), at `Thread::thin`
/// from the axis or farther from the modelled cylinder where the gap asks for it:
/// - of a screw both outlines of the cylinder of the roots, on the surface that lies over it;
/// - in cut faces the lines in which the cut meets that cylinder;
/// - at an open end three quarters of the circle, on the surface in which the thread ends, without
///   the quarter that is up and right on the sheet. Who looks along the axis sees no circle of the
///   chamfer there: that crease is taken out.
/// Wide (ThreadEnd), where a thread ends within a shaft or a hole: the circle of the modelled
/// cylinder, and in cut faces from there to the thin lines. Of a hole that is not cut the outlines
/// and the end lie within the part and are hidden all along. Threads so small that the gap takes
/// more than half of their radius are left out; a warning
/// names them and the scale that would do. @cite ISO6410
void add_thread_lines(std::span<const DrawnThreads> threads,
                      std::span<const ProxyMesh* const> proxies, const Camera& camera,
                      std::vector<Curve3>& features, Diagnostics& diagnostics,
                      const RunContext& context);

}  // namespace burin
