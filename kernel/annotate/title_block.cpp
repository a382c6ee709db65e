#include "title_block.h"

#include <burin/annotate/details.h>
#include <burin/base/short_list.h>
#include <burin/drawing/font.h>
#include <burin/drawing/title.h>

#include "blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace detail {
namespace {

constexpr double kOfSheet = 1;       // paper mm: a layout of that size is one of the sheet
constexpr double kMostHeight = 0.5;  // share of the frame that a block takes
constexpr double kLinesApart = 1.4;  // of the height of letters
constexpr double kSmaller = 0.71;    // the step of ISO 3098
constexpr double kLeastLetters = 1.8;

bool is_of_sheet(const TitleBlockLayout& layout, const Paper& paper) {
  return std::abs(layout.size.x - paper.width) <= kOfSheet &&
         std::abs(layout.size.y - paper.height) <= kOfSheet;
}

/// The only source of all parts, without its folder.
std::string model_of(const Drawing& drawing) {
  std::string model;
  for (const DrawingPart& part : drawing.parts) {
    if (!model.empty() && part.source != model) return {};
    model = part.source;
  }
  return std::filesystem::path(model).filename().string();
}

std::string name_of(const Drawing& drawing) {
  if (drawing.parts.size() == 1 || !drawing.title.empty()) return title_of(drawing);
  const std::string model = std::filesystem::path(model_of(drawing)).stem().string();
  return model.empty() ? title_of(drawing) : model;
}

/// What fields say that nobody gave a value.
std::string usual_value(const std::string& field, const Drawing& drawing) {
  if (field == "title") return name_of(drawing);
  if (field == "model") return model_of(drawing);
  const bool has_scale = field == "scale" && drawing.view.projection == "orthographic";
  return has_scale ? scale_text(drawing.view.scale) : std::string();
}

/// Words in lines no wider than that; the last line has all that is left.
std::vector<std::string> wrapped(const std::string& text, double height, double width, int lines) {
  std::vector<std::string> out(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const std::string longer = out.back().empty() ? word : out.back() + " " + word;
    const bool full = text_width(longer, height) > width && !out.back().empty();
    if (full && static_cast<int>(out.size()) < lines) {
      out.push_back(word);
    } else {
      out.back() = longer;
    }
    at = end + 1;
  }
  return out;
}

/// A text as it fits its place.
struct Fitted {
  std::vector<std::string> lines;
  double height = 0;
  bool cut = false;
};

Fitted fitted_value(const std::string& value, const TitleBlockText& slot) {
  Fitted out{{value}, slot.text.height};
  if (slot.width <= 0) return out;
  const double width = slot.width + kRounding;
  const auto fits = [&] {
    out.lines = wrapped(value, out.height, width, slot.lines);
    return std::ranges::all_of(
        out.lines, [&](const std::string& line) { return text_width(line, out.height) <= width; });
  };
  const double least = std::min(out.height, kLeastLetters);
  while (!fits() && out.height > least) out.height = std::max(kSmaller * out.height, least);
  for (std::string& line : out.lines) {
    std::string shorter = fitted_text(line, out.height, width);
    out.cut = out.cut || shorter != line;
    line = std::move(shorter);
  }
  return out;
}

/// What the layout itself says stays whole, however small.
Fitted fitted_label(const TitleBlockText& slot) {
  const double height = slot.text.height, needed = text_width(slot.text.text, height);
  const bool wide = slot.width > 0 && needed > slot.width;
  return {{slot.text.text}, wide ? height * slot.width / needed : height};
}

void lay_text(const Fitted& value, const TitleBlockText& slot, Vec2 at, Layer& layer) {
  const double pitch = kLinesApart * value.height;
  // Smaller letters keep the middle of their line.
  double y = slot.text.at.y + 0.5 * (slot.text.height - value.height) +
             0.5 * static_cast<double>(value.lines.size() - 1) * pitch;
  for (const std::string& line : value.lines) {
    if (line.empty()) continue;
    Text text = slot.text;
    text.at = at + Vec2(slot.text.at.x, y);
    text.height = value.height;
    text.text = line;
    layer.texts.push_back(std::move(text));
    y -= pitch;
  }
}

/// The value that was given for a field, or the usual one; nothing where there is none.
std::optional<std::string> value_of(const TitleBlockText& slot, const TitleBlock& block,
                                    const Drawing& drawing) {
  if (slot.field.empty()) return std::nullopt;
  const auto given = block.fields.find(slot.field);
  if (given != block.fields.end()) return given->second;
  std::string usual = usual_value(slot.field, drawing);
  return usual.empty() ? std::nullopt : std::optional(std::move(usual));
}

void report(const TitleBlockPlan& plan, const std::vector<std::string>& cut,
            Diagnostics& diagnostics) {
  if (plan.narrow) {
    diagnostics.add(Severity::Warning, "title_block.narrow", 1,
                    fmt::format("the title block is {:.0f} mm wide, as the margin leaves no more; "
                                "ISO 7200 has {:g}",
                                plan.layout->size.x, kTitleBlockWidth));
  }
  if (plan.layout->left_out > 0) {
    diagnostics.add(Severity::Warning, "title_block.turned", plan.layout->left_out,
                    fmt::format("{} texts of the template that are not level are left out",
                                plan.layout->left_out));
  }
  if (cut.empty()) return;
  constexpr std::size_t kMostNamed = 3;
  diagnostics.add(Severity::Warning, "title_block.cut", std::ssize(cut),
                  fmt::format("texts of the title block are longer than their cells and cut: {}",
                              short_list(cut, kMostNamed, [](const std::string& text) {
                                return fmt::format("'{}'", text);
                              })));
}

}  // namespace

