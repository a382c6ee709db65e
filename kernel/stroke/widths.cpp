#include "widths.h"

#include <burin/base/parallel.h>
#include <burin/base/smoothstep.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace burin::detail {
namespace {

constexpr double kBlur = 0.9;    // paper mm, half width of each of the box blurs
constexpr int kWidthRounds = 4;  // of correction
// A width may leave its first guess by this factor: a stroke that is left alone in a fading tone
// must not swell to a leaf to make up for its neighbours.
constexpr double kMostCorrection = 1.6;
// ... less where its neighbours tell how wide it is to be.
constexpr double kMostBeside = 1.15;
constexpr double kAlone = 1.6;      // widest gaps: a neighbour further off is none
constexpr double kThinnest = 0.02;  // paper mm
// Of the room that a line has, at the most: lines that draw together stay lines.
constexpr double kFullest = 0.75;
constexpr double kFaded = 0.3;  // weight under which a line needs no taper
// Paper mm that the corner of a stroke may stick out over the border at which it ends: half of the
// line that is drawn there.
constexpr double kOverhang = 0.06;
constexpr double kBlunt = 0.3;  // paper mm over which a stroke thins out between its neighbours
constexpr double kClosingTip = 0.8;  // ... where they close up behind it
constexpr double kSmoothing = 1.2;   // paper mm over which widths are evened out along a stroke

// A stroke that ends in the light is the fainter the nearer it is to the style's shortest, and
// whole from so many of them on: the next one is too short and missing.
constexpr double kWhole = 2.5, kFaintest = 0.3;

using Plane = std::vector<float>;

// Passes of a box blur in both directions, in place of a Gaussian: two of them, and a third half as
// wide, without which even lines beat with the cells and widths are corrected for it. Lines run
// side by side, in bundles, so that columns are read along the rows.
void box_blur(Plane& plane, std::int32_t nx, std::int32_t ny, std::int32_t wide) {
  constexpr std::int32_t kBundle = 64;
  Plane out(plane.size());
  const auto rows = [&](const Plane& in, Plane& to, std::int32_t radius) {
    parallel_for(static_cast<std::size_t>(ny), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t y = begin; y < end; ++y) {
        const std::size_t base = y * static_cast<std::size_t>(nx);
        double sum = 0;
        for (std::int32_t i = -radius; i < nx; ++i) {
          const std::int32_t in_at = i + radius, out_at = i - radius - 1;
          if (in_at < nx) sum += in[base + static_cast<std::size_t>(in_at)];
          if (out_at >= 0) sum -= in[base + static_cast<std::size_t>(out_at)];
          if (i >= 0) {
            to[base + static_cast<std::size_t>(i)] =
                static_cast<float>(std::max(0.0, sum) / (2 * radius + 1));
          }
        }
      }
    });
  };
  const auto columns = [&](const Plane& in, Plane& to, std::int32_t radius) {
    const std::int32_t bundles = (nx + kBundle - 1) / kBundle;
    parallel_for(static_cast<std::size_t>(bundles), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) {
        const std::size_t first = b * kBundle;
        const std::size_t count =
            std::min<std::size_t>(kBundle, static_cast<std::size_t>(nx) - first);
        std::array<double, kBundle> sum{};
        const auto row = [&](std::int32_t y) {
          return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + first;
        };
        for (std::int32_t i = -radius; i < ny; ++i) {
          const std::int32_t in_at = i + radius, out_at = i - radius - 1;
          if (in_at < ny) {
            for (std::size_t c = 0; c < count; ++c) sum[c] += in[row(in_at) + c];
          }
          if (out_at >= 0) {
            for (std::size_t c = 0; c < count; ++c) sum[c] -= in[row(out_at) + c];
          }
          if (i >= 0) {
            for (std::size_t c = 0; c < count; ++c) {
              to[row(i) + c] = static_cast<float>(std::max(0.0, sum[c]) / (2 * radius + 1));
            }
          }
        }
      }
    });
  };
  for (const std::int32_t r : {wide, wide, std::max(1, wide / 2)}) {
    rows(plane, out, r);
    columns(out, plane, r);
  }
}

