#include "missing_directions.h"

#include <burin/base/parallel.h>
#include <burin/base/short_list.h>
#include <burin/field/catalogue.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Places a side of the picture that are looked at.
constexpr int kSide = 120;
// Share of the places of a part that want ink from which a lack of direction is told: what less
// there is, poles and umbilics, nobody misses.
constexpr double kMissed = 0.1;
// Places from which a share means something.
constexpr int kFew = 8;

struct Count {
  int wanted = 0, directed = 0;
};

// What is seen of the picture, row by row.
Box2 seen_box(const HatchScene& hatched) {
  Box2 box;
  for (const Surface* s : hatched.surfaces) {
    for (const Vec3& p : s->proxy().mesh.positions) box.add(hatched.camera.to_paper(p));
  }
  const Vec2 sheet(hatched.camera.paper().width, hatched.camera.paper().height);
  box.min = glm::max(box.min, Vec2(0));
  box.max = glm::min(box.max, sheet);
  return box;
}

void count_row(const HatchScene& hatched, const Field& field, const Tone& tone, double tone_min,
               const Box2& box, std::size_t row, std::vector<Count>& counts) {
  for (int x = 0; x < kSide; ++x) {
    const Vec2 share((x + 0.5) / kSide, (static_cast<double>(row) + 0.5) / kSide);
    const auto hit = hatched.probe(box.min + share * box.size());
    if (!hit || !hit->hatched) continue;
    const auto part = static_cast<std::size_t>(hit->part);
    const Surface& surface = *hatched.surfaces[part];
    const SurfacePoint point = surface.lift(hit->point);
    const Frame frame = surface.frame(point);
    const Vec3 n = glm::dot(frame.normal, hatched.camera.to_viewer(point.position)) < 0
                       ? -frame.normal
                       : frame.normal;
    if (!(1 - tone(point.position, n) >= std::max(tone_min, 1e-6))) continue;
    ++counts[part].wanted;
    if (field.cross({hit->part, point, frame})) ++counts[part].directed;
  }
}

}  // namespace

std::optional<MissingDirections::Found> MissingDirections::look(const HatchScene& hatched,
                                                                const Field& field,
                                                                const Tone& tone,
                                                                const HatchStyle& hatch) {
  const std::string& name = hatch.field.name;
  if (field::find(name).missing.empty()) return std::nullopt;
  const Box2 box = seen_box(hatched);
  if (box.empty() || box.size().x <= 0 || box.size().y <= 0) return std::nullopt;
  std::vector<std::vector<Count>> rows(kSide, std::vector<Count>(hatched.surfaces.size()));
  const auto body = [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      count_row(hatched, field, tone, hatch.tone_min, box, y, rows[y]);
    }
  };
  parallel_for(rows.size(), 4, body, &hatched.context);
  Found found{name, {}, {}};
  for (std::size_t part = 0; part < hatched.surfaces.size(); ++part) {
    Count sum;
    for (const auto& row : rows) {
      sum.wanted += row[part].wanted;
      sum.directed += row[part].directed;
    }
    if (sum.wanted < kFew) continue;
    if (sum.directed == 0) {
      found.none.push_back(part);
    } else if (sum.wanted - sum.directed > kMissed * sum.wanted) {
      found.some.push_back(part);
    }
  }
  if (found.none.empty() && found.some.empty()) return std::nullopt;
  return found;
}

void MissingDirections::add(const Found& found) {
  if (std::ranges::find(found_, found) == found_.end()) found_.push_back(found);
}

std::string MissingDirections::names(const std::vector<std::size_t>& parts) const {
  constexpr std::size_t kNamed = 3;
  return short_list(parts, kNamed, [&](std::size_t part) {
    const std::string& name = scene_.parts[part].name;
    return name.empty() ? fmt::format("part {}", part) : fmt::format("'{}'", name);
  });
}

void MissingDirections::report(Diagnostics& diagnostics) const {
  for (const Found& f : found_) {
    const auto add = [&](const std::vector<std::size_t>& parts, const char* what) {
      if (parts.empty()) return;
      diagnostics.add(
          Severity::Warning, "strokes.no_direction", static_cast<std::int64_t>(parts.size()),
          fmt::format("{} {} strokes: {} (hatch.field={}; smoothed has directions everywhere)",
                      names(parts), what, field::find(f.field).missing, f.field));
    };
    add(f.none, f.none.size() == 1 ? "gets no" : "get no");
    add(f.some, f.some.size() == 1 ? "is in places without" : "are in places without");
  }
}

}  // namespace burin::detail
