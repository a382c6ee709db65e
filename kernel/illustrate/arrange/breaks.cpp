#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/illustrate/illustrate.h>

#include "realised_forms.h"
#include "uniform_stretches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using BreakRange = std::pair<double, double>;

/// A stretch is long from so many of its widths on, of which so many stay at each end; and what is
/// left out is at least this share of the whole length.
constexpr double kLongStretch = 5, kKeptOfWidth = 1.5, kLeastLeftOut = 0.2;
/// Cosine of directions that are one.
constexpr double kSameWay = 1 - 1e-9;

Vec3 longest_axis(const Box3& box) {
  const Vec3 size = box.size();
  int longest = 0;
  for (int k = 1; k < 3; ++k) {
    if (size[k] > size[longest]) longest = k;
  }
  Vec3 axis(0);
  axis[longest] = 1;
  return axis;
}

std::string axis_text(const Vec3& axis) {
  for (int k = 0; k < 3; ++k) {
    if (axis[k] > kSameWay) return std::string(1, "xyz"[k]);
  }
  return fmt::format("{:g},{:g},{:g}", axis.x, axis.y, axis.z);
}

/// "z:20..180".
std::string break_text(const Vec3& axis, const BreakRange& stretch) {
  return fmt::format("{}:{:g}..{:g}", axis_text(axis), stretch.first, stretch.second);
}

bool stretches_meet(const BreakRange& a, const BreakRange& b) {
  return a.first <= b.second && b.first <= a.second;
}

/// Finds what breaks leave out.
class BreakFinder {
 public:
  BreakFinder(Scene& scene, const Illustration& illustration, RunContext& context)
      : scene_(scene),
        illustration_(illustration),
        context_(context),
        box_(drawn_bounds(scene, illustration.illustrate.part_styles)) {}

  ModelBreaks run() {
    settle_axis();
    std::vector<BreakRange> given;
    for (const Break& one : illustration_.breaks) {
      if (one.stretch) add_given(one, given);
    }
    ModelBreaks out{axis_, {}};
    for (const BreakRange& stretch : given) {
      if (is_inside(stretch)) out.stretches.push_back(stretch);
    }
    for (const Break& one : illustration_.breaks) {
      if (!one.stretch) add_found(one, out.stretches);
    }
    std::ranges::sort(out.stretches);
    return out;
  }

  /// Those that are drawn; realised when they are first asked for.
  const std::shared_ptr<const detail::MeasuredParts>& shared_parts() {
    if (!parts_) {
      detail::RealisedForms forms(scene_.bounds(Mat3(1)).diagonal(), context_);
      const std::vector<bool> drawn = drawn_parts(scene_, illustration_.illustrate.part_styles);
      parts_ = std::make_shared<const detail::MeasuredParts>(
          detail::MeasuredParts{detail::surfaces_of(scene_, drawn, forms), forms.tolerance()});
    }
    return parts_;
  }

 private:
  const detail::MeasuredParts& parts() { return *shared_parts(); }

  void settle_axis() {
    const Vec3 longest = longest_axis(box_);
    axis_ = illustration_.breaks.front().axis.value_or(longest);
    for (const Break& one : illustration_.breaks) {
      const Vec3 other = one.axis.value_or(longest);
      if (std::abs(glm::dot(axis_, other)) > kSameWay) continue;
      throw UsageError(fmt::format("{}breaks of one drawing are along one axis, not {} and {}",
                                   one.place, axis_text(axis_), axis_text(other)));
    }
    const Mat3 axes = glm::transpose(any_axes());
    const Box3 along = drawn_bounds(scene_, illustration_.illustrate.part_styles, axes);
    whole_ = {along.min.z, along.max.z};
  }

  Mat3 any_axes() const {
    const Vec3 across = any_orthogonal(axis_);
    return {across, glm::cross(axis_, across), axis_};
  }

  void add_given(const Break& one, std::vector<BreakRange>& given) {
    BreakRange stretch = *one.stretch;
    if (one.axis && glm::dot(*one.axis, axis_) < 0) stretch = {-stretch.second, -stretch.first};
    for (const BreakRange& other : given) {
      if (!stretches_meet(stretch, other)) continue;
      throw UsageError(fmt::format("{}breaks {} and {} overlap: leave something between them",
                                   one.place, break_text(axis_, other),
                                   break_text(axis_, stretch)));
    }
    given.push_back(stretch);
    if (is_inside(stretch)) return;
    scene_.diagnostics.add(
        Severity::Warning, "break.outside", 1,
        fmt::format("{}the break {} has no effect: what is drawn reaches from {:g} to {:g}, and a "
                    "break leaves both ends",
                    one.place, break_text(axis_, stretch), whole_.first, whole_.second));
  }

  bool is_inside(const BreakRange& stretch) const {
    return stretch.first > whole_.first && stretch.second < whole_.second;
  }

  void add_found(const Break& one, std::vector<BreakRange>& to) {
    bool any = false;
    const std::vector<detail::UniformStretch> uniform = detail::uniform_stretches(parts(), axis_);
    for (const detail::UniformStretch& found : uniform) {
      const double length = found.high - found.low, kept = kKeptOfWidth * found.width;
      const BreakRange stretch{found.low + kept, found.high - kept};
      if (length < kLongStretch * found.width) continue;
      if (length - 2 * kept < kLeastLeftOut * (whole_.second - whole_.first)) continue;
      if (std::ranges::any_of(
              to, [&](const BreakRange& other) { return stretches_meet(stretch, other); })) {
        continue;
      }
      to.push_back(stretch);
      any = true;
    }
    if (any) return;
    const BreakRange instead = beside_faces(uniform);
    scene_.diagnostics.add(
        Severity::Warning, "break.not_found", 1,
        fmt::format("{}nothing is broken: no long stretch along {} keeps its cross-section; name "
                    "one, as {}:{:.4g}..{:.4g}",
                    one.place, axis_text(axis_), axis_text(axis_), instead.first, instead.second));
  }

  /// The middle half of all, but that it ends where the cross-section stays the same.
  BreakRange beside_faces(const std::vector<detail::UniformStretch>& uniform) const {
    const auto beside = [&](double share) {
      const double at = std::lerp(whole_.first, whole_.second, share);
      double best = at, least = std::numeric_limits<double>::infinity();
      for (const detail::UniformStretch& one : uniform) {
        const double kept = 0.25 * (one.high - one.low);
        const double there = std::clamp(at, one.low + kept, one.high - kept);
        if (std::abs(there - at) < least) best = there, least = std::abs(there - at);
      }
      return best;
    };
    const BreakRange found{beside(0.25), beside(0.75)};
    if (found.first < found.second) return found;
    return {std::lerp(whole_.first, whole_.second, 0.25),
            std::lerp(whole_.first, whole_.second, 0.75)};
  }

  Scene& scene_;
  const Illustration& illustration_;
  RunContext& context_;
  std::shared_ptr<const detail::MeasuredParts> parts_;
  Box3 box_;
  Vec3 axis_{1, 0, 0};
  BreakRange whole_;
};

}  // namespace

void find_breaks(Scene& scene, Illustration& illustration, RunContext& context) {
  illustration.left_out = {};
  illustration.left_parts.reset();
  if (illustration.breaks.empty()) return;
  BreakFinder finder(scene, illustration, context);
  illustration.left_out = finder.run();
  if (illustration.overall_dimensions && !illustration.left_out.empty()) {
    illustration.left_parts = finder.shared_parts();
  }
}

}  // namespace burin
