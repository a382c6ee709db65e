#pragma once
// Healed triangles as faces with parameters, which can be cut along exact contours; internal to
// the room.

#include <burin/contour_cut/contour_cut.h>

#include "faces.h"
#include "patch_chart.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin::recognised {

class ExactFaces {
 public:
  ExactFaces(const FacetMesh& mesh, const Faces& faces, const Facets& facets,
             const Recognised& round, double tolerance, const RunContext& context);
  ~ExactFaces();

  /// Whether every triangle lies on a surface that is known: no stretch of facets is left whose
  /// surface is a guess. Then it can be cut.
  bool exact() const { return exact_; }
  /// Returns false where that was ended: see cut_along_contours.
  bool cut(const Camera& camera, const RunContext& context);

  /// For each triangle its patch or -1.
  std::vector<std::int32_t> patches() const;
  ProxyMesh proxy(const RunContext& context) &&;

 private:
  class Surfaces;

  void add_cells(const FacetMesh& mesh, const Recognised& round, const RunContext& context);
  void add_borders(const FacetMesh& mesh, const RunContext& context);

  const Faces& faces_;
  ChartMesh mesh_;
  std::unique_ptr<Surfaces> surfaces_;
  bool exact_ = true, cut_ = false;
};

}  // namespace burin::recognised
