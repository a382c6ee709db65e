#include "broken_view.h"

#include <burin/assembly/select.h>
#include <burin/base/box_corners.h>
#include <burin/illustrate/illustrate.h>

#include "wanted_views.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace burin::detail {
namespace {

/// Cosine, and sine, from which on a view sees an axis from its side, and from its end.
constexpr double kFromSide = 1 - 1e-12, kFromEnd = 1e-6;
/// Of a stretch: what is less than it is rounding.
constexpr double kNothing = 1e-6;

/// Where what is drawn begins and ends along a direction across the axis, both unit.
std::pair<double, double> range_across(const Scene& scene, const Illustration& illustration,
                                       const Vec3& axis, const Vec3& direction) {
  const Mat3 axes = glm::transpose(Mat3(direction, axis, glm::cross(direction, axis)));
  const Box3 box = drawn_bounds(scene, illustration.illustrate.part_styles, axes);
  return {box.min.x, box.max.x};
}

/// Rounding would move what lies across.
Vec2 without_rounding(Vec2 along) {
  for (int k = 0; k < 2; ++k) {
    if (std::abs(along[k]) < kFromEnd * kFromEnd) along[k] = 0;
  }
  return glm::normalize(along);
}

}  // namespace

BrokenAs::BrokenAs(const Scene& scene, const Illustration& illustration, const ViewOptions& view)
    : axis_(illustration.left_out.axis),
      gap_(illustration.style.broken.gap),
      reach_(break_reach(illustration.style.broken)) {
  if (illustration.left_out.empty() || illustration.view.perspective) return;
  const Mat3 axes = axes_of(view);
  const Vec3 seen = axes * axis_;
  foreshortened_ = glm::length(Vec2(seen));
  if (foreshortened_ < kFromEnd) return;
  along_ = without_rounding(Vec2(seen));
  way_ = glm::transpose(axes) * Vec3(along_, 0);
  double nearest = 0, farthest = 0;
  if (foreshortened_ < kFromSide) {
    // Places of one cross-section are not side by side on paper.
    const Vec3 slant = way_ - foreshortened_ * axis_;
    const double e = glm::length(slant);
    const auto [low, high] = range_across(scene, illustration, axis_, slant / e);
    nearest = e * low, farthest = e * high;
  } else {
    foreshortened_ = 1;
  }
  for (const auto& [low, high] : illustration.left_out.stretches) {
    const PaperBreaks::Band band{foreshortened_ * low + farthest, foreshortened_ * high + nearest};
    if (band.high - band.low > kNothing * (high - low)) bands_.push_back(band);
  }
}

Camera::ExtentFn BrokenAs::shortened(Camera::ExtentFn whole) const {
  if (empty()) return whole;
  return [whole = std::move(whole), along = along_, bands = bands_](const Mat3& axes) {
    const Vec2 across(-along.y, along.x);
    const Mat3 turn = glm::transpose(Mat3(Vec3(along, 0), Vec3(across, 0), Vec3(0, 0, 1)));
    const Box3 box = whole(axes), turned = whole(turn * axes);
    Box3 out;
    double low = turned.min.x, by = 0;
    for (std::size_t i = 0; i <= bands.size(); ++i) {
      const double high = i < bands.size() ? bands[i].low : turned.max.x;
      Box2 piece;
      for (const double s : {low, high}) {
        for (const double t : {turned.min.y, turned.max.y}) piece.add(s * along + t * across);
      }
      piece.min = glm::max(piece.min, Vec2(box.min)) + by * along;
      piece.max = glm::min(piece.max, Vec2(box.max)) + by * along;
      out.add(Vec3(piece.min, box.min.z));
      out.add(Vec3(piece.max, box.max.z));
      if (i == bands.size()) break;
      by -= bands[i].high - bands[i].low;
      low = bands[i].high;
    }
    return out;
  };
}

Margin BrokenAs::room() const {
  if (empty()) return Margin(0);
  const Vec2 gaps = 0.5 * gap_ * static_cast<double>(bands_.size()) * glm::abs(along_);
  const Vec2 side = gaps + reach_ * glm::abs(Vec2(-along_.y, along_.x));
  return {side.y, side.x, side.y, side.x};
}

PaperBreaks BrokenAs::on_paper(double scale, double origin) const {
  PaperBreaks breaks{along_, {}, gap_, Vec2(0)};
  double gaps = 0;
  for (const PaperBreaks::Band& band : bands_) {
    breaks.bands.push_back({origin + scale * band.low, origin + scale * band.high});
    gaps += breaks.gap_of(breaks.bands.back());
  }
  // Both halves give way to the gaps, so that the middle stays.
  breaks.offset = -0.5 * gaps * along_;
  return breaks;
}

PaperBreaks BrokenAs::on_paper(const Camera& camera, const ViewOptions& view) const {
  if (empty()) return {};
  PaperBreaks breaks = on_paper(camera.scale(), glm::dot(along_, camera.to_paper(Vec3(0))));
  if (view.center) {
    const Vec2 center = camera.to_paper(*view.center);
    breaks.offset -= breaks.moved(center) - center;
  }
  return breaks;
}

/// Moves points of the model so that a camera shows them where the broken view has them.
class BrokenAs::Mover {
 public:
  Mover(const BrokenAs& as, const PaperBreaks& breaks, double scale, double origin)
      : as_(as), breaks_(breaks), scale_(scale), origin_(origin) {}

