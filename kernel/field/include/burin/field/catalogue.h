#pragma once
/// The direction fields by name, as styles ask for them: one row each.

#include <burin/field/field.h>

#include <span>
#include <string_view>

namespace burin::field {

/// What a field may be made from; each row takes what it wants of it.
struct FieldRequest {
  /// One a part; they outlive the field.
  const std::vector<const Surface*>& surfaces;
  const Camera& camera;
  const FieldOptions& options;
  /// To the light, in model space.
  Vec3 light{0, 0, 1};
  /// As AngleOptions::flat, in 1/model mm.
  double flat = 0;
  const RunContext& context;
  /// The picture of the strokes, where they have one.
  std::shared_ptr<const Image> image{};
};

struct FieldKind {
  std::string_view name;
  /// What strokes follow, in a few words.
  std::string_view meaning;
  /// Whether it asks frames for principal curvatures; a mesh need not compute them otherwise.
  bool needs_curvature = false;
  /// Why a surface may have no direction over more than single places; empty: it always has.
  std::string_view missing;
  Field (*make)(const FieldRequest&);
  /// Whether it looks at `FieldRequest::light`.
  bool uses_light = false;
  /// Whether its crosses have levels.
  bool has_levels = false;
};

/// All fields, the usual one first.
std::span<const FieldKind> catalogue();

/// The field of that name. Throws UsageError that lists them all.
const FieldKind& find(std::string_view name);

}  // namespace burin::field
