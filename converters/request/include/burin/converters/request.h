#pragma once
/// What a user asks of a drawing, as text, and what that means to the kernel: one place for the
/// command line and the Python module, so that both take the same and say the same.

#include <burin/assembly/items.h>
#include <burin/book/book.h>
#include <burin/camera/sheet.h>
#include <burin/converters/read.h>
#include <burin/converters/values.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/session.h>
#include <burin/illustrate/sheet.h>
#include <burin/illustrate/style.h>
#include <burin/options/request.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// How the parts that selectors name are drawn, where that differs from the others.
struct Look {
  /// Selectors (burin/assembly/select.h); a part that one of them names is meant.
  std::vector<std::string> select = {};
  /// Absent: as before.
  std::optional<bool> drawn = {}, hatched = {}, transparent = {}, listed = {};
  /// A name or a file; or the text of a style file, which starts from the drawing's own style.
  std::string style = {}, style_text = {};
  /// Whom errors of `style_text` name.
  std::string style_source = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// What is taken away so that parts are cut open.
struct Section {
  /// From the viewer down to the depth of a place, as wide as a circle in the view.
  struct Around {
    Vec3 center{0};
    double radius = 0;  // model mm
  };
  /// What lies beyond all of them goes. Which side 0 takes away is that of the viewer; absent, the
  /// offset is the middle of what is drawn.
  std::vector<CutText> planes = {};
  /// Instead, the planes are steps: a cut, where it ends, the next cut, ...
  bool steps = false;
  /// Instead of planes.
  std::optional<Around> around = {};
  /// Selectors of parts that stay whole; absent: those that drawings leave whole by custom.
  std::optional<std::vector<std::string>> exclude = {};
  /// The entry of an illustration file; empty: the section was asked for at a door.
  std::string json = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// How the parts of an assembly come apart (burin/explode/explode.h).
struct Explode {
  /// Parts that move together; the way is a unit vector.
  struct Step {
    std::vector<std::string> move = {};
    Vec3 along{0, 0, 1};
    double by = 0;
    bool trail = true;
    /// What errors begin with: "FILE:LINE: ", or empty.
    std::string place = {};
  };
  /// Whether anything comes apart at all.
  bool wanted = false;
  /// What moves, in this order; empty: it is found out.
  std::vector<Step> steps = {};
  /// Where it is found out: the way, its sign where both may be; the part that stays; how far parts
  /// may lie in each other, model mm.
  std::optional<Vec3> along = {};
  bool one_way = false;
  std::string base = {};
  std::optional<double> fit = {};
  /// 0 is together, 1 apart.
  double factor = 1;
  /// The value of an illustration file; empty: it was asked for at a door.
  std::string json = {};
  std::string place = {};
};

/// A place of a view that is drawn again at another scale, in a circle.
struct DetailView {
  /// Selectors of the parts that it shows; empty: it shows what is round `at`, model mm.
  std::vector<std::string> select = {};
  Vec3 at{0};
  double radius = 0;
  /// Paper mm a model mm; absent: the largest of ISO 5455 that the sheet has room for.
  std::optional<double> scale = {};
  /// Empty: the next of A, B, C ...
  std::string letter = {};
  /// The entry of an illustration file; empty: the detail was asked for at a door.
  std::string json = {};
  /// What errors begin with: "FILE:LINE: ", or empty.
  std::string place = {};
};

/// What a user asks of a drawing.
struct DrawRequest {
  /// By the names of `all_options`; others are not looked at.
  Request options;
  /// The text of a style file; goes before the option "style".
  std::string style_text;
  /// Whom errors of that text name, with the line; empty: a program made it.
  std::string style_source = {};
  /// In this order; what a later one says holds.
  std::vector<Look> looks = {};
  /// Instead of the style's light; empty: that.
  std::vector<tone::Light> lights = {};
  /// Before those that options ask for.
  std::vector<Section> sections = {};
  /// Before the option of that name.
  Explode explode = {};
  /// Before those that options ask for.
  std::vector<DetailView> details = {};
  /// What the drawing is called; empty: by its parts.
  std::string title = {};
  /// Numbers that items have already.
  ItemNumbers items = {};

