#include "blocking.h"

#include <burin/base/parallel.h>
#include <burin/base/rng.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Rays across the box of a part, and where there are many parts, which are small in the picture.
constexpr std::uint64_t kGrid = 16, kCoarseGrid = 8;
constexpr std::size_t kMany = 500;
constexpr double kFit = 0.01;

/// Where one part lies on a ray.
struct Interval {
  std::uint32_t part = 0;
  double from = 0, to = 0;
};

/// Rays along an axis.
class Rays {
 public:
  Rays(const AxisView& view, const Shapes& shapes, const Occluder& occluder)
      : view_(view), occluder_(occluder) {
    for (const std::size_t part : shapes.parts) all_.add(view.boxes[part]);
  }

  void cast(Vec2 at, std::vector<Interval>& out) const {
    out.clear();
    const double start = all_.min.z - 0.01 * all_.diagonal();
    const Vec3 origin = at.x * view_.rows[0] + at.y * view_.rows[1] + start * view_.rows[2];
    (void)occluder_.occluded_by(origin, view_.axis(), 0, 2 * all_.diagonal(), [&](const Hit& hit) {
      const auto part = static_cast<std::uint32_t>(hit.where.part);
      const double t = start + hit.distance;
      const auto found = std::ranges::find(out, part, &Interval::part);
      if (found == out.end()) {
        out.push_back({part, t, t});
      } else {
        found->from = std::min(found->from, t);
        found->to = std::max(found->to, t);
      }
      return false;
    });
  }

  /// Whether a part lies on both sides of a place, along either direction across the axis.
  bool between(Vec3 place, std::uint32_t part) const {
    const Vec3 from = place.x * view_.rows[0] + place.y * view_.rows[1] + place.z * view_.rows[2];
    const auto meets = [&](Vec3 along) {
      return occluder_.occluded_by(from, along, 0, 2 * all_.diagonal(), [&](const Hit& hit) {
        return static_cast<std::uint32_t>(hit.where.part) == part;
      });
    };
    for (int k = 0; k < 2; ++k) {
      if (meets(view_.rows[k]) && meets(-view_.rows[k])) return true;
    }
    return false;
  }

 private:
  const AxisView& view_;
  const Occluder& occluder_;
  Box3 all_;
};

const Interval* of(const std::vector<Interval>& ray, std::uint32_t part) {
  const auto found = std::ranges::find(ray, part, &Interval::part);
  return found == ray.end() ? nullptr : &*found;
}

bool is_in_front(const std::vector<Interval>& ray, std::uint32_t a, std::uint32_t b, double eps) {
  const Interval *one = of(ray, a), *other = of(ray, b);
  return one && other && other->to - one->from > eps;
}

/// The other parts that one is related to, found on the rays over its own box.
class OfPart {
 public:
  OfPart(std::uint32_t part, const AxisView& view, const Shapes& shapes, const Rays& rays,
         std::optional<double> fit)
      : part_(part), view_(view), shapes_(shapes), rays_(rays), fit_(fit) {}

  std::vector<std::pair<std::uint32_t, std::uint32_t>> find() {
    const Box3& box = view_.boxes[part_];
    const Rng rng(1, part_);
    std::vector<Interval> ray;
    const std::uint64_t grid = shapes_.parts.size() > kMany ? kCoarseGrid : kGrid;
    const std::uint64_t across = grid + 2;
    for (std::uint64_t i = 0; i < across * across; ++i) {
      const std::uint64_t column = i % across, row = i / across;
      const Vec2 cell(static_cast<double>(column) - 1 + rng.uniform(2 * i),
                      static_cast<double>(row) - 1 + rng.uniform(2 * i + 1));
      const Vec2 at =
          Vec2(box.min) + cell / static_cast<double>(grid) * (Vec2(box.max) - Vec2(box.min));
      rays_.cast(at, ray);
      const bool hits = of(ray, part_) != nullptr;
      for (const Interval& other : ray) {
        if (other.part == part_) continue;
        enter(other);
        if (!hits) continue;
        look(at, ray, part_, other.part);
        look(at, ray, other.part, part_);
      }
    }
    for (Column& other : column_) enclose(other);
    std::ranges::sort(found_);
    std::ranges::sort(column_, {}, &Column::part);
    return std::move(found_);
  }

  std::vector<Column> column() { return std::move(column_); }

 private:
  /// What stands between walls of another part, as in a box or a channel, leaves it past their rim.
  void enclose(Column& other) const {
    constexpr int kSteps = 32;
    const Box3 &own = view_.boxes[part_], &box = view_.boxes[other.part];
    const auto rim = [&](double from, double to) {
      double last = from;
      for (int i = 1; i <= kSteps; ++i) {
        const double at = glm::mix(from, to, (i - 0.5) / kSteps);
        if (!rays_.between({Vec2(own.center()), at}, other.part)) break;
        last = glm::mix(from, to, static_cast<double>(i) / kSteps);
      }
      return last;
    };
    const double middle = own.center().z;
    if (box.max.z > middle) other.to = std::max(other.to, rim(middle, box.max.z));
    if (box.min.z < middle) other.from = std::min(other.from, rim(middle, box.min.z));
  }

