#pragma once
/// What tells a face or an edge from the others of its part, to find it again in a model that has
/// changed.

#include <burin/measure/feature.h>

#include <optional>
#include <vector>

namespace burin {

/// What is kept of a feature.
struct FeaturePrint {
  FeatureKind kind = FeatureKind::Other;
  /// mm2 of a face, mm of an edge; mm, 0 where it has none.
  double size = 0, radius = 0;
  /// Its middle, mm from the low corner of its part's box; the size of this.
  Vec3 at{0}, box{0};
  /// Its normal, way or axis; 0: it has none.
  Vec3 along{0};
  /// The faces beside it, by kind.
  std::vector<FeatureKind> beside = {};

  bool operator==(const FeaturePrint&) const = default;
};

/// The faces and edges of a part, as prints tell them apart.
class FeatureIndex {
 public:
  /// `edges`: whether edges are asked for, too. Cost: that of `face_feature` for each face, and of
  /// `edge_feature` for each edge.
  FeatureIndex(const Surface& surface, bool edges, const RunContext& context);

  /// Nothing where the part has no such face or edge.
  std::optional<FeaturePrint> face(std::int32_t number) const;
  std::optional<FeaturePrint> edge(std::int32_t number) const;
  /// The number of the face or edge that a print is nearest to, `number` where that is as near as
  /// any; nothing where none is near enough: of its kind, of a size between half and twice that,
  /// not much farther from either end of the part than 15 % of its diagonal.
  std::optional<std::int32_t> find_face(const FeaturePrint& print, std::int32_t number) const;
  std::optional<std::int32_t> find_edge(const FeaturePrint& print, std::int32_t number) const;

 private:
  struct Entry {
    std::int32_t number = -1;
    FeaturePrint print;
  };
  static std::optional<FeaturePrint> entry(const std::vector<Entry>& list, std::int32_t number);
  static std::optional<std::int32_t> find(const std::vector<Entry>& list, const FeaturePrint& print,
                                          std::int32_t number);

  std::vector<Entry> faces_, edges_;
};

}  // namespace burin