  void move(Dimension& one) const {
    for (LeaderTarget& target : one.targets) {
      for (Vec3& p : target.tips) p += shift(p);
    }
    if (one.kind == Dimension::Kind::Note) return;
    const bool length = one.kind == Dimension::Kind::Length;
    // Circles and angles keep their shape.
    const Vec3 as_one = shift(one.kind == Dimension::Kind::Angle ? one.to : one.from);
    const auto moved = [&](Vec3 p) { return p + (length ? shift(p) : as_one); };
    one.from = moved(one.from);
    one.to = moved(one.to);
    if (one.kind == Dimension::Kind::Angle) one.other = moved(one.other);
    for (auto* points : {&one.from_points, &one.to_points}) {
      for (Vec3& p : *points) p = moved(p);
    }
  }

  Box3 moved(const Box3& box) const {
    Box3 out;
    for (const Vec3& p : corners_of(box)) out.add(p + shift(p));
    return out;
  }

 private:
  Vec2 on_way(const Vec3& p) const {
    return (origin_ + scale_ * glm::dot(as_.way_, p)) * as_.along_;
  }
  Vec3 shift(const Vec3& p) const {
    const Vec2 at = on_way(p);
    const double on_paper = glm::dot(as_.along_, breaks_.moved(at) - at);
    return on_paper / (scale_ * as_.foreshortened_) * as_.axis_;
  }

  const BrokenAs& as_;
  const PaperBreaks& breaks_;
  double scale_, origin_;
};

ViewDimensions BrokenAs::moved(const ViewDimensions& dimensions, double scale) const {
  if (empty() || dimensions.list.empty()) return dimensions;
  const PaperBreaks breaks = on_paper(scale, 0);
  return moved(dimensions, Mover(*this, breaks, scale, 0));
}

ViewDimensions BrokenAs::moved(const ViewDimensions& dimensions, const Camera& camera,
                               const PaperBreaks& breaks) const {
  return moved(dimensions,
               Mover(*this, breaks, camera.scale(), glm::dot(along_, camera.to_paper(Vec3(0)))));
}

ViewDimensions BrokenAs::moved(ViewDimensions dimensions, const Mover& mover) {
  for (Dimension& one : dimensions.list) mover.move(one);
  if (!dimensions.about.empty()) dimensions.about = mover.moved(dimensions.about);
  return dimensions;
}

void break_view(const BrokenAs& broken, const ViewOptions& view, PlacedView& placed) {
  if (broken.empty()) return;
  placed.breaks = broken.on_paper(placed.camera, view);
  placed.dimensions = broken.moved(placed.dimensions, placed.camera, placed.breaks);
}

namespace {

/// Whether a view shows something of a part.
bool is_left(const Part& part, const PlacedView& view) {
  const Camera& camera = view.camera;
  const PaperBreaks& breaks = view.breaks;
  const Vec3 way = breaks.along.x * camera.right() + breaks.along.y * camera.up();
  const Box3 box = part.form->bounds(glm::transpose(Mat3(way, way, way)));
  const double origin = glm::dot(breaks.along, camera.to_paper(Vec3(0)));
  const double low = origin + camera.scale() * box.min.x,
               high = origin + camera.scale() * box.max.x;
  return std::ranges::none_of(breaks.bands, [&](const PaperBreaks::Band& band) {
    return low > band.low && high < band.high;
  });
}

/// Tells of parts of which no view shows anything.
void report_left_out(Scene& scene, const Illustration& illustration, const SheetOfViews& sheet) {
  constexpr std::size_t kNamed = 5;
  const std::vector<bool> drawn = drawn_parts(scene, illustration.illustrate.part_styles);
  std::vector<std::string> names;
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const Part& part = scene.parts[i];
    if (!drawn[i] || part.form->bounds(Mat3(1)).empty()) continue;
    if (std::ranges::any_of(sheet.views, [&](const PlacedView& view) {
          return !view.within && is_left(part, view);
        })) {
      continue;
    }
    if (++count <= kNamed) names.push_back(path_of(part));
  }
  if (count == 0) return;
  std::string text = fmt::format("{}the break leaves out all of '{}'",
                                 illustration.breaks.front().place, fmt::join(names, "', '"));
  if (count > kNamed) text += fmt::format(" and {} more", count - kNamed);
  scene.diagnostics.add(Severity::Warning, "break.parts", static_cast<std::int64_t>(count),
                        text + ": break another stretch, or add a view along the axis");
}

}  // namespace

void report_unbroken(Scene& scene, const Illustration& illustration, const SheetOfViews& sheet) {
  if (illustration.left_out.empty()) return;
  const auto tell = [&](const char* code, const std::string& message) {
    scene.diagnostics.add(Severity::Warning, code, 1, message);
  };
  const std::string& place = illustration.breaks.front().place;
  if (illustration.view.perspective) {
    tell("break.not_shown", place + "a perspective view is not broken: leave `perspective` out");
    return;
  }
  report_left_out(scene, illustration, sheet);
  bool any = false;
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedView& view : sheet.views) {
    any = any || !view.breaks.empty();
    for (const PaperBreaks::Band& band : view.breaks.bands) {
      least = std::min(least, band.high - band.low);
    }
  }
  if (!any) {
    tell("break.not_shown",
         place + "the break has no effect: no view of the sheet shows its stretch from the side");
  } else if (least <= illustration.style.broken.gap) {
    tell("break.short",
         fmt::format("{}a break leaves out {:.2g} mm on the sheet and saves nothing: the gap "
                     "between its ends (break.gap) is {:g} mm",
                     place, least, illustration.style.broken.gap));
  }
}

}  // namespace burin::detail