  void enter(const Interval& other) {
    const auto known = std::ranges::find(column_, other.part, &Column::part);
    if (known == column_.end()) {
      column_.push_back({other.part, other.from, other.to});
    } else {
      known->from = std::min(known->from, other.from);
      known->to = std::max(known->to, other.to);
    }
  }

  void look(Vec2 at, const std::vector<Interval>& ray, std::uint32_t a, std::uint32_t b) {
    const double eps = fit_of(shapes_, a, b, fit_);
    if (!is_in_front(ray, a, b, eps)) return;
    const std::pair<std::uint32_t, std::uint32_t> pair(a, b);
    if (std::ranges::find(found_, pair) != found_.end()) return;
    for (int k = 0; k < 8; ++k) {
      const double angle = 0.25 * 3.14159265358979323846 * k;
      rays_.cast(at + eps * Vec2(std::cos(angle), std::sin(angle)), around_);
      if (!is_in_front(around_, a, b, eps)) return;
    }
    found_.push_back(pair);
  }

  std::uint32_t part_;
  const AxisView& view_;
  const Shapes& shapes_;
  const Rays& rays_;
  std::optional<double> fit_;
  std::vector<Interval> around_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found_;
  std::vector<Column> column_;
};

AxisView view_along(Vec3 axis, const Shapes& shapes, const RunContext& context) {
  AxisView view;
  view.rows = rows_along(axis, shapes.frame);
  view.boxes.resize(shapes.boxes.size());
  view.columns.resize(shapes.boxes.size());
  parallel_for(
      shapes.parts.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          view.boxes[shapes.parts[i]] = shapes.box_along(shapes.parts[i], view.rows);
        }
      },
      &context);
  return view;
}

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void gather(const std::vector<Pairs>& each, AxisView& view) {
  for (const Pairs& pairs : each) view.ahead.insert(view.ahead.end(), pairs.begin(), pairs.end());
  std::ranges::sort(view.ahead);
  view.ahead.erase(std::unique(view.ahead.begin(), view.ahead.end()), view.ahead.end());
}

}  // namespace

const Column* AxisView::column(std::size_t of, std::size_t part) const {
  const auto& all = columns[of];
  const auto found = std::ranges::lower_bound(all, part, {}, &Column::part);
  return found == all.end() || found->part != part ? nullptr : &*found;
}

double fit_of(const Shapes& shapes, std::size_t a, std::size_t b, std::optional<double> fit) {
  const double chords = shapes.proxies[a]->tolerance + shapes.proxies[b]->tolerance;
  // What rounding may add where faces lie on each other.
  const double least = std::max(chords, 1e-6 * shapes.diagonal);
  if (fit) return std::max(*fit, least);
  return kFit * std::min(shapes.least_extent(a), shapes.least_extent(b)) + least;
}

AxisView look_along(Vec3 axis, const Shapes& shapes, const Occluder& occluder,
                    std::optional<double> fit, const RunContext& context) {
  AxisView view = view_along(axis, shapes, context);
  const Rays rays(view, shapes, occluder);
  std::vector<Pairs> each(shapes.parts.size());
  parallel_for(
      shapes.parts.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          OfPart one(static_cast<std::uint32_t>(shapes.parts[i]), view, shapes, rays, fit);
          each[i] = one.find();
          view.columns[shapes.parts[i]] = one.column();
        }
      },
      &context);
  gather(each, view);
  return view;
}

AxisView boxes_along(Vec3 axis, const Shapes& shapes, std::optional<double> fit,
                     const RunContext& context) {
  AxisView view = view_along(axis, shapes, context);
  std::vector<std::size_t> order = shapes.parts;
  std::ranges::stable_sort(order, {}, [&](std::size_t p) { return view.boxes[p].min.x; });
  std::vector<Pairs> each(order.size()), beside(order.size());
  parallel_for(
      order.size(), 64,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Box3& one = view.boxes[order[i]];
          for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Box3& other = view.boxes[order[j]];
            const Vec2 beyond = Vec2(one.size()) / static_cast<double>(kGrid);
            if (other.min.x >= one.max.x + beyond.x) break;
            const double eps = fit_of(shapes, order[i], order[j], fit);
            const Vec2 shared =
                glm::min(Vec2(one.max), Vec2(other.max)) - glm::max(Vec2(one.min), Vec2(other.min));
            const Vec2 wider = glm::min(beyond, Vec2(other.size()) / static_cast<double>(kGrid));
            if (shared.x <= -wider.x || shared.y <= -wider.y) continue;
            auto a = static_cast<std::uint32_t>(order[i]), b = static_cast<std::uint32_t>(order[j]);
            beside[i].emplace_back(a, b);
            if (shared.x <= eps || shared.y <= eps) continue;
            const double by = other.center().z - one.center().z;
            if (by < 0 || (by == 0 && b < a)) std::swap(a, b);
            each[i].emplace_back(a, b);
          }
        }
      },
      &context);
  gather(each, view);
  for (const Pairs& pairs : beside) {
    for (const auto& [a, b] : pairs) {
      view.columns[a].push_back({b, view.boxes[b].min.z, view.boxes[b].max.z});
      view.columns[b].push_back({a, view.boxes[a].min.z, view.boxes[a].max.z});
    }
  }
  for (std::vector<Column>& columns : view.columns) {
    std::ranges::sort(columns, {}, &Column::part);
  }
  return view;
}

}  // namespace burin::detail
