#pragma once
/// The result: plain 2-D data in millimetres of paper.

#include <burin/base/box.h>
#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/ids.h>
#include <burin/base/vec.h>
#include <burin/drawing/paper_breaks.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// From a point of a path on, the face of the input that it lies on.
struct PathFace {
  std::uint32_t first_point = 0;
  std::int32_t face = -1;
};

/// A line that another one stands for.
struct PathSource {
  SourceId source;
  LineClass kind = LineClass::Contour;
  bool operator==(const PathSource&) const = default;
};

/// One line of ink. `points` (paper mm, origin bottom left, y up) and `points3` (model mm) have the
/// same size; `width` (paper mm) has one entry for a constant width or one per point.
struct Path {
  LineClass kind = LineClass::Contour;
  bool visible = true;
  /// Hidden, yet drawn like the visible ones, not dashed.
  bool in_full = false;
  /// The face is the one that holds most of the line where that runs over several.
  SourceId source;
  /// Only where the line runs over several faces; the first entry begins at point 0.
  std::vector<PathFace> faces;
  /// Lines that lie on this one for a part of its length and are not drawn there (`keep_one_line`).
  std::vector<PathSource> also;
  bool closed = false;
  std::vector<Vec2> points;
  std::vector<Vec3> points3;
  std::vector<double> width;
  /// Strokes: the direction field and the family (1 or 2) in it.
  std::string field;
  int family = 0;
  /// Strokes: which kind of strokes of the style, from 1.
  int stroke_kind = 1;
  /// Leaders and frames: the number of the item that they are about, 0 where they are about none.
  int item = 0;
  /// "#rrggbb"; empty: that of its layer.
  std::string color = {};
};

/// What a piece of a path, or a path made of several, begins as: an open path without points or
/// widths that says of itself what `path` says.
Path without_points(const Path& path);

/// Which point of a text stands at its place.
enum class TextAnchor { Start, Middle, End };

/// "start", "middle", "end".
const char* to_string(TextAnchor anchor);

/// One line of text in the engineering font of burin/drawing/font.h.
struct Text {
  /// Paper mm: on the base line.
  Vec2 at{0};
  /// Paper mm, of capital letters.
  double height = 3.5;
  TextAnchor anchor = TextAnchor::Start;
  /// UTF-8.
  std::string text;
  /// What it is: "callout", "parts_list", "legend", "title_block", "detail", "section",
  /// "dimension", "step".
  std::string role = {};
  /// The number of the item that it is about; 0: none.
  int item = 0;
  /// Degrees about its place, anticlockwise: 0 from left to right, 90 upwards.
  double turn = 0;
};

/// Paths that are drawn together, and texts over them; layers are painted in order.
struct Layer {
  std::string name;
  std::vector<Path> paths;
  std::vector<Text> texts = {};
  /// "#rrggbb" of its lines and texts; empty: `Drawing::ink_color`.
  std::string color = {};
  /// Paper mm of ink and gaps in turn; empty: as its name has it (`InkLayer::dashes`).
  std::vector<double> dashes = {};
};

/// A row of the parts list.
struct DrawingItem {
  int number = 0;
  std::string name;
  /// Ids of parts that are drawn, ascending.
  std::vector<std::int32_t> parts;
  /// "#rrggbb" where all have one colour, and the file that all come from; else empty.
  std::string color = {};
  std::string source = {};
  /// What names each of the parts in commands and illustration files, in their order; the same for
  /// parts that are one thing (`Part::joined`).
  std::vector<std::string> selectors = {};

  /// The selectors, those of one thing once.
  std::vector<std::string> things() const;
  /// How many there are of it.
  std::size_t quantity() const { return selectors.empty() ? parts.size() : things().size(); }
};

/// An ink that printers have beside the four: its name and its colour, "#rrggbb".
struct SpotInk {
  std::string name;
  std::string color;
  bool operator==(const SpotInk&) const = default;
};

/// Where a part is seen, for pointing at it, and its colour there.
struct Area {
  std::int32_t part = -1;
  /// Face of the part; -1: all that are seen.
  std::int32_t face = -1;
  /// Step of tone, from 0, the darkest; -1: any.
  std::int32_t tone = -1;
  /// "#rrggbb" under the lines; empty: nothing is painted.
  std::string fill = {};
  /// Of the fill, from 0 to 1.
  double opacity = 1;
  /// The ink of `Drawing::inks` that the fill is a tint of, and its share; empty: none.
  std::string ink = {};
  double tint = 1;
  /// "legend": a square of it; "pmi": letters and arrows of an annotation, or what a symbol fills
  /// with the colour of lines; "symbol": what one fills with another; empty: what is seen of the
  /// part.
  std::string role = {};
  /// Closed, paper mm; what is inside an odd number of them.
  std::vector<std::vector<Vec2>> rings;
};

