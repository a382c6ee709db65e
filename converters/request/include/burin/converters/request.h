#pragma once
/// What a user asks of a drawing, as text, and what that means to the kernel: one place for the
/// command line and the Python module, so that both take the same and say the same.

#include <burin/arrange/arrange.h>
#include <burin/book/book.h>
#include <burin/converters/read.h>
#include <burin/converters/values.h>
#include <burin/options/request.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// A look as it is asked for.
struct LookRequest {
  Look look = {};
  /// A name or a file; or the text of a style file, which starts from the drawing's own style.
  std::string style = {}, style_text = {};
  /// Whom errors of `style_text` name.
  std::string style_source = {};
  /// No user wrote the text.
  bool is_made = false;
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
  std::vector<LookRequest> looks = {};
  /// Instead of the style's light; empty: that.
  std::vector<tone::Light> lights = {};
  /// Before those that options ask for.
  std::vector<Section> sections = {};
  /// Before the option of that name.
  Explode explode = {};
  /// Before those that options ask for.
  std::vector<Break> breaks = {};
  std::vector<DetailView> details = {};
  /// Before those that options ask for.
  std::vector<ThreadRow> threads = {};
  /// Of features of parts, beside those that the option asks for.
  std::vector<DimensionRow> dimensions = {};
  /// Before those that options ask for.
  std::vector<DimensionRow> notes = {};
  std::vector<ArrowRow> arrows = {};
  /// What the drawing is called; empty: by its parts.
  std::string title = {};
  /// Numbers that items have already.
  ItemNumbers items = {};

  bool has(const std::string& name) const { return !given_texts(options, name).empty(); }
};

/// A key of the style as messages call what asked for it: "style key fill.tint", "option --light".
struct AskedKey {
  std::string called, key;
};

/// What the text of a style sets otherwise than the style from which it starts.
struct WrittenKeys {
  /// A file; empty: a program made the text.
  std::string source;
  std::vector<std::string> keys;
  /// That of some parts; nothing: of the drawing.
  std::optional<Style> of_parts = {};
};

/// Everything but the inputs and outputs themselves.
struct DrawPlan : Illustration {
  ReadOptions read;
  /// The files that a parts list is written to.
  std::vector<std::string> parts_list_files = {};
  /// Worker threads; 0 = all.
  int threads = 0;
  /// What the ids of an SVG begin with.
  std::string id_prefix;
  /// How the drawing's diagnostics name options.
  Spelling spelling = Spelling::Options;
  /// The keys of the style that were set one by one, in the order in which they were.
  std::vector<std::string> style_keys = {};
  /// What was asked for by keys of the style, or stands for them, beside the style that was named.
  std::vector<AskedKey> asked_keys = {};
  std::vector<WrittenKeys> written_keys = {};
  /// Options that were given and have no effect on any drawing.
  Diagnostics notes = {};
};

/// Throws UsageError that names the option; InputError for a style file that cannot be read.
DrawPlan make_plan(const DrawRequest& request, Spelling spelling);
/// Writes the files that the plan asks a parts list for. Throws OutputError.
void write_parts_lists(const Drawing& drawing, const DrawPlan& plan);
/// Draws what `arrange_parts` and `plan_sheet` (burin/arrange/arrange.h) made of the plan, with a
/// diagnostic "option.unused" for each choice of the plan that changes nothing of this drawing.
/// Throws as `illustrate`. `session`: keeps what the next drawing may use again.
Drawing draw(const Scene& scene, const SheetOfViews& sheet, const DrawPlan& plan,
             RunContext& context, Session* session = nullptr);
/// Draws how a scene is put together, by the steps of its plan's exploded view read backwards, or
/// by those that are found. Throws as `select_parts`, `cut_parts`, `make_book`.
Book draw_book(Scene& scene, DrawPlan& plan, const BuildOptions& build, RunContext& context);
/// The style of a name or file, with no changes; of some parts of a drawing in the style `whole`,
/// from which a file without "base" starts.
/// Throws UsageError, InputError.
Style load_style(const std::string& name, const Style* whole = nullptr);

/// All that `make_plan` looks at, in the order of their headings.
const std::vector<RequestOption>& all_options();

/// The key and the value of "KEY=VALUE", as --set takes it. Throws UsageError.
std::pair<std::string, std::string> parted_assignment(const std::string& text);

}  // namespace burin
