#include <burin/base/part_ranks.h>
#include <burin/section/hatch_cuts.h>

#include "cut_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace burin {
namespace {

using detail::Area;
using detail::Clearance;

constexpr std::array kAngles = {45.0, 135.0, 30.0, 120.0, 60.0, 150.0};
/// Degrees within which an outline is taken for parallel to the hatching, and its share.
constexpr double kParallel = 15, kMostParallel = 0.5;
/// Paper mm: the distance of the lines, and what it is of the root of the area.
constexpr double kClosest = 0.7, kWidest = 3.5, kOfRoot = 0.12;
/// Paper mm: areas so near are neighbours, as a bolt and the hole around it.
constexpr double kNeighbour = 1;
/// Paper mm: narrower areas are filled, by lines so near each other, and stay away from the outline
/// of a filled neighbour.
constexpr double kNarrow = 1, kFilled = 0.1, kHalfGap = 0.35;

/// The share of the outline that runs within kParallel degrees of an angle.
double parallel_share(const Area& area, double angle) {
  double all = 0, parallel = 0;
  for (const auto& [a, b] : area.outline) {
    const Vec2 e = b - a;
    const double length = glm::length(e);
    const double degrees = std::atan2(e.y, e.x) * 180 / std::numbers::pi;
    const double off = std::abs(std::remainder(degrees - angle, 180.0));
    all += length;
    if (off < kParallel) parallel += length;
  }
  return all > 0 ? parallel / all : 0;
}

Vec3 direction(const Area& area, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return std::cos(angle) * area.u + std::sin(angle) * area.v;
}

/// Whether the lines of two planes of a part would lie on each other if these were folded together
/// about the line where they meet, each cut lying beyond the other's plane.
bool folds_onto(const Area& a, double degrees_a, const Area& b, double degrees_b) {
  const Vec3 fold = glm::cross(a.normal, b.normal);
  const auto slope = [&](const Area& area, const Area& other, double degrees) {
    const Vec3 line = direction(area, degrees);
    return glm::dot(line, fold) * glm::dot(line, reject(other.normal, area.normal));
  };
  return slope(a, b, degrees_a) * slope(b, a, degrees_b) > 0;
}

/// The angles in the order in which they are wanted: as in another plane of the part, then by rule.
std::vector<double> wanted_angles(const std::vector<Area>& areas, std::size_t i) {
  constexpr double kParallelPlanes = 1e-6;
  std::vector<double> wanted;
  for (std::size_t j = 0; j < i; ++j) {
    if (areas[j].part != areas[i].part) continue;
    if (std::abs(glm::dot(areas[j].normal, areas[i].normal)) > 1 - kParallelPlanes) {
      wanted = {areas[j].angle};
      break;
    }
    for (const double angle : {areas[j].angle, 180 - areas[j].angle}) {
      if (!wanted.empty() || !folds_onto(areas[j], areas[j].angle, areas[i], angle)) continue;
      wanted = {angle};
    }
  }
  wanted.insert(wanted.end(), kAngles.begin(), kAngles.end());
  return wanted;
}

void choose_angles(std::vector<Area>& areas, const Camera& camera, double magnified) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double near = kNeighbour * magnified / scale_of(areas[i], camera);
    const auto taken = [&](double angle) {
      for (std::size_t j = 0; j < i; ++j) {
        if (areas[j].angle == angle && neighbours(areas[i], areas[j], near)) return true;
      }
      return false;
    };
    const auto bad = [&](double angle) { return parallel_share(areas[i], angle) > kMostParallel; };
    const std::vector<double> angles = wanted_angles(areas, i);
    const auto best =
        std::ranges::find_if(angles, [&](double angle) { return !taken(angle) && !bad(angle); });
    const auto any = best != angles.end()
                         ? best
                         : std::ranges::find_if(angles, [&](double a) { return !taken(a); });
    areas[i].again = any == angles.end();
    areas[i].angle = areas[i].again ? kAngles[0] : *any;
  }
}

