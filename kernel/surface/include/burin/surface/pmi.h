#pragma once
/// Product and manufacturing information: what a CAD file says of a part's sizes, tolerances and
/// datums, and how it shows that in space.

#include <burin/base/placement.h>
#include <burin/base/vec.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

enum class PmiKind { Dimension, Tolerance, Datum, DatumTarget, Note, Other };

/// "dimension", "tolerance", "datum", "datum_target", "note", "other".
const char* to_string(PmiKind kind);

/// A polyline in space; a closed one does not repeat its first point.
struct PmiLine {
  std::vector<Vec3> points;
  bool closed = false;
};

/// The plane that an annotation lies in.
struct PmiPlane {
  Vec3 origin{0};
  /// Unit: to whom it is read by, and the way of its texts.
  Vec3 normal{0, 0, 1}, along{1, 0, 0};
};

/// One dimension, tolerance, datum, datum target or note. What is absent the file does not say.
struct PmiItem {
  PmiKind kind = PmiKind::Other;
  /// "diameter", "position", "flatness"; of Other what the file calls it.
  std::string what = {};
  /// What the file calls it: "Linear Size.1".
  std::string name = {};
  /// In one line, UTF-8: "⌀ 35 +0/-0.2", "position ⌀ 0.75 (M) | A | B | C". Of a note its text.
  std::string text = {};
  /// In `unit`, "mm", "in", "deg" and so on, as the file has it.
  std::optional<double> value = {};
  std::string unit = {};
  /// Deviations from the value; the largest and smallest size.
  std::optional<double> upper = {}, lower = {}, most = {}, least = {};
  /// The class of a fit, "H7".
  std::string fit = {};
  /// Words of the standard: "maximum material", "free state".
  std::vector<std::string> modifiers = {};
  /// Of a tolerance, in order, with what is said of each: "A", "B (M)", "A-B"; of a datum its
  /// letter; of a target "A1".
  std::vector<std::string> datums = {};
  /// Of the part, as they are numbered there; ascending.
  std::vector<std::int32_t> faces = {};
  /// The saved views that show it.
  std::vector<std::string> views = {};
  /// How it is shown, in the coordinates of the part: lines, and outlines of what is filled (inside
  /// an odd number of them). None: the file does not show it.
  std::optional<PmiPlane> plane = {};
  std::vector<PmiLine> lines = {}, filled = {};
  /// The item before it whose lines show this one too, as where frames of two tolerances are one;
  /// -1: none.
  std::int32_t shown_with = -1;

  bool shown() const { return !lines.empty() || !filled.empty(); }
};

/// A view that the file names. Directions are units.
struct PmiView {
  std::string name;
  Vec3 to_viewer{0, 0, 1}, up{0, 1, 0};
};

/// What a file says of one part.
struct Pmi {
  std::vector<PmiItem> items;
  std::vector<PmiView> views = {};
};

/// The same where the part stands.
struct PlacedPmi {
  /// Shared by instances; none: there is nothing, or it was not asked for.
  std::shared_ptr<const Pmi> pmi = {};
  Placement placement = {};

  explicit operator bool() const { return pmi != nullptr; }
  void move(const Placement& by) { placement = after(by, placement); }
};

}  // namespace burin
