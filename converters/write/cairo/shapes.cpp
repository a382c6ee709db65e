#include "shapes.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/font.h>

#include <new>
#include <string>

namespace burin {
namespace {

/// A curve that is a line within this distance is written as one; far below what shows.
constexpr double kStraight = 0.0005;  // paper mm

}  // namespace

std::vector<Shape> shapes_of(const std::vector<InkLayer>& layers, const Drawing& drawing,
                             const DashOptions& options) {
  std::vector<Shape> shapes;
  for (const InkLayer& layer : layers) {
    const auto rgb = [](const std::string& color) { return rgb_of(color).value_or(Rgb{}); };
    for (const auto& [part, paths] : layer.parts) {
      for (const Path* path : paths) {
        const Rgb color = rgb(ink_color(*path, layer, drawing));
        shapes.push_back({path, fitted_dashes(layer.dashes(options), *path), {}, nullptr, color});
      }
    }
    const Rgb color = rgb(ink_color(layer, drawing));
    for (const Text* text : layer.texts) shapes.push_back({nullptr, {}, {}, text, color});
  }
  return shapes;
}

void fit_ink(std::span<Shape> shapes, double tolerance, const RunContext& context) {
  constexpr std::size_t kGrain = 32;
  parallel_for(
      shapes.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Shape& s = shapes[i];
          shapes[i].ink = s.path ? ink_of(*s.path, tolerance) : text_ink(*s.text);
        }
      },
      &context);
}

Pen pen_on(cairo_surface_t* surface, double paper_height, double scale, double top) {
  Pen pen(cairo_create(surface));
  cairo_t* p = pen.get();
  cairo_translate(p, 0, -top);
  cairo_scale(p, scale, -scale);
  cairo_translate(p, 0, -paper_height);
  cairo_set_source_rgb(p, 0, 0, 0);
  cairo_set_fill_rule(p, CAIRO_FILL_RULE_WINDING);
  cairo_set_line_cap(p, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(p, CAIRO_LINE_JOIN_ROUND);
  return pen;
}

void trace(cairo_t* pen, const Shape& shape) {
  const Ink& ink = shape.ink;
  for (const auto& chain : ink.chains) {
    const Vec2 start = chain.empty() ? shape.path->points.front() : chain.front()[0];
    cairo_move_to(pen, start.x, start.y);
    // A line of no length is a dot, by its round caps.
    if (chain.empty()) cairo_line_to(pen, start.x, start.y);
    for (const CubicBezier& c : chain) {
      if (is_straight(c, kStraight)) {
        cairo_line_to(pen, c[3].x, c[3].y);
      } else {
        cairo_curve_to(pen, c[1].x, c[1].y, c[2].x, c[2].y, c[3].x, c[3].y);
      }
    }
    if (!chain.empty() && (ink.filled || shape.path->closed)) cairo_close_path(pen);
  }
}

void paint_traced(cairo_t* pen, const Shape& shape) {
  if (shape.ink.filled) return cairo_fill(pen);
  cairo_set_dash(pen, shape.dashes.data(), static_cast<int>(shape.dashes.size()), 0);
  cairo_set_line_width(pen, shape.ink.width);
  cairo_stroke(pen);
}

void use(cairo_t* pen, const Rgb& color) {
  cairo_set_source_rgb(pen, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

bool same_pen(const Shape& a, const Shape& b) {
  if (a.color != b.color) return false;
  if (a.ink.filled || b.ink.filled) return a.ink.filled && b.ink.filled;
  return a.ink.width == b.ink.width && a.dashes == b.dashes;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw Error(std::string("cairo failed: ") + cairo_status_to_string(status));
}

}  // namespace burin
