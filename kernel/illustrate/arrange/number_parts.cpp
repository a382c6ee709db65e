#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/illustrate/legend.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Numbers that the illustration keeps for names which no part has.
void report_holes(const ItemNumbers& kept, const std::vector<Item>& items,
                  Diagnostics& diagnostics) {
  std::set<int> used;
  for (const Item& item : items) used.insert(item.number);
  std::int64_t count = 0;
  std::string first;
  for (const auto& [number, item] : kept) {
    if (used.contains(number)) continue;
    if (count++ == 0)
      first = fmt::format("{} '{}'", number, item.name.empty() ? item.select : item.name);
  }
  if (count == 0) return;
  diagnostics.add(
      Severity::Info, "items.gone", count,
      fmt::format("numbers are kept for items that are not there; the first: {}", first));
}

std::vector<bool> unlisted_of(const std::vector<PartStyle>& styles) {
  std::vector<bool> unlisted;
  for (const PartStyle& style : styles) unlisted.push_back(!style.listed);
  return unlisted;
}

/// Of what has a body of this path: all of its bodies.
std::string selector_of_whole(const std::string& of_body) {
  return of_body.starts_with('@') ? of_body : of_body.substr(0, of_body.rfind('/'));
}

/// Whether rows of several names have one colour.
bool are_alike(const std::vector<LegendRow>& rows) {
  return rows.size() > 1 && std::ranges::all_of(rows, [&](const LegendRow& row) {
           return row.square.fill == rows.front().square.fill;
         });
}

/// Whether the legend is to have some parts alone: these it tells from the others.
bool leaves_parts_out(const Illustration& illustration) {
  return std::ranges::any_of(illustration.illustrate.part_styles, [](const PartStyle& look) {
    return look.drawn && look.style && !look.style->fill.legend;
  });
}

/// How a part is filled; nothing where it is not drawn.
const FillOptions* fill_of(const Illustration& illustration, std::size_t part) {
  const auto& styles = illustration.illustrate.part_styles;
  if (part >= styles.size()) return &illustration.style.fill;
  if (!styles[part].drawn) return nullptr;
  return &(styles[part].style ? *styles[part].style : illustration.style).fill;
}

/// Names the key that leaves colours out, where one does.
void report_empty_legend(const Illustration& illustration, Scene& scene) {
  bool left_out = false, clear = false;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const FillOptions* fill = fill_of(illustration, i);
    if (!fill) continue;
    const bool colored = fill->color != "none";
    const bool hatched = fill->hatch.lines != FillHatch::Lines::None;
    left_out = left_out || ((colored || hatched) && !fill->legend);
    clear = clear || (colored && !hatched && fill->opacity <= 0);
  }
  const char* why =
      "there is no colour for a legend: choose fill.color, or a style that has "
      "colours, such as flat";
  if (left_out) {
    why =
        "fill.legend=false leaves all colours out of the legend, so that none is drawn: set it "
        "to true, or leave out `legend`";
  } else if (clear) {
    why =
        "fill.opacity=0 leaves no colour for a legend: set it to more than 0, or leave out "
        "`legend`";
  }
  scene.diagnostics.add(Severity::Warning, "legend.empty", 1, why);
}

/// Advises what helps: in the colours of the input the parts may be alike, too.
void report_alike(const Annotations& annotations, Scene& scene) {
  const bool alike_in_input =
      are_alike(legend_rows(scene, builtin_style("flat"), {}, annotations.items));
  scene.diagnostics.add(
      Severity::Warning, "legend.alike", static_cast<std::int64_t>(annotations.legend.size()),
      alike_in_input
          ? "all parts have one colour in the input, so that the legend does not tell them apart: "
            "give some another by `highlight`"
          : "all parts have one colour, so that the legend does not tell them apart: choose a "
            "style in which parts have their own, such as flat");
}

/// Whether parts that get a colour of the palette, by their name, are called the same though they
/// are of several forms.
bool palette_asks_for_shapes(const Scene& scene, const Illustration& illustration) {
  std::map<std::string, const Form*> forms;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const Part& part = scene.parts[i];
    const FillOptions* fill = fill_of(illustration, i);
    if (!fill || fill->color != "part" || !part.color.empty()) continue;
    if (forms.try_emplace(stem_of(part), part.form.get()).first->second != part.form.get())
      return true;
  }
  return false;
}

/// Numbers the shapes of each name, in the order of items.
void tell_shapes_apart(Scene& scene, const std::vector<Item>& items) {
  std::map<std::string, std::size_t> known;
  for (const Item& item : items) {
    std::map<std::string, std::size_t> own;  // of the item
    for (const std::size_t i : item.parts) {
      Part& part = scene.parts[i];
      const auto [at, fresh] = own.try_emplace(stem_of(part), 0);
      if (fresh) at->second = known[at->first]++;
      part.shape_of_name = at->second;
    }
  }
}

}  // namespace

void number_parts(Scene& scene, Illustration& illustration, RunContext& context) {
  const bool named = std::ranges::any_of(illustration.note_rows, [](const DimensionRow& note) {
    return note.text.find("{item}") != std::string::npos;
  });
  const bool listed = illustration.callouts || illustration.parts_list || illustration.legend ||
                      illustration.items || named;
  const bool by_shape = palette_asks_for_shapes(scene, illustration);
  if (!listed && !by_shape) return;
  context.begin_stage(RunStage::Build);
  Diagnostics unasked;
  const std::vector<Item> items = find_items(scene, listed ? illustration.numbers : ItemNumbers{},
                                             listed ? scene.diagnostics : unasked, context,
                                             unlisted_of(illustration.illustrate.part_styles));
  context.end_stage();
  if (by_shape) tell_shapes_apart(scene, items);
  if (!listed) return;
  report_holes(illustration.numbers, items, scene.diagnostics);
  Annotations annotations;
  annotations.callouts = illustration.callouts;
  annotations.parts_list = illustration.parts_list;
  annotations.margin = illustration.sheet.margin;
  const auto& styles = illustration.illustrate.part_styles;
  const std::vector<std::string> selectors = selectors_of(scene);
  for (const Item& item : items) {
    DrawingItem drawn{item.number, item.name, {}, item.color, item.source};
    std::map<const Part*, std::size_t> wholes;  // where they stand in the row
    for (const std::size_t part : item.parts) {
      if (part < styles.size() && !styles[part].drawn) continue;
      const Part* whole = scene.parts[part].whole.get();
      if (const auto known = wholes.find(whole); whole && known != wholes.end()) {
        drawn.selectors[known->second] = selector_of_whole(selectors[part]);
        continue;
      }
      if (whole) wholes.emplace(whole, drawn.parts.size());
      drawn.parts.push_back(static_cast<std::int32_t>(part));
      drawn.selectors.push_back(selectors[part]);
    }
    if (!drawn.parts.empty()) annotations.items.push_back(std::move(drawn));
  }
  if (illustration.legend) {
    annotations.legend =
        legend_rows(scene, illustration.style, illustration.illustrate, annotations.items);
    if (annotations.legend.empty()) {
      report_empty_legend(illustration, scene);
    } else if (are_alike(annotations.legend) && !leaves_parts_out(illustration)) {
      report_alike(annotations, scene);
    }
  }
  illustration.illustrate.annotations = std::move(annotations);
}

}  // namespace burin
