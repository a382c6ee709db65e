#pragma once
/// What an illustration measures: rows that a user writes or a program fills in, and what arranging
/// makes of them.

#include <burin/annotate/dimensions.h>
#include <burin/base/vec.h>
#include <burin/measure/measure.h>
#include <burin/measure/print.h>
#include <burin/options/declared.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A face or an edge of a part, a point of the model, or, of notes, a whole part.
struct FeatureRow {
  enum class Kind : std::uint8_t { Face, Edge, Point, Part };
  Kind kind = Kind::Face;
  /// A selector; empty: any part that is drawn. Of a note it may name several parts: any will do.
  std::string part = {};
  /// As drawing files number faces and edges of the part; absent: the one that is nearest to `at`.
  std::optional<std::int32_t> number = {};
  /// Model mm, where the part was read.
  Vec3 at{0};
  /// What the numbered one looked like: where the model has changed it is found by this.
  std::optional<FeaturePrint> print = {};
};

/// One dimension or note as it is asked for.
struct DimensionRow {
  enum class Kind : std::uint8_t { Distance, Diameter, Radius, Angle, Depth, Thread, Note };
  Kind kind = Kind::Distance;
  /// Two of distances and angles, of the angle of a cone one; of a note any number, each with a
  /// leader; else one.
  std::vector<FeatureRow> of = {};
  /// Distance: measured in this direction; any length but 0.
  std::optional<Vec3> along = {};
  /// Angle: the one beside that between the features.
  bool supplement = false;
  /// What is written, with {value} for the number; empty: the number with its sign (⌀, R). Of a
  /// note lines, with the names of `note_values` in braces.
  std::string text = {};
  /// Note: whether a frame is about it, what its leaders end with, and the lower left corner of it
  /// on the sheet, paper mm; absent: a place is found.
  bool framed = false;
  /// A kind of symbol that the text stands in (`symbol_kinds`), with its options; empty: none.
  std::string symbol = {};
  DeclaredValues symbol_values = {};
  LeaderTarget::Mark mark = LeaderTarget::Mark::Found;
  std::optional<Vec2> at_sheet = {};
  /// Behind it: "±0.1", "H7"; or deviations above and below.
  std::string tolerance = {}, upper = {}, lower = {};
  /// Absent: as the style has it.
  std::optional<std::uint64_t> decimals = {};
  std::optional<DimensionOptions::Unit> unit = {};
  std::optional<DimensionOptions::Sign> sign = {};
  /// The name of the view where it stands, "front", "A-A"; empty: the first that shows it best.
  std::string view = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// "distance", "diameter", "note" ...
const char* to_string(DimensionRow::Kind kind);

/// What a note may say of the first thing that it points at, in braces: "part.name", "item",
/// "length" (of an edge), "area" (of a face), "diameter", "radius", "volume" (of its part).
const std::vector<std::string>& note_values();

/// A row with what was measured, before anything was cut or moved.
struct MeasuredRow {
  DimensionRow row;
  /// From 1, as messages call it.
  std::size_t number = 0;
  std::vector<Feature> of = {};
  /// Of each its part; kNoPart of a point.
  std::vector<std::size_t> parts = {};
  static constexpr std::size_t kNoPart = static_cast<std::size_t>(-1);
  /// Model mm; of an angle degrees.
  double value = 0;
  MeasuredDistance distance = {};
  MeasuredAngle angle = {};
  /// How far it moves with its parts that come apart.
  Vec3 moved{0};
  /// Of a note: how far each of the features moves; which of `row.of` each is. Features of one
  /// number stand for each other.
  std::vector<Vec3> moves = {};
  std::vector<std::size_t> target = {};
  /// Of a note: numbers that stand in its braces; what its first part is called, and its item.
  std::map<std::string, double> values = {};
  std::string part_name = {};
  int item = 0;
  /// Of each scene, that of the sheet and those of sections with views of their own: the surface of
  /// each feature's part as it is there; null where the feature was cut away.
  std::vector<std::vector<std::shared_ptr<const Surface>>> there = {};
};

}  // namespace burin