  bool has(const std::string& name) const { return !given_texts(options, name).empty(); }
};

/// Everything but the inputs and outputs themselves.
struct DrawPlan {
  Style style;
  ViewOptions view;
  SheetOptions sheet;
  IllustrateOptions illustrate;
  ReadOptions read;
  /// What `select_parts` makes of the options about parts: a look, or those that alone are drawn.
  struct PlannedLook {
    Look look;
    std::optional<Style> style = {};
  };
  std::vector<PlannedLook> looks = {};
  std::vector<std::string> only = {};
  std::vector<Section> sections = {};
  /// Of all sections; absent: as each says, or by custom.
  std::optional<std::vector<std::string>> uncut = {};
  Explode explode = {};
  /// No view was named: an exploded one is that in which most parts are seen.
  bool finds_view = false;
  /// Names of several views of one sheet; empty: `view`.
  std::vector<std::string> views = {};
  ProjectionMethod projection = ProjectionMethod::FirstAngle;
  std::vector<DetailView> details = {};
  /// What is laid over the drawing, and the files that a parts list is written to; items are found
  /// where one of these is asked for, or `items`, which formats do that list them.
  bool callouts = false, parts_list = false, items = false;
  std::vector<std::string> parts_list_files = {};
  ItemNumbers numbers = {};
  std::string title;
  /// Worker threads; 0 = all.
  int threads = 0;
  /// What the ids of an SVG begin with.
  std::string id_prefix;
  /// How the drawing's diagnostics name options.
  Spelling spelling = Spelling::Options;
  /// Options that were given and have no effect on a drawing without strokes, as messages call
  /// them.
  std::vector<std::string> about_strokes = {};
  /// Options that were given and have no effect on any drawing.
  Diagnostics notes = {};
};

/// Throws UsageError that names the option; InputError for a style file that cannot be read.
DrawPlan make_plan(const DrawRequest& request, Spelling spelling);
/// Turns what a plan says of parts by name into `illustrate.part_styles`, over what is there. Parts
/// of which a selector names a body are split first (burin/assembly/pieces.h).
/// Throws UsageError where a selector names nothing, or nothing is left to draw.
void select_parts(Scene& scene, DrawPlan& plan);
/// Finds and numbers the items of the scene where the plan has a use for them, and fills
/// `illustrate.annotations` with those that are drawn, once `select_parts` knows which these are.
/// Tells in the scene's diagnostics of numbers that are kept for parts that are not there. Throws
/// Cancelled.
void number_parts(Scene& scene, DrawPlan& plan, RunContext& context);
/// Writes the files that the plan asks a parts list for. Throws OutputError.
void write_parts_lists(const Drawing& drawing, const DrawPlan& plan);
/// Cuts the parts by the sections of a plan, once `select_parts` knows which are drawn; tells of
/// sections that cut nothing and of parts that stay whole by custom. Throws UsageError where a
/// selector names nothing, or nothing is left.
void cut_parts(Scene& scene, const DrawPlan& plan);
/// The steps by which a plan takes a scene apart, once `select_parts` knows which parts are drawn:
/// its own, or those that are found, as selectors that name the parts. Diagnostics go to `scene`.
/// Throws UsageError where a selector names nothing.
std::vector<Explode::Step> explode_steps(Scene& scene, const DrawPlan& plan, RunContext& context);
/// All that a plan does to parts: `select_parts`, steps found, `cut_parts`, parts moved by the
/// steps, with trails. Throws as they do.
void arrange_parts(Scene& scene, DrawPlan& plan, RunContext& context);
/// The views that a plan asks for of the parts that are drawn, and where they stand on the sheet.
/// Diagnostics go to `scene`. Throws UsageError, GeometryError.
SheetOfViews plan_sheet(Scene& scene, const DrawPlan& plan);
/// Draws it, with a diagnostic "option.unused" for each choice of the plan that changes nothing of
/// this drawing. Throws as `illustrate`. `session`: keeps what the next drawing may use again.
Drawing draw(const Scene& scene, const SheetOfViews& sheet, const DrawPlan& plan,
             RunContext& context, Session* session = nullptr);
/// Draws how a scene is put together, by the steps of its plan's exploded view read backwards, or
/// by those that are found. Throws as `select_parts`, `cut_parts`, `make_book`.
Book draw_book(Scene& scene, DrawPlan& plan, const BuildOptions& build, RunContext& context);
/// The style of a name or file, with no changes; of some parts of a drawing in the style `whole`.
/// Throws UsageError, InputError.
Style load_style(const std::string& name, const Style* whole = nullptr);

/// All that `make_plan` looks at, in the order of their headings.
const std::vector<RequestOption>& all_options();

/// The key and the value of "KEY=VALUE", as --set takes it. Throws UsageError.
std::pair<std::string, std::string> parted_assignment(const std::string& text);

}  // namespace burin
