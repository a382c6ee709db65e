#include "looks.h"

#include <burin/drawing/color.h>
#include <burin/drawing/font.h>
#include <burin/drawing/ink.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace burin::detail {
namespace {

constexpr const char* kGreen = "#00802b";
constexpr const char* kRed = "#d00000";
constexpr const char* kBlue = "#0046c8";

/// In the order of painting.
const std::vector<ChangeLook>& looks() {
  static const std::vector<ChangeLook> all = {
      {"same", kLight, {}, 1, 0},
      {"moved-from", kBlue, {3, 1, 0.01, 1}, 1, 0.2},
      {"changed-from", kRed, {2, 1}, 1, 0.3},
      {"gone", kRed, {2, 1}, 1, 0.3},
      {"removed", kRed, {2, 1}, 1.2, 0.3},
      {"renamed", "#6a1b9a", {}, 1, 0},
      {"look", "#9a5b00", {}, 1, 0},
      {"moved-to", kBlue, {}, 1, 0},
      {"changed-to", "", {}, 1, 0},
      {"changed-new", kGreen, {}, 1.6, 0.4},
      {"new", kGreen, {}, 1.6, 0.4},
      {"added", kGreen, {}, 1.6, 0.4},
  };
  return all;
}

/// Share of the way from ink to paper at which lines are light.
constexpr double kToPaper = 0.6;

/// Heights of letters: a sample line, between it and its words, between entries.
constexpr double kSample = 5, kToText = 0.8, kBetween = 2.4;
constexpr double kRow = 2;

double width_of(const LegendEntry& entry, double height) {
  return static_cast<double>(entry.groups.size()) * (kSample + kToText) * height +
         text_width(entry.text, height);
}

}  // namespace

const ChangeLook& look_of(const std::string& group) {
  for (const ChangeLook& look : looks()) {
    if (look.group == group) return look;
  }
  throw std::out_of_range("no such change: " + group);
}

Layers::Layers(const Drawing& drawing, std::vector<Layer>& layers)
    : ink_(drawing.ink_color), layers_(layers) {
  const Rgb ink = rgb_of(drawing.ink_color).value_or(Rgb{}),
            paper = rgb_of(drawing.paper_color).value_or(Rgb{255, 255, 255});
  const auto mixed = [&](std::size_t c) {
    return std::lround(ink[c] + kToPaper * (paper[c] - ink[c]));
  };
  light_ = fmt::format("#{:02x}{:02x}{:02x}", mixed(0), mixed(1), mixed(2));
}

std::string Layers::color_of(const ChangeLook& look) const {
  if (std::string_view(look.color) == kLight) return light_;
  return look.color;
}

Layer& Layers::named(const std::string& name, const ChangeLook& look) {
  const auto found = std::ranges::find(layers_, name, &Layer::name);
  if (found != layers_.end()) return *found;
  return layers_.emplace_back(Layer{name, {}, {}, color_of(look), look.dashes});
}

void Layers::add(const std::string& group, const std::string& name, Path path) {
  const ChangeLook& look = look_of(group);
  path.color.clear();  // the change gives the colour
  if (path.kind != LineClass::Stroke && path.kind != LineClass::Pattern) {
    for (double& w : path.width) w = std::max(look.factor * w, look.least);
  }
  // The layer of all hidden lines has no room for several colours.
  const bool dashed = !path.visible && !path.in_full;
  path.in_full = !path.visible;
  const std::string hidden(kHiddenLayer);
  Layer& layer = named(fmt::format("{}-{}", group, dashed ? hidden : name), look);
  if (layer.dashes.empty() && dashed) layer.dashes = InkLayer{hidden, {}}.dashes({});
  if (layer.dashes.empty()) layer.dashes = InkLayer{name, {}}.dashes({});
  layer.paths.push_back(std::move(path));
}

void sort_layers(std::vector<Layer>& layers) {
  const auto rank = [](const Layer& layer) {
    std::size_t best = looks().size();
    for (std::size_t i = 0; i < looks().size(); ++i) {
      if (layer.name.starts_with(fmt::format("{}-", looks()[i].group))) best = i;
    }
    return best;
  };
  std::ranges::stable_sort(layers, {}, rank);
}

double lay_legend(Drawing& drawing, const std::vector<LegendEntry>& entries,
                  const OverlayOptions& options) {
  const double h = options.letters.list_height;
  const double left = options.margin.left, right = drawing.paper_width - options.margin.right;
  std::vector<Layer> laid;
  Layers layers(drawing, laid);
  double x = left, y = options.margin.bottom + (kRow - 1) / 2 * h;
  Layer words{"legend", {}, {}, {}, {}};
  for (const LegendEntry& entry : entries) {
    const double width = width_of(entry, h);
    if (x > left && x + width > right) x = left, y += kRow * h;
    for (const std::string& group : entry.groups) {
      const ChangeLook& look = look_of(group);
      Path line;
      line.kind = LineClass::Frame;
      line.points = {{x, y + h / 2}, {x + kSample * h, y + h / 2}};
      line.width = {std::max(look.factor * 0.25, look.least)};
      layers.named("legend-" + group, look).paths.push_back(std::move(line));
      x += (kSample + kToText) * h;
    }
    words.texts.push_back({{x, y}, h, TextAnchor::Start, entry.text, "legend", 0});
    x += text_width(entry.text, h) + kBetween * h;
  }
  for (Layer& layer : laid) drawing.layers.push_back(std::move(layer));
  if (!words.texts.empty()) drawing.layers.push_back(std::move(words));
  return y + h;
}

}  // namespace burin::detail

namespace burin {

double legend_height(const CalloutOptions& letters, double width) {
  // All entries there can be, and room to the drawing.
  const double h = letters.list_height;
  constexpr double kEntries = 7, kLetters = 24;
  const double rows = std::ceil(kEntries * kLetters * h / std::max(width, kLetters * h));
  return (rows * 2 + 1) * h;
}

}  // namespace burin
