#include "arrows.h"

#include <burin/assembly/select.h>
#include <burin/base/box_corners.h>
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>

#include "wanted_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace burin::detail {
namespace {

/// Of the diagonal of what is drawn: how wide an arrow is, how long, and how far off its part.
constexpr double kWidth = 0.025, kLength = 0.16, kOffPart = 0.02;
/// Of the width: that of the head, and how long the head is.
constexpr double kHeadWidth = 2.2, kHeadLength = 2;
/// A head is no longer than this share of its arrow.
constexpr double kMostHead = 0.6;

/// A place on the middle line of an arrow, and the unit way across it.
struct Station {
  Vec3 at{0}, across{0};
};

/// A strip with a head. The last station is where the head begins.
TriMesh arrow_mesh(const std::vector<Station>& shaft, Vec3 tip, double width) {
  TriMesh mesh;
  const auto pair = [&](const Station& s, double half) {
    mesh.positions.push_back(s.at - half * s.across);
    mesh.positions.push_back(s.at + half * s.across);
  };
  for (const Station& s : shaft) pair(s, 0.5 * width);
  for (std::uint32_t k = 0; k + 3 < mesh.positions.size(); k += 2) {
    mesh.triangles.push_back({k, k + 2, k + 1});
    mesh.triangles.push_back({k + 1, k + 2, k + 3});
  }
  const auto neck = static_cast<std::uint32_t>(mesh.positions.size()) - 2;
  pair(shaft.back(), 0.5 * kHeadWidth * width);
  mesh.positions.push_back(tip);
  const std::uint32_t left = neck + 2, right = neck + 3, end = neck + 4;
  mesh.triangles.push_back({left, end, neck});
  mesh.triangles.push_back({neck, end, neck + 1});
  mesh.triangles.push_back({neck + 1, end, right});
  return mesh;
}

/// Makes arrows for a view.
class ArrowMaker {
 public:
  ArrowMaker(const Scene& scene, const Illustration& illustration)
      : scene_(scene),
        drawn_(drawn_parts(scene, illustration.illustrate.part_styles)),
        diagonal_(drawn_bounds(scene, illustration.illustrate.part_styles).diagonal()) {
    const std::vector<WantedView> views = wanted_views(illustration);
    const ViewOptions& view = views.empty() ? illustration.view : views.front().view;
    const Mat3 to_model = glm::transpose(axes_of(view));
    up_ = to_model[1];
    to_viewer_ = to_model[2];
  }

  /// The way back of a step, beside the side of a part that is nearest to the viewer, where it
  /// hides least; nothing where there is no room for an arrow. `by`: how far its parts have come,
  /// model mm.
  std::optional<ArrowRow> way_back(const ExplodeStep& step, double by) const {
    const auto nearness = [&](std::size_t part) { return glm::dot(middle_of(part), to_viewer_); };
    const std::size_t part = *std::ranges::max_element(step.parts, {}, nearness);
    const Vec3 way = by < 0 ? step.along : -step.along;
    // An arrow has some way to go, and is no wider than long.
    constexpr double kOfWay = 0.6, kOfRoom = 0.8, kSlender = 4.5, kLeast = 0.03;
    const double width = kWidth * diagonal_;
    const Box3 box = scene_.parts[part].form->bounds(Mat3(1));
    const Vec3 front = front_of(box, way);
    const double off = kOffPart * diagonal_;
    const double room = kOfRoom * room_before(part, box.center() + front, way, width) - off;
    const double length = std::min({kLength * diagonal_, kOfWay * std::abs(by), room});
    if (!(length > kLeast * diagonal_)) return std::nullopt;
    ArrowRow row;
    row.from = box.center() + front + (0.5 * extent(box, way) + off) * way;
    row.to = *row.from + length * way;
    row.width = std::min(width, length / kSlender);
    return row;
  }

  TriMesh made(const ArrowRow& row) const {
    const double width = row.width.value_or(kWidth * diagonal_);
    if (row.select.empty()) return straight(*row.from, *row.to, width);
    const Box3 box = box_of(row);
    if (row.about) return about(box, glm::normalize(*row.about), glm::radians(row.degrees), width);
    const Vec3 way = glm::normalize(*row.along);
    const double off = 0.5 * extent(box, way) + kOffPart * diagonal_;
    const double length = row.length.value_or(kLength * diagonal_);
    const Vec3 begin = box.center() + (row.behind ? -off - length : off) * way;
    return straight(begin, begin + length * way, width);
  }

 private:
  Box3 box_of(const ArrowRow& row) const {
    Box3 box;
    try {
      for (const std::string& selector : row.select) {
        for (const std::size_t part : select(scene_, selector)) {
          if (drawn_[part]) box.add(scene_.parts[part].form->bounds(Mat3(1)));
        }
      }
    } catch (const UsageError& e) {
      throw UsageError(row.place + e.what());
    }
    if (box.empty()) {
      throw UsageError(
          fmt::format("{}arrow: part '{}' is not drawn", row.place, row.select.front()));
    }
    return box;
  }

  Vec3 middle_of(std::size_t part) const {
    return scene_.parts[part].form->bounds(Mat3(1)).center();
  }

