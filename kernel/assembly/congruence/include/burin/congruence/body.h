#pragma once
/// Whether surfaces lie on each other, and by which move one comes to lie on the other.

#include <burin/base/placement.h>
#include <burin/base/run_context.h>
#include <burin/congruence/pose.h>
#include <burin/surface/scene.h>

#include <memory>
#include <optional>
#include <vector>

namespace burin {

class NearSurface;

/// The triangles by which shapes are compared: within 2e-4 of the size of a form; of meshes their
/// own facets, as rounded ones would be compared by what they are taken for, and cost ten times as
/// much. Throws as `Form::realise`.
std::shared_ptr<const Surface> realised_to_compare(const Form& form, RunContext& context);

/// A part's triangles with what is asked of them again and again. Cost: 5 us a triangle.
class Body {
 public:
  explicit Body(const std::shared_ptr<const Surface>& surface);
  /// Triangles that lie within `tolerance` mm of the shape that they stand for.
  Body(std::shared_ptr<const TriMesh> mesh, double tolerance);

  /// Its image in a mirror.
  Body mirrored() const;

  const TriMesh& mesh() const { return *mesh_; }
  /// Model mm.
  double tolerance() const { return tolerance_; }
  const Pose& pose() const { return pose_; }
  /// Even by area, the same for the same triangles.
  const std::vector<Vec3>& samples() const { return samples_; }
  /// Whether a triangle lies within `reach` mm of a point.
  bool holds(Vec3 point, double reach) const;

 private:
  std::shared_ptr<const TriMesh> mesh_;
  double tolerance_;
  Pose pose_;
  std::vector<Vec3> samples_;
  std::shared_ptr<const NearSurface> near_;
};

/// The share of the samples of both, each moved to the other, that lie on the other's surface
/// within `place` mm and what their triangles are off.
double share_on_each_other(const Body& before, const Body& after, const Placement& move,
                           double place);

/// Whether all of it does, but for a sample or two that rounding decides.
bool coincide(const Body& before, const Body& after, const Placement& move, double place);

/// The rigid move that turns least of those that lay a shape on its copy elsewhere, no mirror image
/// among them; nothing where none is found. Cost: 0.2 ms a turn that is tried, some hundreds of
/// them at the most. Throws Cancelled.
std::optional<Placement> rigid_move(const Body& before, const Body& after, double place,
                                    const RunContext& context);

}  // namespace burin
