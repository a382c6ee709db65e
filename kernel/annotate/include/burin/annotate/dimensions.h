#pragma once
/// Dimensions: how long, wide or steep something is, on a line beside it.

#include <burin/annotate/label.h>
#include <burin/base/box.h>
#include <burin/base/ids.h>
#include <burin/camera/camera.h>
#include <burin/camera/sheet.h>
#include <burin/drawing/drawing.h>
#include <burin/options/row.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace burin {

struct DimensionOptions {
  /// Paper mm, of the numbers.
  double height = 3.5;
  /// Paper mm of the lines: narrow, after ISO 128-2.
  double line = 0.18;
  /// Places after the point; zeros at the end are left out.
  std::uint64_t decimals = 2;
  enum class Sign { Point, Comma };
  /// Between units and decimals.
  Sign sign = Sign::Point;
  enum class Unit { Millimetre, Centimetre, Metre, Inch };
  /// Lengths are written in it; all but millimetres say so.
  Unit unit = Unit::Millimetre;

  bool operator==(const DimensionOptions&) const = default;
};

/// "height", "line", "decimals", "sign", "unit".
std::vector<OptionRow<DimensionOptions>> dimension_option_rows();

/// A length in model mm as it is written: "80", "12.5", "3.15 in"; an angle in degrees: "45°".
std::string dimension_text(double length, const DimensionOptions& style);
std::string angle_text(double degrees, const DimensionOptions& style);

/// Whether a length is as long on paper as it is. `axes`: right, up and to the viewer, in rows.
bool is_seen_square(const Mat3& axes, Vec3 length);

/// What a leader of a note points at.
struct LeaderTarget {
  enum class Mark : std::uint8_t {
    Found,  // a dot where there is room for it, else an arrow
    Dot,    // within an outline
    Arrow,  // on a line
    None,
  };
  Mark mark = Mark::Found;
  SourceId source = {};
  /// Model mm: any of them will do.
  std::vector<Vec3> tips = {};
  /// Model mm about each tip that show the same.
  std::vector<double> rooms = {};
};

/// One dimension, or a note, in space, model mm: where it stands on paper is found for the view
/// that shows it.
struct Dimension {
  enum class Kind : std::uint8_t {
    Length,  // a line with two arrows between extension lines
    Round,   // a leader to a circle or an arc, for diameters and radii
    Angle,   // an arc with two arrows
    Note,    // a label, with leaders
  };
  Kind kind = Kind::Length;
  /// Length: its ends. Round: the centre, and a point of the circle, in the middle of an arc.
  /// Angle: where both sides meet, and a point of one side, as far out as there is something of it.
  Vec3 from{0}, to{0};
  /// Angle: a point of the other side. Round: unit, across the circle.
  Vec3 other{0};
  /// Round: degrees of the circle that there are.
  double sweep = 360;
  /// Length: points of what lies at its ends. Extension lines begin at the outermost that are on
  /// them. Empty: at the last ink on them, or at the end itself. Angle: points of both sides.
  /// Round: those of the circle that are seen, in `from_points`, on which leaders end; empty: all.
  std::vector<Vec3> from_points = {}, to_points = {};
  /// Length: unit, the way across it to its line; 0: the best is found.
  Vec3 outwards{0};
  /// Length: one of the whole drawing, outside all others.
  bool overall = false;
  /// UTF-8: "80", "⌀20 H7"; deviations behind it, one above the other; empty: none.
  std::string text = {}, upper = {}, lower = {};
  /// Note: what stands there; leaders of the first target are looked for, those of the others run
  /// from its elbow.
  std::shared_ptr<const Label> label = {};
  std::vector<LeaderTarget> targets = {};
  /// Note: paper mm of the sheet, its lower left corner; absent: a place is found.
  std::optional<Vec2> place = {};
};

/// Places of the circle or arc of a Round dimension where its leader may end.
std::vector<Vec3> points_of_round(const Dimension& dimension);

/// What a view measures.
struct ViewDimensions {
  std::vector<Dimension> list = {};
  /// The box of what is drawn, model mm, outside of which dimensions stand.
  Box3 about = {};
  /// Lines that stand about it, such as annotations of its file, model mm: dimensions stand outside
  /// of them, too.
  std::vector<std::vector<Vec3>> beside = {};
  /// Paper mm beside it that something else takes, such as the line of a section.
  Margin taken{0};
  /// Where that is known: lines that are laid over the drawing later, as of sections and details,
  /// paper mm. No text lies on them.
  std::vector<std::vector<Vec2>> over_it = {};
  /// What other views and callouts leave for texts, paper mm.
  std::optional<Box2> within = {};
};

/// An orthographic view: right, up and to the viewer, unit; paper mm a model mm; where the model's
/// origin is on paper.
struct PaperView {
  Mat3 axes{1};
  double scale = 1;
  Vec2 origin{0};

  Vec2 at(Vec3 p) const { return origin + scale * Vec2(axes * p); }
};

/// Dimensions and notes as lines, arrows and texts.
struct LaidDimensions {
  Layer layer{"dimensions", {}};
  Layer notes{"notes", {}};
  /// Of the symbols of notes, filled.
  std::vector<Area> areas = {};
  /// Of all of it, paper mm; empty where there is none.
  Box2 box = {};
};

/// Finds the places of dimensions: the shortest lines next to the drawing, the others beyond them
/// in steps, those of the whole drawing outermost; leaders and angles where they are short. No
/// number lies on another or on a line, no dimension line on another, as long as 40 steps find such
/// places. Numbers read from below or from the right. Where arrows or a number have no room within,
/// they stand outside. `drawn`: extension lines of ends without points begin at its ink; may be
/// null. @cite ISO129
LaidDimensions lay_out(const ViewDimensions& dimensions, const PaperView& view,
                       const DimensionOptions& style, const Drawing* drawn = nullptr);

/// Lays dimensions and notes over a drawing, layers "dimensions" and "notes". Tells of numbers and
/// notes that run off the sheet ("dimensions.off_sheet", "notes.off_sheet"), and of characters of
/// notes that the font has not ("text.no_glyph"). The camera is orthographic.
void lay_dimensions(Drawing& drawing, const Camera& camera, const ViewDimensions& dimensions,
                    const DimensionOptions& style);

}  // namespace burin
