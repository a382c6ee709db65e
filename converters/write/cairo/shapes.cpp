#include "shapes.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/font.h>

#include <new>
#include <string>

namespace burin {
std::vector<Shape> shapes_of(const std::vector<InkLayer>& layers, const Drawing& drawing,
                             const DashOptions& options) {
  std::vector<Shape> shapes;
  for (const Area* area : painted_areas(drawing)) {
    shapes.push_back({.color = rgb_of(area->fill).value_or(Rgb{}), .area = area});
  }
  for (const InkLayer& layer : layers) {
    const auto rgb = [](const std::string& color) { return rgb_of(color).value_or(Rgb{}); };
    for (const auto& [part, paths] : layer.parts) {
      for (const Path* path : paths) {
        const Rgb color = rgb(ink_color(*path, layer, drawing));
        shapes.push_back(
            {.path = path, .dashes = fitted_dashes(layer.dashes(options), *path), .color = color});
      }
    }
    const Rgb color = rgb(ink_color(layer, drawing));
    for (const Text* text : layer.texts) shapes.push_back({.text = text, .color = color});
  }
  return shapes;
}

void fit_ink(std::span<Shape> shapes, double tolerance, TextsAs texts, const RunContext& context) {
  constexpr std::size_t kGrain = 32;
  parallel_for(
      shapes.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Shape& s = shapes[i];
          if (s.area || (s.text && texts == TextsAs::Letters)) continue;
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

namespace {

void trace(cairo_t* pen, const Area& area) {
  for (const std::vector<Vec2>& ring : area.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      (i == 0 ? cairo_move_to : cairo_line_to)(pen, ring[i].x, ring[i].y);
    }
    cairo_close_path(pen);
  }
}

void paint(cairo_t* pen, const Area& area) {
  cairo_set_fill_rule(pen, CAIRO_FILL_RULE_EVEN_ODD);
  if (area.opacity < 1) {
    cairo_fill(pen);
  } else {
    cairo_fill_preserve(pen);
    cairo_set_dash(pen, nullptr, 0, 0);
    cairo_set_line_width(pen, kTrap);
    cairo_stroke(pen);
  }
  cairo_set_fill_rule(pen, CAIRO_FILL_RULE_WINDING);
}

}  // namespace

void trace(cairo_t* pen, const Shape& shape) {
  if (shape.area) return trace(pen, *shape.area);
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
  if (shape.area) return paint(pen, *shape.area);
  if (shape.ink.filled) return cairo_fill(pen);
  cairo_set_dash(pen, shape.dashes.data(), static_cast<int>(shape.dashes.size()), 0);
  cairo_set_line_width(pen, shape.ink.width);
  cairo_stroke(pen);
}

void use(cairo_t* pen, const Rgb& color, double opacity) {
  const double r = color[0] / 255.0, g = color[1] / 255.0, b = color[2] / 255.0;
  if (opacity < 1) return cairo_set_source_rgba(pen, r, g, b, opacity);
  cairo_set_source_rgb(pen, r, g, b);
}

bool same_pen(const Shape& a, const Shape& b) {
  if (a.color != b.color || a.area || b.area || a.text || b.text) return false;
  if (a.ink.filled || b.ink.filled) return a.ink.filled && b.ink.filled;
  return a.ink.width == b.ink.width && a.dashes == b.dashes;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw Error(std::string("cairo failed: ") + cairo_status_to_string(status));
}

}  // namespace burin