/// A part has one distance of lines in all its planes: that of its largest area.
void share_sizes(std::vector<Area>& areas) {
  std::map<std::int32_t, double> largest;
  for (const Area& area : areas) {
    largest[area.part] = std::max(largest[area.part], area.size);
  }
  for (Area& area : areas) area.size = largest[area.part];
}

/// Model mm: that of the view which is magnified, halved while it is wide on paper.
double spacing_of(const Area& area, const Camera& camera, double magnified) {
  const double scale = scale_of(area, camera), whole = scale / magnified;
  const double on_paper = std::clamp(kOfRoot * std::sqrt(area.size) * whole, kClosest, kWidest);
  double spacing = on_paper / whole;
  while (magnified > 1 && spacing * scale > kWidest) spacing /= 2;
  return (area.again ? 1.5 : 1) * spacing;
}

/// The angle of most of an outline, so that long lines fill what is narrow.
double main_angle(const Area& area) {
  constexpr std::size_t kBins = 36;
  std::array<double, kBins> length{};
  std::array<Vec2, kBins> sum{};
  for (const auto& [a, b] : area.outline) {
    Vec2 e = b - a;
    if (e.x < 0 || (e.x == 0 && e.y < 0)) e = -e;
    const double share = std::atan2(e.y, e.x) / std::numbers::pi + 0.5;  // 0 to 1
    const auto bin = std::min(static_cast<std::size_t>(share * kBins), kBins - 1);
    length[bin] += glm::length(e);
    sum[bin] += e;
  }
  const auto most = static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
  return std::atan2(sum[most].y, sum[most].x) * 180 / std::numbers::pi;
}

/// The areas that show instead of an area where both overlap.
class Owners {
 public:
  Owners(const std::vector<Area>& all, std::span<const double> ranks) : all_(all), ranks_(ranks) {}

  std::vector<const Area*> over(const Area& area) const {
    constexpr double kSamePlane = 1e-9;  // of the area
    std::vector<const Area*> out;
    for (const Area& other : all_) {
      if (!precedes(ranks_, other.part, area.part) || !other.box.overlaps(area.box)) continue;
      if (in_one_plane(area, other, kSamePlane * area.box.diagonal())) out.push_back(&other);
    }
    return out;
  }

 private:
  const std::vector<Area>& all_;
  std::span<const double> ranks_;
};

/// Areas too narrow for a hatching are black; between two of them it stays white.
void fill(const std::vector<Area>& narrow, const Owners& owners, const Camera& camera,
          std::vector<Curve3>& out, const RunContext& context) {
  for (std::size_t i = 0; i < narrow.size(); ++i) {
    context.check();
    const Area& area = narrow[i];
    const double scale = scale_of(area, camera);
    Clearance clear{.width = kHalfGap / scale, .areas = owners.over(area)};
    for (std::size_t j = 0; j < narrow.size(); ++j) {
      if (narrow[j].part == area.part || !neighbours(area, narrow[j], clear.width)) continue;
      clear.outline.insert(clear.outline.end(), narrow[j].outline.begin(), narrow[j].outline.end());
    }
    hatch_lines(area, main_angle(area), kFilled / scale, clear, out);
  }
}

}  // namespace

std::vector<Curve3> hatch_cuts(std::span<const ProxyMesh* const> proxies, const Camera& camera,
                               const RunContext& context, double magnified,
                               std::span<const double> ranks) {
  std::vector<Area> areas, narrow;
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    if (proxies[i]->cut_plane.empty()) continue;
    for (Area& area : detail::areas_of(*proxies[i], static_cast<std::int32_t>(i))) {
      if (!edge_on(area, camera)) areas.push_back(std::move(area));
    }
  }
  choose_angles(areas, camera, magnified);
  share_sizes(areas);
  const std::vector<Area> all = areas;
  const Owners owners(all, ranks);
  std::vector<Curve3> out;
  for (Area& area : areas) {
    context.check();
    for (Area& piece : take_narrow(area, kNarrow / scale_of(area, camera))) {
      narrow.push_back(std::move(piece));
    }
    hatch_lines(area, area.angle, spacing_of(area, camera, magnified), {.areas = owners.over(area)},
                out);
  }
  fill(narrow, owners, camera, out, context);
  return out;
}

}  // namespace burin