class WidthSolver {
 public:
  WidthSolver(const Picture& picture, const ViewRaster& raster, const std::vector<Family>& families,
              const RunContext& context)
      : picture_(picture),
        raster_(raster),
        families_(families),
        context_(context),
        radius_(std::max(1, static_cast<std::int32_t>(std::lround(kBlur / raster.pitch)))) {
    mask_.resize(raster.cells.size());
    for (std::size_t i = 0; i < mask_.size(); ++i)
      mask_[i] = raster.cells[i].part >= 0 ? 1.0f : 0.0f;
    blurred_mask_ = mask_;
    blur(blurred_mask_);
  }

  Widths solve() {
    first_guess();
    // Second family first: what it cannot give, the first one makes up for.
    Plane second(mask_.size(), 0.0f);
    for (std::size_t f = families_.size(); f-- > 0;) {
      Plane target(mask_.size());
      for (std::size_t i = 0; i < target.size(); ++i) {
        const double dark = raster_.cells[i].darkness;
        const double ink =
            f == 1 ? picture_.share(dark).second : 1 - (1 - dark) / std::max(0.05, 1.0 - second[i]);
        target[i] = mask_[i] * static_cast<float>(picture_.laid(std::clamp(ink, 0.0, 1.0)));
      }
      blur(target);
      Plane ink;
      for (int round = 0; round < kWidthRounds; ++round) {
        context_.check();
        ink = deposit(f);
        correct(f, target, ink);
      }
      if (f == 1) second = covered(deposit(f));
    }
    return std::move(widths_);
  }

 private:
  void blur(Plane& p) const { box_blur(p, raster_.nx, raster_.ny, radius_); }

