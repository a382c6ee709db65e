#pragma once
/// The areas of a drawing beside rays.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/drawing/areas_at.h>
#include <burin/drawing/drawing.h>
#include <burin/feature/isophotes.h>
#include <burin/verify/referee.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace burin {

/// What areas state of a place, or rays see there.
struct AreaFacts {
  /// -1: the bare sheet.
  std::int32_t part = -1;
  /// As in `Area`.
  std::int32_t face = -1, tone = -1;
};

enum class AreaFinding : std::uint8_t { Holds, WrongPart, WrongFace, WrongTone };
/// "holds", "wrong_part", "wrong_face", "wrong_tone".
const char* to_string(AreaFinding finding);

/// What a look at a place gave.
struct AreaAnswer {
  AreaFinding finding = AreaFinding::Holds;
  AreaFacts stated, seen;
  /// Of what is seen.
  Vec3 model{0};
};

/// Areas of a view in the order of painting, and what they are to be true of.
struct AreaRule {
  std::span<const Area> areas;
  /// One a part: where its tone has a step.
  std::vector<Isophotes> tones{};
  /// One a part: those that can be looked through, whose areas lie over the others; empty: none.
  std::vector<bool> glass{};
  /// Light (a cosine) by which a normal between facets may be off: another tessellation has others.
  double facet_light = 0;
  /// Paper mm, as `light_normals` has it.
  double pen = 0;
  /// From the model to the light by which solid parts cast shadows, which have the step 0; nothing:
  /// none do.
  std::optional<Vec3> shadows{};
  /// One a part: those that cast none, glass too; empty: all do.
  std::vector<bool> unshaded{};
};

/// Who is asked for what is seen.
struct AreaWitnesses {
  /// Of the solid parts, and of all parts.
  const Referee& solid;
  const Referee& all;
  /// For each part: of the solid ones and itself. Null where it has no surface; then its areas
  /// hold.
  std::function<const Referee*(std::int32_t part)> with = {};
  /// Of meshes as coarse as they were drawn: what is noise of their triangles depends on these
  /// (`light_normals`). Null: the solid parts are.
  const Referee* toned = nullptr;
  /// Of the parts that cast shadows. Null: the solid parts do.
  const Referee* casting = nullptr;
};

/// Compares areas with rays at single places. Read by many threads.
class AreaJudge {
 public:
  /// Both must outlive the judge, and so must what they refer to. Throws Cancelled.
  AreaJudge(const AreaRule& rule, const AreaWitnesses& witnesses, const RunContext& context);

  /// What speaks against the areas at the very place (paper mm).
  AreaAnswer at(Vec2 paper) const;
  /// Whether a border of an area passes within 0.12 mm, so that the place may count to either side.
  bool beside_border(Vec2 paper) const;
  /// What speaks against the areas, wherever one looks within the radius of the referees, at a
  /// place that lies beside no border. Cost: a ray where the areas are plainly right, else 25.
  AreaAnswer test(Vec2 paper) const;

 private:
  /// What areas state of a place.
  struct Claim {
    AreaFacts solid;
    std::vector<std::int32_t> glass;
  };
  Claim claim(Vec2 paper) const;
  std::pair<std::int32_t, std::int32_t> tones_of(const Referee::Sheet& sheet) const;
  std::array<Vec3, 4> lit_normals(const Referee::Sheet& sheet) const;
  std::pair<std::int32_t, std::int32_t> lit_tones_of(const Referee::Sheet& sheet) const;
  AreaAnswer ask(const Claim& claim, Vec2 paper) const;
  AreaAnswer ask_solid(const AreaFacts& stated, Vec2 paper) const;
  AreaAnswer ask_glass(const Claim& claim, Vec2 paper) const;
  bool is_glass(std::int32_t part) const;

  const AreaRule& rule_;
  const AreaWitnesses& witnesses_;
  AreasAt areas_;
  /// By part: `light_normals`.
  std::vector<std::vector<Vec3>> normals_;
};

}  // namespace burin
