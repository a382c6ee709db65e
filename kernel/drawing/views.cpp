#include <burin/drawing/ink.h>
#include <burin/drawing/views.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {
namespace {

template <class T>
void move_all(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Layers of both in an order that keeps that of each.
void merge_layers(std::vector<Layer>& to, std::vector<Layer>& from) {
  std::size_t after = 0;
  for (Layer& layer : from) {
    const auto found = std::ranges::find(to, layer.name, &Layer::name);
    if (found == to.end()) {
      to.insert(to.begin() + static_cast<std::ptrdiff_t>(after), std::move(layer));
      ++after;
      continue;
    }
    move_all(layer.paths, found->paths);
    move_all(layer.texts, found->texts);
    after = std::max(after, static_cast<std::size_t>(found - to.begin()) + 1);
  }
}

void add(DrawingStats& to, const DrawingStats& from) {
  to.triangles = std::max(to.triangles, from.triangles);
  to.strokes += from.strokes;
  to.coverage_points += from.coverage_points;
  to.coverage_delta = std::max(to.coverage_delta, from.coverage_delta);
  if (!to.tone_gamma) to.tone_gamma = from.tone_gamma;
  if (!from.verify) return;
  if (!to.verify) to.verify.emplace();
  Verification& sum = *to.verify;
  sum.spans += from.verify->spans;
  sum.length += from.verify->length;
  sum.contradicted += from.verify->contradicted;
  sum.count += from.verify->count;
  sum.loose_ends += from.verify->loose_ends;
  sum.area += from.verify->area;
  sum.wrong_area += from.verify->wrong_area;
  sum.wrong_patches += from.verify->wrong_patches;
  sum.contradictions.insert(sum.contradictions.end(), from.verify->contradictions.begin(),
                            from.verify->contradictions.end());
}

}  // namespace

void append_view(Drawing& sheet, Drawing&& view) {
  merge_layers(sheet.layers, view.layers);
  move_all(view.areas, sheet.areas);
  for (const SpotInk& ink : view.inks) add_ink(ink.name, ink.color, sheet);
  add(sheet.stats, view.stats);
  append_new(view.diagnostics, sheet.diagnostics);
}

void append_new(const Diagnostics& from, Diagnostics& to) {
  for (const Diagnostic& said : from.entries()) {
    const auto same = [&](const Diagnostic& d) {
      return d.code == said.code && d.message == said.message;
    };
    if (std::ranges::none_of(to.entries(), same)) to.add(said);
  }
}

}  // namespace burin