  // The share of the paper that is covered, of what was laid.
  Plane covered(Plane p) const {
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] = blurred_mask_[i] > 0 ? static_cast<float>(picture_.covered(p[i] / blurred_mask_[i]))
                                  : 0.0f;
    }
    return p;
  }

  void first_guess() {
    widths_.resize(families_.size());
    most_.resize(families_.size());
    taper_.resize(families_.size());
    for (std::size_t f = 0; f < families_.size(); ++f) {
      const auto& strokes = families_[f].strokes;
      widths_[f].resize(strokes.size());
      most_[f].resize(strokes.size());
      taper_[f].resize(strokes.size());
      parallel_for(
          strokes.size(), 16,
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t s = begin; s < end; ++s) {
              widths_[f][s] = guess(f, s, most_[f][s]);
              taper_[f][s] = taper(strokes[s]);
            }
          },
          &context_);
    }
    guess_ = widths_;
  }

  // Sets what no width may exceed, too.
  std::vector<double> guess(std::size_t f, std::size_t id, std::vector<double>& most_of) const {
    const TracedStroke& stroke = families_[f].strokes[id];
    std::vector<double> w(stroke.samples.size());
    most_of.assign(w.size(), picture_.options.width_max);
    for (std::size_t i = 0; i < w.size(); ++i) {
      const StrokeSample& s = stroke.samples[i];
      const double ink = picture_.share(s.darkness, static_cast<int>(f) + 1);
      if (picture_.by_chance()) {
        w[i] = picture_.free_width(ink);
        continue;
      }
      // Half of the gaps on both sides are its own to ink; where it has no neighbour on one side,
      // as much as on the other. Beside a contour, no more than to where the next line would be: at
      // the border of a highlight it would be a claw.
      const double most = kAlone * picture_.options.spacing_max;
      SampleGrid::Sides gap =
          families_[f].grid.sides(grid_sample(s, stroke.part, static_cast<std::int32_t>(id)), most);
      const double asked = picture_.options.spacing_min;
      const bool turning = s.gap > 0 && s.facing < kTurning;
      const double free = turning ? std::min(s.gap, asked) : asked, widest = turning ? free : most;
      const bool left = gap.left < most, right = gap.right < most;
      if (!left) gap.left = right ? std::min(gap.right, widest) : free;
      if (!right) gap.right = left ? std::min(gap.left, widest) : free;
      // A line that fades out leaves its room to the next ones.
      const double room = 0.5 * gap.left * (1 + s.weight - gap.left_weight) +
                          0.5 * gap.right * (1 + s.weight - gap.right_weight);
      most_of[i] = limit(std::max(kFullest, ink) * room, f, s.weight);
      w[i] = limit(ink * room, f, s.weight);
    }
    smooth(stroke, w);
    if (picture_.swells() && !picture_.by_chance()) {
      keep_inside(stroke, true, most_of);
      keep_inside(stroke, false, most_of);
    }
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = std::min(w[i], most_of[i]);
    return w;
  }

  // Where a stroke runs into a border at a grazing angle its corners would be a row of teeth along
  // it: no place of it is wider than leaves them inside.
  void keep_inside(const TracedStroke& stroke, bool begin, std::vector<double>& most) const {
    const auto across = border_normal(picture_, stroke, begin);
    if (!across) return;
    const std::size_t n = most.size();
    const Vec2 end = (begin ? stroke.samples.front() : stroke.samples.back()).paper;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = begin ? k : n - 1 - k;
      const StrokeSample& s = stroke.samples[i];
      const double inside = std::abs(glm::dot(*across, s.paper - end)) + kOverhang,
                   along = std::abs(cross2(*across, s.direction));
      const double widest = along > 0 ? 2 * inside / along : picture_.options.width_max;
      if (widest >= most[i]) return;
      most[i] = std::max(widest, std::min(kThinnest, picture_.options.width_min));
    }
  }

  // The second family, and a line that fades out, are as thin as can be printed.
  double limit(double w, std::size_t family, double weight) const {
    const HatchOptions& o = picture_.options;
    const double thinnest = std::min(kThinnest, o.width_min);
    const bool swells = !picture_.by_chance() && o.width_min < o.width_max;
    const double least = !swells       ? o.width_min
                         : family == 1 ? thinnest
                                       : thinnest + weight * (o.width_min - thinnest);
    return std::clamp(w, least, o.width_max);
  }

  // The share of its width that a short stroke into the light has.
  double faintness(const TracedStroke& stroke) const {
    const bool light =
        stroke.begin_reason == StrokeEnd::Light || stroke.end_reason == StrokeEnd::Light;
    const double least = picture_.options.length_min;
    if (!light || !(least > 0) || !picture_.swells() || picture_.by_chance()) return 1;
    const double long_enough = smoothstep(least, kWhole * least, stroke.length());
    return kFaintest + (1 - kFaintest) * long_enough;
  }

  // Ends that stop at an edge or at the seam of families are cut there; all others thin out.
  std::vector<double> taper(const TracedStroke& stroke) const {
    const std::size_t n = stroke.samples.size();
    std::vector<double> t(n, 1.0);
    if (stroke.closed) return t;
    t.assign(n, faintness(stroke));
    const double longest = std::min(picture_.options.taper, 0.4 * stroke.length());
    const auto length = [&](StrokeEnd e, const StrokeSample& last) {
      switch (e) {
        case StrokeEnd::Crowded:
          return std::min(longest, kBlunt);
        case StrokeEnd::Tip:
          return std::min(longest, kClosingTip);
        case StrokeEnd::Light:
          return last.weight < kFaded ? std::min(longest, kBlunt) : longest;
        case StrokeEnd::Singular:
        case StrokeEnd::Length:
          return longest;
        default:
          return 0.0;
      }
    };
    const auto apply = [&](bool from_begin, double thin) {
      double s = 0;
      for (std::size_t i = 0; i < n && s < thin; ++i) {
        const std::size_t at = from_begin ? i : n - 1 - i;
        t[at] = std::min(t[at], s / thin);
        if (i + 1 < n) {
          const std::size_t next = from_begin ? at + 1 : at - 1;
          s += glm::length(stroke.samples[next].paper - stroke.samples[at].paper);
        }
      }
    };
    apply(true, length(stroke.begin_reason, stroke.samples.front()));
    apply(false, length(stroke.end_reason, stroke.samples.back()));
    return t;
  }

  // A moving average over kSmoothing paper mm.
  void smooth(const TracedStroke& stroke, std::vector<double>& w) const {
    const double step =
        stroke.length() / static_cast<double>(std::max<std::size_t>(1, w.size() - 1));
    const auto r = static_cast<std::ptrdiff_t>(step > 0 ? kSmoothing / step : 0);
    if (r < 1) return;
    std::vector<double> sums(w.size() + 1, 0);
    for (std::size_t i = 0; i < w.size(); ++i) sums[i + 1] = sums[i] + w[i];
    const auto n = static_cast<std::ptrdiff_t>(w.size());
    for (std::ptrdiff_t i = 0; i < n; ++i) {
      const auto a = std::max<std::ptrdiff_t>(0, i - r), b = std::min(n, i + r + 1);
      w[static_cast<std::size_t>(i)] =
          (sums[static_cast<std::size_t>(b)] - sums[static_cast<std::size_t>(a)]) /
          static_cast<double>(b - a);
    }
  }

  // The share of each cell that the strokes of a family cover, blurred.
  Plane deposit(std::size_t f) const {
    Plane plane(mask_.size(), 0.0f);
    const auto& strokes = families_[f].strokes;
    for (std::size_t id = 0; id < strokes.size(); ++id) {
      if (id % 64 == 0) context_.check();
      const auto& samples = strokes[id].samples;
      if (picture_.dots()) splat(plane, samples[0].paper, dot_area(widths_[f][id][0]));
      for (std::size_t i = 1; i < samples.size(); ++i) {
        if (!samples[i].visible || !samples[i - 1].visible) continue;
        const double w = 0.5 * (widths_[f][id][i] * taper_[f][id][i] +
                                widths_[f][id][i - 1] * taper_[f][id][i - 1]);
        splat(plane, 0.5 * (samples[i].paper + samples[i - 1].paper),
              w * glm::length(samples[i].paper - samples[i - 1].paper));
      }
    }
    blur(plane);
    return plane;
  }

  template <class F>
  void corners(Vec2 paper, const F& f) const {
    const Vec2 q = (paper - raster_.origin) / raster_.pitch - 0.5;
    const auto x = static_cast<std::int32_t>(std::floor(q.x)),
               y = static_cast<std::int32_t>(std::floor(q.y));
    const Vec2 t = q - Vec2(x, y);
    for (std::int32_t dy = 0; dy < 2; ++dy) {
      for (std::int32_t dx = 0; dx < 2; ++dx) {
        const std::int32_t cx = std::clamp(x + dx, 0, raster_.nx - 1),
                           cy = std::clamp(y + dy, 0, raster_.ny - 1);
        f(raster_.index(cx, cy), (dx ? t.x : 1 - t.x) * (dy ? t.y : 1 - t.y));
      }
    }
  }

  void splat(Plane& plane, Vec2 paper, double area) const {
    const double share = area / (raster_.pitch * raster_.pitch);
    corners(paper, [&](std::size_t cell, double weight) {
      plane[cell] += static_cast<float>(share * weight);
    });
  }

  void correct(std::size_t f, const Plane& target, const Plane& ink) {
    const auto& strokes = families_[f].strokes;
    parallel_for(strokes.size(), 32, [&](std::size_t begin, std::size_t end) {
      for (std::size_t id = begin; id < end; ++id) {
        std::vector<double>& w = widths_[f][id];
        for (std::size_t i = 0; i < w.size(); ++i) {
          double want = 0, have = 0;
          corners(strokes[id].samples[i].paper, [&](std::size_t cell, double weight) {
            want += weight * target[cell];
            have += weight * ink[cell];
          });
          if (have <= 0) continue;
          const double by = std::clamp(want / have, 0.5, 2.0);
          w[i] *= picture_.dots() ? std::sqrt(by) : by;  // the area of a dot goes with its square
        }
        smooth(strokes[id], w);
        const std::vector<double>& guess = guess_[f][id];
        const double most = picture_.by_chance() ? kMostCorrection : kMostBeside;
        for (std::size_t i = 0; i < w.size(); ++i) {
          w[i] = limit(std::clamp(w[i], guess[i] / most, guess[i] * most), f,
                       strokes[id].samples[i].weight);
          w[i] = std::min(w[i], most_[f][id][i]);
        }
      }
    });
  }

  const Picture& picture_;
  const ViewRaster& raster_;
  const std::vector<Family>& families_;
  const RunContext& context_;
  std::int32_t radius_;
  Plane mask_, blurred_mask_;
  Widths widths_, guess_, most_, taper_;

 public:
  const Widths& tapers() const { return taper_; }
};

}  // namespace

Widths solve_widths(const Picture& picture, const ViewRaster& raster,
                    const std::vector<Family>& families, const RunContext& context) {
  WidthSolver solver(picture, raster, families, context);
  Widths widths = solver.solve();
  for (std::size_t f = 0; f < widths.size(); ++f) {
    for (std::size_t s = 0; s < widths[f].size(); ++s) {
      for (std::size_t i = 0; i < widths[f][s].size(); ++i)
        widths[f][s][i] *= solver.tapers()[f][s][i];
    }
  }
  return widths;
}

}  // namespace burin::detail