  /// From the middle of a box to its edge or side that is turned to the viewer, across a way.
  Vec3 front_of(const Box3& box, Vec3 way) const {
    const Vec3 front = reject(to_viewer_, way);
    Vec3 out(0);
    constexpr double kSideways = 1e-6;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(front[k]) > kSideways) out[k] = std::copysign(0.5 * box.size()[k], front[k]);
    }
    return reject(out, way);
  }

  /// From a part to the box of the next one, beside a point of it on a way of that width, model mm.
  double room_before(std::size_t part, Vec3 beside, Vec3 way, double width) const {
    const Vec3 u = any_orthogonal(way), v = glm::cross(way, u);
    const Mat3 axes = glm::transpose(Mat3(u, v, way));
    const Box3 own = scene_.parts[part].form->bounds(axes);
    const Vec3 at = axes * beside;
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene_.parts.size(); ++i) {
      if (i == part || !drawn_[i]) continue;
      const Box3 other = scene_.parts[i].form->bounds(axes);
      const Vec3 off = glm::abs(other.center() - at) - 0.5 * other.size();
      if (std::max(off.x, off.y) > 0.5 * width || other.max.z < own.max.z) continue;
      room = std::min(room, std::max(other.min.z - own.max.z, 0.0));
    }
    return room;
  }

  /// How long a box is along a way.
  static double extent(const Box3& box, Vec3 way) { return glm::dot(box.size(), glm::abs(way)); }

  TriMesh straight(Vec3 from, Vec3 to, double width) const {
    const double length = glm::distance(from, to);
    const Vec3 way = (to - from) / length;
    // Turned to the viewer; one that runs at the viewer lies as it comes.
    constexpr double kAtViewer = 0.05;
    Vec3 across = glm::cross(to_viewer_, way);
    if (glm::length(across) < kAtViewer) across = glm::cross(up_, way);
    across = glm::normalize(across);
    const Vec3 neck = to - std::min(kHeadLength * width, kMostHead * length) * way;
    return arrow_mesh({{from, across}, {neck, across}}, to, width);
  }

  /// A ring about the axis where the view looks along it, else a band.
  TriMesh about(const Box3& box, Vec3 axis, double turn, double width) const {
    constexpr double kRing = 0.35;
    const double sense = turn < 0 ? -1 : 1, toward = glm::dot(axis, to_viewer_);
    const bool ring = std::abs(toward) > kRing;
    double radius = 0;
    for (const Vec3& corner : corners_of(box)) {
      radius = std::max(radius, glm::length(reject(corner - box.center(), axis)));
    }
    radius += kOffPart * diagonal_ + (ring ? kHeadWidth * 0.5 * width : 0);
    const double off = ring ? 0.5 * extent(box, axis) + kOffPart * diagonal_ : 0;
    const Vec3 middle = box.center() + std::copysign(off, toward) * axis;
    // Its middle is on the near side; seen straight along the axis at the top of the sheet.
    constexpr double kStraight = 0.05;
    Vec3 u = reject(to_viewer_, axis);
    if (glm::length(u) < kStraight) u = reject(up_, axis);
    u = glm::length(u) > 1e-6 ? glm::normalize(u) : any_orthogonal(axis);
    const Vec3 v = glm::cross(axis, u);
    const double head = std::min(kHeadLength * width / radius, kMostHead * std::abs(turn));
    const double shaft = std::abs(turn) - head;
    constexpr double kStep = 4;  // degrees
    const int steps = std::max(1, static_cast<int>(std::ceil(glm::degrees(shaft) / kStep)));
    const auto out_at = [&](double angle) {
      const double a = sense * (angle - 0.5 * std::abs(turn));
      return std::cos(a) * u + std::sin(a) * v;
    };
    std::vector<Station> stations;
    for (int k = 0; k <= steps; ++k) {
      const Vec3 out = out_at(shaft * k / steps);
      stations.push_back({middle + radius * out, ring ? out : axis});
    }
    return arrow_mesh(stations, middle + radius * out_at(std::abs(turn)), width);
  }

  const Scene& scene_;
  std::vector<bool> drawn_;
  double diagonal_;
  Vec3 up_{0}, to_viewer_{0};
};

/// How an arrow looks: its lines, and a flat colour.
PartStyle look_of(const ArrowRow& row, const Style& style) {
  PartStyle look{.hatched = false, .listed = false, .style = style};
  look.style->fill = {};
  look.style->fill.color = row.color.empty() ? "none" : row.color;
  look.style->fill.legend = false;
  look.style->fill.darkest = 1;  // one flat colour, lit or not
  look.style->fill.shadow = false;
  look.style->feature.centre_lines = false;
  return look;
}

}  // namespace

void add_arrows(Scene& scene, Illustration& illustration, const std::vector<ExplodeStep>& steps) {
  if (illustration.arrows.empty() && !illustration.step_arrows) return;
  if (scene.parts.empty()) return;
  const ArrowMaker maker(scene, illustration);
  std::vector<ArrowRow> rows = illustration.arrows;
  if (illustration.step_arrows) {
    std::int64_t without_room = 0;
    for (const ExplodeStep& step : steps) {
      const double by = step.by * illustration.explode.factor;
      if (step.parts.empty() || by == 0) continue;
      if (auto row = maker.way_back(step, by)) {
        rows.push_back(*std::move(row));
      } else {
        ++without_room;
      }
    }
    if (without_room > 0) {
      scene.diagnostics.add(Severity::Info, "arrows.no_room", without_room,
                            "steps have no room for an arrow between their parts");
    }
  }
  std::vector<PartStyle>& styles = illustration.illustrate.part_styles;
  styles.resize(scene.parts.size());
  std::vector<Part> made;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    made.push_back({fmt::format("arrow {}", i + 1), scene.parts.front().source,
                    std::make_shared<MeshForm>(maker.made(rows[i]))});
    styles.push_back(look_of(rows[i], illustration.style));
  }
  for (const Part& part : made) {
    scene.parts.push_back(part);
    for (const SectionView& view : illustration.section_views) view.scene->parts.push_back(part);
  }
}

}  // namespace burin::detail
