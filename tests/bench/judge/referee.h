#pragma once
/// Whether a line of the model can be seen at a place of the picture: decided by rays against a
/// fine tessellation, by nothing that drew either side's lines.

#include <burin/base/run_context.h>
#include <burin/surface/scene.h>
#include <burin/visibility/occluder.h>

#include "lines.h"

#include <memory>
#include <vector>

namespace burin::judge {

class Referee {
 public:
  /// Tessellates every part at 0.004 mm of paper.
  Referee(const Scene& scene, const View& view, RunContext& context);

  /// Whether rays within `radius` mm of a place see more than one smooth sheet of one face: paper
  /// and part, two faces, or a jump in depth.
  bool line_near(Vec2 paper, double radius) const;

 private:
  struct Seen {
    bool hit = false;
    std::int32_t part = -1, face = -1;
    double depth = 0;  // model mm, larger is nearer
    double slope = 0;  // of the surface against the picture
    Vec2 paper{0};
  };
  Seen look(Vec2 paper) const;
  bool differ(const Seen& a, const Seen& b) const;

  View view_;
  std::vector<std::shared_ptr<const Surface>> surfaces_;
  std::vector<const ProxyMesh*> proxies_;
  std::unique_ptr<Occluder> occluder_;
};

}  // namespace burin::judge
