#pragma once
/// What is wrong between the labels of a drawing: texts, circles and leaders that meet.

#include <burin/annotate/place.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/font.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

struct LabelFaults {
  std::size_t texts = 0, leaders = 0;
  /// Pairs of texts, or of circles of callouts, that share paper.
  std::size_t overlaps = 0;
  /// Circles of callouts over texts of something else.
  std::size_t circles = 0;
  /// Texts and circles that run off the sheet.
  std::size_t off_sheet = 0;
  /// Texts of something else that leaders of callouts pass over.
  std::size_t under_leaders = 0;
  /// Texts that other lines of annotations pass over.
  std::size_t under_lines = 0;
  /// Pairs of leaders of callouts that cross.
  std::size_t crossings = 0;
  /// Leaders of callouts that cross lines of notes, dimensions, sections or details.
  std::size_t over_lines = 0;
  /// One line each.
  std::vector<std::string> told;

  std::size_t labels() const { return overlaps + circles + off_sheet; }
  std::size_t lines() const { return under_leaders + under_lines + crossings + over_lines; }
};

class LabelJudge {
 public:
  explicit LabelJudge(const Drawing& drawing) : drawing_(drawing) {
    for (const Layer& layer : drawing.layers) {
      for (const Text& text : layer.texts) {
        if (const auto box = box_of(text)) texts_.push_back({&layer, &text, *box});
      }
      if (kAnnotations.contains(layer.name)) add_lines(layer);
    }
  }

  LabelFaults faults() {
    faults_ = {};
    faults_.texts = texts_.size(), faults_.leaders = leaders_.size();
    judge_texts();
    judge_circles();
    judge_leaders();
    judge_lines();
    return std::move(faults_);
  }

 private:
  using Quad = std::array<Vec2, 4>;
  struct Label {
    const Layer* layer;
    const Text* text;
    Quad box;
  };
  struct Line {
    const Layer* layer;
    const Path* path;
    Vec2 a, b;
  };
  struct Circle {
    Vec2 middle;
    double radius;
    int item;
  };
  inline static const std::set<std::string> kAnnotations{
      "callouts",      "dimensions",  "notes",      "details",   "section-plane",
      "section-marks", "title_block", "parts_list", "projection"};
  /// Paper mm that labels may touch by: rounding of files.
  static constexpr double kTouch = 0.01;

  /// Of the ink of the letters, turned as they are.
  static std::optional<Quad> box_of(const Text& text) {
    Text flat = text;
    flat.at = {}, flat.turn = 0;
    Box2 ink;
    for (const auto& ring : text_outlines(flat, 0.01)) {
      for (const Vec2& p : ring) ink.add(p);
    }
    if (ink.empty()) return std::nullopt;
    const Vec2 right = way_of(text), up(-right.y, right.x);
    const auto at = [&](double x, double y) { return text.at + x * right + y * up; };
    return Quad{at(ink.min.x, ink.min.y), at(ink.max.x, ink.min.y), at(ink.max.x, ink.max.y),
                at(ink.min.x, ink.max.y)};
  }

  void add_lines(const Layer& layer) {
    for (const Path& path : layer.paths) {
      const bool round = path.closed && path.points.size() > 8;
      if (layer.name == "callouts" && round) {
        Box2 box;
        for (const Vec2& p : path.points) box.add(p);
        circles_.push_back({box.center(), 0.5 * box.size().x, path.item});
        continue;
      }
      for (std::size_t i = path.closed ? 0 : 1; i < path.points.size(); ++i) {
        const Vec2 a = path.points[(i + path.points.size() - 1) % path.points.size()];
        if (a == path.points[i]) continue;
        (layer.name == "callouts" ? leaders_ : lines_)
            .push_back({&layer, &path, a, path.points[i]});
      }
    }
  }