std::optional<TitleBlockPlan> plan_title_block(const Annotations& annotations,
                                               const CalloutOptions& style, const Paper& paper) {
  if (!annotations.title_block) return std::nullopt;
  const Box2 frame = inside(paper, annotations.margin);
  const Vec2 room = frame.size();
  TitleBlockPlan plan{annotations.title_block->layout};
  if (plan.layout && is_of_sheet(*plan.layout, paper)) {
    const std::optional<Box2>& clear = plan.layout->kept_clear;
    if (clear && clear->max.y <= frame.center().y) plan.box = *clear;
    return plan;
  }
  if (!plan.layout) {
    const double width = std::min(kTitleBlockWidth, room.x);
    plan.narrow = width < kTitleBlockWidth - kRounding;
    if (width < kLeastTitleBlock) return std::nullopt;
    plan.layout = std::make_shared<TitleBlockLayout>(iso_title_block(width, style));
  }
  const Vec2 size = plan.layout->size;
  if (size.x > room.x + kRounding || size.y > kMostHeight * room.y) return std::nullopt;
  plan.at = {frame.max.x - size.x, frame.min.y};
  plan.box = {plan.at, {frame.max.x, frame.min.y + size.y}};
  return plan;
}

void lay_title_block(const TitleBlockPlan& plan, const TitleBlock& block,
                     const CalloutOptions& style, Drawing& drawing) {
  const auto move = [&](Path path) {
    for (Vec2& p : path.points) p += plan.at;
    return path;
  };
  Layer layer{"title_block", {}};
  for (const Path& path : plan.layout->paths) layer.paths.push_back(move(path));
  if (plan.layout->symbol && block.method) {
    Layer symbol = projection_symbol(*block.method, plan.at + *plan.layout->symbol, style);
    std::ranges::move(symbol.paths, std::back_inserter(layer.paths));
  }
  std::vector<std::string> cut;
  for (const TitleBlockText& slot : plan.layout->texts) {
    const std::optional<std::string> value = value_of(slot, block, drawing);
    const Fitted fitted = value ? fitted_value(*value, slot) : fitted_label(slot);
    if (fitted.cut) cut.push_back(*value);
    lay_text(fitted, slot, plan.at, layer);
  }
  report(plan, cut, drawing.diagnostics);
  drawing.layers.push_back(std::move(layer));
}

}  // namespace detail

bool has_symbol(const Annotations& annotations, const CalloutOptions& style, const Paper& paper) {
  const auto plan = detail::plan_title_block(annotations, style, paper);
  return plan && plan->layout->symbol;
}

}  // namespace burin
