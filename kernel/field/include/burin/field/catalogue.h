#pragma once
/// The direction fields by name, as styles ask for them: one row each.

#include <burin/field/field.h>
#include <burin/options/declared.h>
#include <burin/surface/visible_surfaces.h>

#include <functional>
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
  /// What the picture shows of the surfaces.
  VisibleSurfaces shown{};
};

struct FieldKind {
  std::string_view name;
  /// What strokes follow, in a few words.
  std::string_view meaning;
  /// Whether it asks frames for principal curvatures; a mesh need not compute them otherwise.
  bool needs_curvature = false;
  /// Why a surface may have no direction over more than single places; empty: it always has.
  std::string_view missing;
  std::function<Field(const FieldRequest&)> make;
  /// Whether it looks at `FieldRequest::light`.
  bool uses_light = false;
  /// Whether its crosses have levels.
  bool has_levels = false;
  /// What it lets a user choose beside `FieldOptions`; the values stand in
  /// `FieldOptions::declared`.
  std::vector<DeclaredOption> options{};
};

/// All fields, the usual one first; those that were added last.
std::span<const FieldKind> catalogue();

/// Adds a field from elsewhere, or puts it in the place of one of its name that was added. Its
/// texts live as long as the program. Throws UsageError where a field of our own has the name.
void add(FieldKind kind);

/// The field of that name. Throws UsageError that lists them all.
const FieldKind& find(std::string_view name);

}  // namespace burin::field