  /// Paper mm by which two convex outlines overlap along the direction in which they do so least.
  static double depth(const Quad& a, const Quad& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const Quad* of : {&a, &b}) {
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 side = (*of)[(i + 1) % 4] - (*of)[i];
        const Vec2 way = Vec2(-side.y, side.x) / std::max(glm::length(side), 1e-9);
        const auto reach = [&](const Quad& q) {
          std::pair r(glm::dot(q[0], way), glm::dot(q[0], way));
          for (const Vec2& p : q) {
            r = {std::min(r.first, glm::dot(p, way)), std::max(r.second, glm::dot(p, way))};
          }
          return r;
        };
        const auto [low, high] = reach(a);
        const auto [from, to] = reach(b);
        least = std::min(least, std::min(high, to) - std::max(low, from));
      }
    }
    return least;
  }

  static bool meets(const Quad& box, Vec2 a, Vec2 b) {
    // The segment as an outline without a width; letters may touch it.
    const Vec2 way = (b - a) / glm::distance(a, b), across = 1e-6 * Vec2(-way.y, way.x);
    return depth(box, {a - across, b - across, b + across, a + across}) > 0 &&
           reaches_into(box, a, b);
  }
  /// Whether a segment is inside by more than touching.
  static bool reaches_into(const Quad& box, Vec2 a, Vec2 b) {
    double from = 0, to = 1;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 side = box[(i + 1) % 4] - box[i];
      const Vec2 in = Vec2(-side.y, side.x) / std::max(glm::length(side), 1e-9);
      const double u = glm::dot(a - box[i], in) - kTouch, v = glm::dot(b - box[i], in) - kTouch;
      if (u < 0 && v < 0) return false;
      if (u < 0) from = std::max(from, u / (u - v));
      if (v < 0) to = std::min(to, u / (u - v));
    }
    return from < to;
  }

  void judge_texts() {
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      for (const Vec2& p : texts_[i].box) {
        if (p.x >= 0 && p.y >= 0 && p.x <= drawing_.paper_width && p.y <= drawing_.paper_height) {
          continue;
        }
        tell(faults_.off_sheet, "{} is off the sheet", name(texts_[i]));
        break;
      }
      for (std::size_t k = i + 1; k < texts_.size(); ++k) {
        if (depth(texts_[i].box, texts_[k].box) <= kTouch) continue;
        tell(faults_.overlaps, "{} overlaps {}", name(texts_[i]), name(texts_[k]));
      }
    }
  }

  void judge_circles() {
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      const Circle& one = circles_[i];
      const Vec2 low = one.middle - Vec2(one.radius), high = one.middle + Vec2(one.radius);
      if (low.x < 0 || low.y < 0 || high.x > drawing_.paper_width ||
          high.y > drawing_.paper_height) {
        tell(faults_.off_sheet, "the circle of {} is off the sheet", one.item);
      }
      for (std::size_t k = i + 1; k < circles_.size(); ++k) {
        const Circle& other = circles_[k];
        if (glm::distance(one.middle, other.middle) > one.radius + other.radius - kTouch) continue;
        tell(faults_.overlaps, "the circle of {} overlaps that of {}", one.item, other.item);
      }
      for (const Label& label : texts_) {
        const bool own = label.layer->name == "callouts" && label.text->item == one.item;
        if (own || distance(label.box, one.middle) > one.radius - kTouch) continue;
        tell(faults_.circles, "the circle of {} lies on {}", one.item, name(label));
      }
    }
  }

  /// 0 inside.
  static double distance(const Quad& box, Vec2 p) {
    double least = std::numeric_limits<double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 a = box[i], side = box[(i + 1) % 4] - a;
      const double square = std::max(glm::dot(side, side), 1e-12);
      const double t = std::clamp(glm::dot(p - a, side) / square, 0.0, 1.0);
      least = std::min(least, glm::distance(p, a + t * side));
      inside = inside && side.x * (p.y - a.y) - side.y * (p.x - a.x) >= 0;
    }
    return inside ? 0 : least;
  }

  void judge_leaders() {
    for (std::size_t i = 0; i < leaders_.size(); ++i) {
      const Line& one = leaders_[i];
      for (const Label& label : texts_) {
        if (label.layer->name == "callouts" && label.text->item == one.path->item) continue;
        if (!meets(label.box, one.a, one.b)) continue;
        tell(faults_.under_leaders, "the leader of {} passes over {}", one.path->item, name(label));
      }
      for (std::size_t k = i + 1; k < leaders_.size(); ++k) {
        const Line& other = leaders_[k];
        if (one.path->item == other.path->item) continue;
        if (!segments_cross(one.a, one.b, other.a, other.b)) continue;
        tell(faults_.crossings, "the leader of {} crosses that of {}", one.path->item,
             other.path->item);
      }
      std::set<const Path*> crossed;
      for (const Line& line : lines_) {
        if (!segments_cross(one.a, one.b, line.a, line.b) || !crossed.insert(line.path).second) {
          continue;
        }
        tell(faults_.over_lines, "the leader of {} crosses a line of {} at {:.1f},{:.1f}",
             one.path->item, line.layer->name, line.a.x, line.a.y);
      }
    }
  }

  void judge_lines() {
    for (const Label& label : texts_) {
      std::set<const Path*> met;
      for (const Line& line : lines_) {
        if (!meets(label.box, line.a, line.b) || !met.insert(line.path).second) continue;
        tell(faults_.under_lines, "a line of {} passes over {}", line.layer->name, name(label));
      }
    }
  }

  static std::string name(const Label& label) {
    return fmt::format("'{}' of {} at {:.1f},{:.1f}", label.text->text, label.layer->name,
                       label.text->at.x, label.text->at.y);
  }
  template <class... T>
  void tell(std::size_t& count, fmt::format_string<T...> format, T&&... what) {
    ++count;
    faults_.told.push_back(fmt::format(format, std::forward<T>(what)...));
  }

  const Drawing& drawing_;
  std::vector<Label> texts_;
  std::vector<Line> leaders_, lines_;
  std::vector<Circle> circles_;
  LabelFaults faults_;
};

inline LabelFaults label_faults(const Drawing& drawing) { return LabelJudge(drawing).faults(); }

}  // namespace burin::test
