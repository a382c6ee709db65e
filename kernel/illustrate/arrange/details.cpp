#include "details.h"

#include <burin/annotate/letters.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/camera/view_grid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin::detail {
namespace {

/// Of the shorter side of the frame: diameters of details whose scale is found.
constexpr double kLargest = 0.3;
/// Of the projected diagonal of parts: what a detail shows about them.
constexpr double kAround = 1.15;
/// Paper mm between details, and between them and the drawing.
constexpr double kGap = 8;
/// Of the frame's area: what the drawing keeps.
constexpr double kLeast = 0.25;
constexpr std::size_t kMostDetails = 23;

struct Round {
  Vec3 at{0};
  double radius = 0;
  std::vector<std::size_t> parts = {};
};

/// What a detail of parts shows: the circle about their box in the view.
Round about_parts(const Scene& scene, const DetailView& detail, const Mat3& axes) {
  Box3 box;
  std::vector<std::size_t> parts;
  try {
    for (const std::string& selector : detail.select) {
      for (const std::size_t part : select(scene, selector)) {
        box.add(scene.parts[part].form->bounds(axes));
        parts.push_back(part);
      }
    }
  } catch (const UsageError& e) {
    throw UsageError(detail.place + e.what());
  }
  const Vec3 size = box.size();
  const double radius = 0.5 * kAround * glm::length(Vec2(size.x, size.y));
  if (!(radius > 0)) {
    throw UsageError(fmt::format("{}detail of '{}': nothing of it is left to be drawn",
                                 detail.place, detail.select.front()));
  }
  return {glm::transpose(axes) * box.center(), radius, std::move(parts)};
}

std::string letter_of(const DetailView& detail, std::vector<std::string>& taken) {
  std::string letter = detail.letter;
  if (letter.empty()) {
    letter = next_letter(taken);
  } else if (std::ranges::find(taken, letter) != taken.end()) {
    throw UsageError(fmt::format("{}two details have the letter '{}'", detail.place, letter));
  }
  taken.push_back(letter);
  return letter;
}

struct Strip {
  Box2 rest;
  std::vector<Vec2> centers;

  double area() const { return rest.size().x * rest.size().y; }
};

/// A row or column of them: from where to where across, and their middles along it.
struct Lane {
  double across = 0, width = 0;
  std::vector<double> middles;
};

/// Discs with captions above them, in columns at the right or rows at the bottom; nothing where
/// one is longer than the side.
std::optional<Strip> strip_at(bool right, const std::vector<double>& diameters, double caption,
                              const Box2& frame) {
  const double along = right ? frame.size().y : frame.size().x;
  std::vector<Lane> lanes(1);
  double at = 0;
  for (const double d : diameters) {
    const double length = right ? d + caption : d, width = right ? d : d + caption;
    if (length > along) return std::nullopt;
    if (at > 0 && at + length > along) {
      lanes.push_back({lanes.back().across + lanes.back().width + kGap, 0, {}});
      at = 0;
    }
    lanes.back().middles.push_back(at + 0.5 * length);
    lanes.back().width = std::max(lanes.back().width, width);
    at += length + kGap;
  }
  Strip strip{frame, {}};
  const double taken = lanes.back().across + lanes.back().width + kGap;
  (right ? strip.rest.max.x : strip.rest.min.y) += right ? -taken : taken;
  for (const Lane& lane : lanes) {
    const double across = lane.across + 0.5 * lane.width;
    for (const double middle : lane.middles) {
      const Vec2 cell = right ? Vec2(frame.max.x - across, frame.max.y - middle)
                              : Vec2(frame.min.x + middle, frame.min.y + across);
      strip.centers.push_back(cell - Vec2(0, 0.5 * caption));
    }
  }
  return strip;
}

/// Above the parts list, clear of the legend.
std::optional<Strip> strip_above_list(const std::vector<double>& diameters, double caption,
                                      const DetailRoom& room) {
  // A list that leaves what is beside it leaves what is above it, too.
  const Box2 &frame = room.frame, &whole = room.whole;
  if (!room.list || frame.max.x >= whole.max.x) return std::nullopt;
  Box2 column = whole;
  column.min.y = room.list->max.y + kGap;
  auto strip = strip_at(true, diameters, caption, column);
  if (!strip) return std::nullopt;
  const Box2 needed{{strip->rest.max.x, room.list->max.y}, whole.max};
  if (room.legend && room.legend->overlaps(needed)) return std::nullopt;
  strip->rest = {frame.min, {std::min(frame.max.x, strip->rest.max.x), frame.max.y}};
  return strip;
}

}  // namespace

std::vector<PlannedDetail> plan_details(const Scene& scene, const std::vector<DetailView>& details,
                                        const Mat3& axes, double shorter_side,
                                        std::vector<std::string> taken) {
  if (details.size() > kMostDetails) {
    throw UsageError("more than 23 details, for which there are no letters");
  }
  for (const DetailView& detail : details) {
    if (!detail.letter.empty()) taken.push_back(detail.letter);
  }
  std::vector<PlannedDetail> planned;
  std::vector<std::string> given;
  for (const DetailView& detail : details) {
    Round round{detail.at, detail.radius};
    if (!detail.select.empty()) {
      round = about_parts(scene, detail, axes);
      if (detail.radius > 0) round.radius = detail.radius;
    }
    PlannedDetail one{round.at, round.radius, 0, {}, detail.place, std::move(round.parts)};
    one.scale = detail.scale.value_or(standard_scale(kLargest * shorter_side / (2 * round.radius)));
    one.letter = letter_of(detail, detail.letter.empty() ? taken : given);
    planned.push_back(std::move(one));
  }
  return planned;
}

Box2 place_details(std::vector<PlannedDetail>& details, double caption, const DetailRoom& room) {
  const Box2& frame = room.frame;
  if (details.empty()) return frame;
  std::vector<double> diameters;
  for (const PlannedDetail& detail : details) diameters.push_back(2 * detail.radius * detail.scale);
  std::optional<Strip> best;
  const auto look = [&](std::optional<Strip> strip) {
    if (!strip) return;
    const Vec2 left = strip->rest.size();
    const double least = kLeast * frame.size().x * frame.size().y;
    if (!(left.x > 0 && left.y > 0) || strip->area() < least) return;
    if (!best || strip->area() > best->area()) best = std::move(strip);
  };
  look(strip_at(true, diameters, caption, frame));
  look(strip_at(false, diameters, caption, frame));
  look(strip_above_list(diameters, caption, room));
  if (!best) {
    throw UsageError(fmt::format(
        "{}details of up to {:.0f} mm have no room beside the drawing on a sheet of which "
        "{:.0f} x {:.0f} mm are free: give them a smaller scale, or a larger `paper`",
        details.front().place, *std::ranges::max_element(diameters), frame.size().x,
        frame.size().y));
  }
  for (std::size_t i = 0; i < details.size(); ++i) details[i].center = best->centers[i];
  return best->rest;
}

}  // namespace burin::detail
