#pragma once
/// What a user chooses of directions.

#include <burin/base/vec.h>
#include <burin/options/declared.h>

#include <string>
#include <vector>

namespace burin::field {

/// What strokes follow on the faces of exact forms whose kind is known. Meshes have no such faces.
struct FacePolicy {
  enum class Plane {
    Differ,     // one direction a face along its outline, chosen so that neighbours over a crease
                // differ and smooth neighbours agree
    Direction,  // the tangent part of `FieldOptions::direction`
  };
  enum class Ruled { Circles, Rulings };
  enum class Sphere {
    Axis,  // circles of latitude about `FieldOptions::direction`
    View,  // ... about the line of view
  };
  Plane plane = Plane::Differ;
  /// Which of the two is family 1.
  Ruled cylinder = Ruled::Circles;
  Ruled cone = Ruled::Circles;
  /// Spheres whose neighbours give them no direction: a ball, not the corner between fillets.
  Sphere sphere = Sphere::Axis;

  bool operator==(const FacePolicy&) const = default;
};

struct FieldOptions {
  /// The name of a row of `catalogue()`.
  std::string name = "smoothed";
  /// In model space: what it means depends on the field; also what is followed where a surface has
  /// no direction of its own.
  Vec3 direction{0, 0, 1};
  /// How closely the smoothed field keeps to the curvature.
  double alignment = 1;
  /// The field "texture-image": share of its sides by which the picture is blurred before.
  double image_blur = 0.01;
  /// The field "texture-vector": formulas over u v x y z.
  std::string along_u = "1", along_v = "0";
  FacePolicy faces{};
  /// Of the options that fields from elsewhere declare.
  DeclaredValues declared{};

  bool operator==(const FieldOptions&) const = default;
};

/// Throws UsageError where a text is no formula; `group` is what its key begins with ("hatch.").
void check_texts(const FieldOptions& options, const std::string& group);

/// Names without a group: "field", "direction" ...
const std::vector<OptionRow<FieldOptions>>& field_option_rows();

}  // namespace burin::field
