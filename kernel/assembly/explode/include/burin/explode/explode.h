#pragma once
/// Exploded views: in which order, which way and how far the parts of an assembly come apart.

#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/explode/step.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

struct ExplodeOptions {
  /// Parts leave along this line alone; absent: along the axes of the assembly and of its contacts.
  std::optional<Vec3> along = {};
  /// Along `along` one way only, not back.
  bool one_way = false;
  /// The part that stays; absent: the one with the largest box.
  std::optional<std::size_t> base = {};
  /// Model mm by which parts may lie in each other and still come apart (press fits, threads);
  /// absent: 1 % of the least extent of the smaller part, and the chord errors.
  std::optional<double> fit = {};
  /// Free space between parts, as a share of the diagonal of what comes apart.
  double gap = 0.06;
};

struct Explosion {
  /// By the numbers of the parts, in the order of disassembly; sub-assemblies first as wholes, then
  /// what is in them.
  std::vector<ExplodeStep> steps;
  /// Parts that no direction sets free from each other; each set moves as one.
  std::vector<std::vector<std::size_t>> interlocked;
};

/// Where parts are after steps: model mm, one per part of a scene of `count` parts. Factor 0 is
/// together, 1 apart.
std::vector<Vec3> moves_of(const std::vector<ExplodeStep>& steps, std::size_t count, double factor);

/// Moves the parts of a scene by so many model mm, one a part; copies of one shape stay that.
void move_parts(Scene& scene, const std::vector<Vec3>& moves);

/// Selectors (burin/assembly/select.h) that name these parts and no others: an assembly where all
/// its parts are meant, else a path, else a number.
std::vector<std::string> selectors_of(const Scene& scene, const std::vector<std::size_t>& parts);

/// An assembly as explosion looks at it: the triangles of its parts, what touches what. Keeps the
/// triangles, not the scene.
class ExplodeModel {
 public:
  /// `drawn`: one a part; others are as if they were not there. Parts that cannot be realised are
  /// left out without a word: drawing them says it. Cost: the tessellation of all parts, and 1024
  /// rays a part. Throws Cancelled.
  ExplodeModel(const Scene& scene, const std::vector<bool>& drawn, RunContext& context);
  ~ExplodeModel();
  ExplodeModel(ExplodeModel&&) noexcept;

  /// The steps that take the assembly apart. B blocks A along a direction where, on some ray, A is
  /// not behind all of B; what nothing blocks can go, the smallest first, then what has the
  /// shortest way. Each goes so far that its box clears those of all that are still there. Equal
  /// for any number of threads; a moved, turned or scaled assembly gives the same steps, moved.
  /// Diagnostics "explode.interlocked" name what stays together, "explode.boxes" tells of more than
  /// 2,000 parts, whose boxes block each other by their middles instead of rays,
  /// "explode.directions" of contact axes that were not tried, "explode.alone" of fewer than two
  /// parts. Cost: 324 rays a part and axis and some to be sure,
  /// at most 12 axes.
  /// @cite Li2008
  Explosion find(const ExplodeOptions& options, Diagnostics& diagnostics,
                 const RunContext& context) const;

  /// Lines of kind Trail from the middle of a contact to where it is after all steps: one for what
  /// moved together, one for a stack on one axis. Straight, or with one bend where the other part
  /// has moved another way.
  /// `there`: parts that are, one flag each; all of them where it is empty.
  std::vector<Curve3> trails(const std::vector<ExplodeStep>& steps, double factor,
                             const std::vector<bool>& there = {}) const;

  /// Model mm that `moving` has to go along a unit vector until its box clears those of `remaining`
  /// which lie in its way; 0 where none does.
  double way_out(const std::vector<std::size_t>& moving, const std::vector<std::size_t>& remaining,
                 Vec3 along) const;

  /// The triangles of each part, empty where it was not drawn or could not be realised; as long as
  /// the model is there.
  std::span<const ProxyMesh* const> proxies() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
