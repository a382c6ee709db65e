#pragma once
/// All that a drawing is to show of a scene, and how: a value that a program fills in, or that
/// libburin_io makes of options and illustration files. `arrange.h` follows it. Parts are named by
/// selectors (burin/assembly/select.h).

#include <burin/arrange/arrow.h>
#include <burin/arrange/break.h>
#include <burin/arrange/dimension_row.h>
#include <burin/arrange/section.h>
#include <burin/assembly/items.h>
#include <burin/base/vec.h>
#include <burin/camera/camera.h>
#include <burin/camera/sheet.h>
#include <burin/camera/view_grid.h>
#include <burin/explode/step.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>
#include <burin/surface/scene.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin {

namespace detail {
class FeatureSight;
struct MeasuredParts;
}  // namespace detail

/// How the parts that selectors name are drawn, where that differs from the others.
struct Look {
  /// A part that one of them names is meant.
  std::vector<std::string> select = {};
  /// Absent: as before.
  std::optional<bool> drawn = {}, hatched = {}, transparent = {}, listed = {};
  std::optional<Style> style = {};
  /// Of several highlights of a part the style of the one holds that names it most closely
  /// (`levels_above`), of equal ones the last; other looks go over what came before them.
  bool highlight = false;
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
  /// As it was asked for, "`highlight` rod*=red", for the warning that nothing is left of it.
  /// Empty: there is none.
  std::string asked = {};
};

/// How the parts of an assembly come apart (burin/explode/explode.h).
struct Explode {
  /// Whether anything comes apart at all.
  bool wanted = false;
  /// What moves, by selectors, in this order; empty: it is found out.
  std::vector<ExplodeStep> steps = {};
  /// Where it is found out: the way, its sign where both may be; the part that stays; how far parts
  /// may lie in each other, model mm.
  std::optional<Vec3> along = {};
  bool one_way = false;
  std::string base = {};
  std::optional<double> fit = {};
  /// 0 is together, 1 apart.
  double factor = 1;
  std::string place = {};
};

/// A place of a view that is drawn again at another scale, in a circle.
struct DetailView {
  /// The parts that it shows; empty: it shows what is round `at`, model mm.
  std::vector<std::string> select = {};
  Vec3 at{0};
  double radius = 0;
  /// Paper mm a model mm; absent: the largest of ISO 5455 that the sheet has room for.
  std::optional<double> scale = {};
  /// Empty: the next of A, B, C ...
  std::string letter = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// Threads of the parts that selectors name: of the cylinders that fit their size, or of one.
struct ThreadRow {
  std::vector<std::string> select = {};
  /// As people write it: "M6", "M6x0.75", or any text beside `diameter`; empty: by the cylinder.
  std::string size = {};
  /// Model mm: the nominal diameter, the pitch, and the minor diameter, where `size` does not say
  /// them or they differ from ISO 261 and ISO 724.
  std::optional<double> diameter = {}, pitch = {}, minor = {};
  /// Which cylinder: the one next to a point of the model, in mm, or of this number in its part;
  /// absent: all that fit.
  std::optional<Vec3> at = {};
  std::optional<std::int32_t> face = {};
  /// Model mm: where the thread begins, from the open end (next to `at`), and how long it is;
  /// absent: as far as the cylinder goes.
  double start = 0;
  std::optional<double> length = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// A view that a section has for itself, as it stands where the section is found.
struct SectionView {
  std::string letter;
  /// To the viewer, across what is cut, unit.
  Vec3 direction{0};
  /// Where it cuts, model mm along an axis that `direction` is or is against: once, or in steps.
  Vec3 axis{0};
  std::vector<double> faces = {};
  /// Where each step ends, model mm along another axis, unit; of one plane none.
  Vec3 across{0};
  std::vector<double> ends = {};
  /// The parts cut open, in the order of the others.
  std::shared_ptr<Scene> scene = {};
  std::string place = {};
};

struct Illustration {
  Style style{};
  ViewOptions view{};
  SheetOptions sheet{};
  /// Its `part_styles`, `trails` and `annotations` are what arranging makes.
  IllustrateOptions illustrate{};
  /// In this order; what a later one says holds.
  std::vector<Look> looks = {};
  /// Those that alone are drawn; empty: all.
  std::vector<std::string> only = {};
  /// At most 16.
  std::vector<Section> sections = {};
  /// Those of `sections` that have a view of their own: what arranging makes.
  std::vector<SectionView> section_views = {};
  /// Parts that all sections leave whole; absent: as each says, or by custom.
  std::optional<std::vector<std::string>> uncut = {};
  Explode explode = {};
  /// The view of this name that a file saves (`Pmi::views`) is taken, with the annotations that it
  /// shows; empty: `view`.
  std::string saved_view = {};
  /// The view may be turned to where most parts of an exploded one are seen.
  bool finds_view = false;
  /// Names of several views of one sheet ("front", or a direction "1,-1,1"); empty: `view`.
  std::vector<std::string> views = {};
  /// Of several views those with hidden lines, by name or the letter of their section; empty: all.
  std::vector<std::string> hidden_views = {};
  /// Along one axis; `left_out`: what arranging makes of them.
  std::vector<Break> breaks = {};
  ModelBreaks left_out = {};
  /// What overall dimensions look at in broken views: what arranging makes.
  std::shared_ptr<const detail::MeasuredParts> left_parts = {};
  ProjectionMethod projection = ProjectionMethod::FirstAngle;
  /// At most 23.
  std::vector<DetailView> details = {};
  std::vector<ThreadRow> thread_rows = {};
  /// Width, depth and height of the parts that are drawn, along the axes of the model.
  bool overall_dimensions = false;
  /// What these are: arranging finds it, before anything is cut or moved.
  std::optional<Box3> whole = {};
  /// Dimensions of features of parts, and notes; `measured`: what arranging makes of them.
  std::vector<DimensionRow> dimensions = {}, note_rows = {};
  std::vector<MeasuredRow> measured = {};
  /// What hides what is measured, in the scenes of `MeasuredRow::there`: what arranging makes.
  std::vector<std::shared_ptr<const detail::FeatureSight>> sights = {};
  /// How parts move; `step_arrows`: also an arrow for each step of an exploded view, the way back.
  std::vector<ArrowRow> arrows = {};
  bool step_arrows = false;
  /// What is laid over the drawing; items are found where one of these is, or `items`, which
  /// formats do that list them.
  bool callouts = false, parts_list = false, legend = false, items = false;
  /// Its "title", where it has none, is `title`.
  std::optional<TitleBlock> title_block = {};
  /// Numbers that items have already.
  ItemNumbers numbers = {};
  /// What the drawing is called; empty: by its parts.
  std::string title = {};
};

}  // namespace burin