/// The view, as numbers that a program can project with: to_paper(p) = scale * (dot(p - center,
/// right), dot(p - center, up)) + offset in orthographic views.
struct DrawingView {
  std::string projection = "orthographic";
  Vec3 direction{0}, right{0}, up{0};
  double scale = 1;
  Vec3 center{0};
  Vec2 offset{0};
  /// Perspective only: the viewer's place and the vertical field of view in degrees.
  Vec3 eye{0};
  double field_of_view = 0;
  /// What is left out of the view: its place is then `breaks.moved(to_paper(p))`.
  PaperBreaks breaks = {};
};

/// One of several views on a sheet.
struct SheetView {
  /// "front"; of a detail its letter.
  std::string name;
  DrawingView view;
  /// Paper mm: all of its lines lie in it, and none of other views.
  Box2 box;
};

struct DrawingPart {
  std::int32_t id = 0;
  std::string name;
  std::string source;
  std::int64_t triangles = 0;
  /// Faces of a CAD part or patches; smooth regions of a mesh.
  std::int64_t faces = 0;
  /// Names from the top of an assembly down to what contains the part; empty outside assemblies.
  std::vector<std::string> assembly = {};
  /// "#rrggbb" where the input gives the part one colour, else empty.
  std::string color = {};
};

/// A stretch of a line or a patch of an area where rays contradict the drawing, or an end of the
/// outer outline that nothing goes on from.
struct Contradiction {
  /// "covered": drawn, though something stands before it. "open": left out or dashed as hidden,
  /// though nothing does. "adrift": drawn where there is no surface. "missing": a stretch of the
  /// outer outline that is not drawn. "loose_end": see there. "wrong_part", "wrong_face",
  /// "wrong_tone": a patch where areas state another one than is seen.
  std::string what;
  LineClass kind = LineClass::Contour;
  /// Of the line; of a patch what areas state, no part: the bare sheet.
  SourceId source;
  /// Of a line, paper mm.
  double length = 0;
  /// Of a patch, paper mm^2.
  double size = 0;
  /// Its middle on paper and in the model.
  Vec2 at{0};
  Vec3 model{0};
};

/// What a test of the whole drawing against rays found (kernel/verify/README.md).
struct Verification {
  /// Lines tested, visible and hidden, and their length in paper mm.
  std::int64_t spans = 0;
  double length = 0;
  /// Paper mm of these that rays contradict, in stretches of 0.5 mm and more, and how many.
  double contradicted = 0;
  std::int64_t count = 0;
  std::int64_t loose_ends = 0;
  /// Where the drawing has areas: paper mm^2 tested, how much of it rays contradict, in patches of
  /// 0.25 mm^2 and more, and how many.
  double area = 0;
  double wrong_area = 0;
  std::int64_t wrong_patches = 0;
  /// The longest of lines, loose ends, then the largest of areas, of each a hundred at most.
  std::vector<Contradiction> contradictions;

  double share() const { return length > 0 ? contradicted / length : 0; }
};

struct DrawingStats {
  std::int64_t triangles = 0;
  std::int64_t strokes = 0;
  std::int64_t coverage_points = 0;
  /// Covering radius of the coverage in paper mm, measured. @cite Elber1998 (Definition 1)
  double coverage_delta = 0;
  /// The exponent of all ink that brought its median where the style wants it; present where it
  /// wants that. Of several styles that of the most coverage points.
  std::optional<double> tone_gamma = {};
  /// Present where the drawing was tested.
  std::optional<Verification> verify = {};
};

struct Drawing {
  double paper_width = 297;
  double paper_height = 210;
  /// "#rrggbb": of all lines, and of the sheet; white paper is not painted.
  std::string ink_color = "#000000", paper_color = "#ffffff";
  std::uint64_t seed = 1;
  /// What it is called; empty: by its parts.
  std::string title = {};
  std::string style;
  DrawingView view;
  /// Only where the sheet has several; the first is `view`.
  std::vector<SheetView> views = {};
  std::vector<DrawingPart> parts;
  /// By number; only where they were asked for, as are the areas.
  std::vector<DrawingItem> items = {};
  std::vector<Area> areas = {};
  /// That areas are printed in.
  std::vector<SpotInk> inks = {};
  std::vector<Layer> layers;
  Diagnostics diagnostics;
  DrawingStats stats;
};

}  // namespace burin
