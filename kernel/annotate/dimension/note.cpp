#include "leader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace burin::detail {
namespace {

using Mark = LeaderTarget::Mark;

/// Degrees from the horizontal at which leaders run: one along the sheet is taken for an edge.
constexpr std::array kSlopes{45.0, 30.0, 60.0, 18.0, 72.0};

/// Of the height of letters: from the elbow to a label that is not underlined.
constexpr double kShoulder = 0.8;
/// From the end of a line of text to the side of its label.
constexpr double kBesideText = 0.3;
/// And about a label what stays free.
constexpr double kAround = 0.3;

/// A label, to be laid with its left or right side at an elbow.
class LaidLabel {
 public:
  LaidLabel(const Dimension& note, const DimensionGround& ground)
      : label_(*note.label), style_(ground.style) {}

  void at_elbow(Vec2 elbow, double side, const SourceId& source, DimensionPlace& out) const {
    const double shoulder = label_.underlined ? label_.size.x : kShoulder * style_.height;
    add_leader_piece(elbow, elbow + Vec2(side * shoulder, 0), source, style_.line, out);
    const double to_label = label_.underlined ? 0 : shoulder;
    const double left = side > 0 ? elbow.x + to_label : elbow.x - to_label - label_.size.x;
    at({left, elbow.y - label_.shoulder}, out);
    if (!label_.ragged || side > 0) return;
    for (Text& text : out.layer.texts) {
      text.at.x = left + label_.size.x - kBesideText * style_.height;
      text.anchor = TextAnchor::End;
    }
  }

  /// By its lower left corner.
  void at(Vec2 low, DimensionPlace& out) const {
    Label label = label_;
    move(label, low);
    std::ranges::move(label.paths, std::back_inserter(out.layer.paths));
    std::ranges::move(label.areas, std::back_inserter(out.areas));
    std::ranges::move(label.texts, std::back_inserter(out.layer.texts));
    // What is written in lines needs more room above and below than a number.
    const Vec2 room = kAround * style_.height * Vec2(1);
    out.print.letters.push_back(
        quad_of(low - room, {1, 0}, label_.size.x + 2 * room.x, label_.size.y + 2 * room.y));
  }

 private:
  const Label& label_;
  const DimensionOptions& style_;
};

/// A tip on paper; `narrow`: how much less room it has than the best, from 0 to 1.
struct Tip {
  Vec2 at{0};
  double room = 0;
  double narrow = 0;
};

std::vector<Tip> tips_of(const LeaderTarget& target, const PaperView& view) {
  std::vector<Tip> tips;
  for (std::size_t i = 0; i < target.tips.size(); ++i) {
    const double room = i < target.rooms.size() ? target.rooms[i] : 0;
    tips.push_back({view.at(target.tips[i]), room * view.scale});
  }
  double most = 0;
  for (const Tip& tip : tips) most = std::max(most, tip.room);
  for (Tip& tip : tips) tip.narrow = most > 0 ? 1 - tip.room / most : 0;
  return tips;
}

Leader leader_to(const Tip& tip, Vec2 way, const LeaderTarget& target) {
  // Paper mm that a dot needs about it.
  constexpr double kDot = 1;
  const Mark found = tip.room >= kDot ? Mark::Dot : Mark::Arrow;
  return {tip.at, way, target.mark == Mark::Found ? found : target.mark, target.source};
}

/// What is worse about a tip than about one with room.
double cost_of(const Tip& tip) {
  constexpr double kWanted = 3, kNarrow = 6;  // paper mm, and mm a mm that lacks
  constexpr double kBeside = 20;              // mm for one beside the middle of what is seen
  return kNarrow * std::max(0.0, kWanted - tip.room) + kBeside * tip.narrow;
}

/// Leaders from an elbow to what else a note points at, each to its nearest tip.
void add_others(const Dimension& note, Vec2 elbow, std::size_t first, const DimensionGround& ground,
                DimensionPlace& out) {
  for (std::size_t k = first; k < note.targets.size(); ++k) {
    const LeaderTarget& target = note.targets[k];
    const std::vector<Tip> tips = tips_of(target, ground.view);
    if (tips.empty()) continue;
    const Tip& tip = *std::ranges::min_element(
        tips, {}, [&](const Tip& t) { return glm::distance(t.at, elbow) + cost_of(t); });
    const double length = glm::distance(tip.at, elbow);
    if (!(length > 0)) continue;
    add_leader_piece(tip.at, elbow, target.source, ground.style.line, out);
    add_mark(leader_to(tip, (elbow - tip.at) / length, target), ground.style, out);
    constexpr double kLong = 0.4;  // as of other leaders
    out.cost += kLong * length + cost_of(tip);
  }
}

/// Where a user wants it, with leaders from its nearer side.
DimensionPlace place_fixed(const Dimension& note, const DimensionGround& ground) {
  DimensionPlace out;
  const LaidLabel label(note, ground);
  const Vec2 low = *note.place, size = note.label->size;
  if (note.targets.empty() || note.targets.front().tips.empty()) {
    // A symbol stands on its shelf without a leader, too.
    if (note.label->underlined && !note.label->paths.empty()) {
      add_leader_piece(low, low + Vec2(size.x, 0), {}, ground.style.line, out);
    }
    label.at(low, out);
    return out;
  }
  const double tip = ground.view.at(note.targets.front().tips.front()).x;
  const double side = tip > low.x + 0.5 * size.x ? -1 : 1;
  const double gap = note.label->underlined ? 0 : kShoulder * ground.style.height;
  const Vec2 elbow(side > 0 ? low.x - gap : low.x + size.x + gap, low.y + note.label->shoulder);
  label.at_elbow(elbow, side, note.targets.front().source, out);
  add_others(note, elbow, 0, ground, out);
  return out;
}

}  // namespace

DimensionPlace place_note(const Dimension& note, const DimensionGround& ground) {
  if (note.place) return place_fixed(note, ground);
  DimensionPlace best;
  if (note.targets.empty()) return best;
  const LeaderTarget& target = note.targets.front();
  const LaidLabel label(note, ground);
  const LeaderEnd end{[&](Vec2 elbow, double side, DimensionPlace& out) {
    label.at_elbow(elbow, side, target.source, out);
    add_others(note, elbow, 1, ground, out);
  }};
  best.cost = std::numeric_limits<double>::infinity();
  std::vector<Tip> tips = tips_of(target, ground.view);
  // Those with the most room come first.
  constexpr std::size_t kFewTips = 2, kFewSlopes = 2;
  if (ground.many && tips.size() > kFewTips) tips.resize(kFewTips);
  const std::span slopes = std::span(kSlopes).first(ground.many ? kFewSlopes : kSlopes.size());
  for (const Tip& tip : tips) {
    for (const double slope : slopes) {
      for (const Vec2 quarter : {Vec2(1, 1), Vec2(-1, 1), Vec2(1, -1), Vec2(-1, -1)}) {
        const double a = glm::radians(slope);
        const Vec2 way = quarter * Vec2(std::cos(a), std::sin(a));
        DimensionPlace place =
            leader_place(leader_to(tip, way, target), end, ground, best.cost - cost_of(tip));
        place.cost += cost_of(tip);
        place.alone += cost_of(tip);
        if (place.cost < best.cost - 1e-9) best = std::move(place);
      }
    }
  }
  return best;
}

}  // namespace burin::detail
