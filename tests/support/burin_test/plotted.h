#pragma once
/// HPGL and G-code read back as the lines that a machine would draw, by a reader of its own, and
/// how far lines are from each other.

#include <burin/base/vec.h>
#include <burin/drawing/drawing.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

/// What a machine does with the pen down, mm.
struct PlottedLine {
  int pen = 0;
  std::vector<Vec2> points;
};

struct Plotted {
  std::vector<PlottedLine> lines;
  /// mm with the pen down and up; the way home after the last line is no travel.
  double drawn = 0, travel = 0;
  int arcs = 0;
};

/// A machine with a pen.
class Plotter {
 public:
  void take(int pen) {
    if (down_) throw std::runtime_error("the pen is changed while it is down");
    pen_ = pen;
  }
  void up() { down_ = false; }
  void down() {
    if (!down_) out_.lines.push_back({pen_, {at_}});
    if (!down_) out_.travel += waiting_;
    down_ = true;
    waiting_ = 0;
  }
  void go(Vec2 to) {
    (down_ ? out_.drawn : waiting_) += glm::distance(at_, to);
    at_ = to;
    if (down_) out_.lines.back().points.push_back(to);
  }
  /// Along a circle, in chords of so many radians.
  void arc(Vec2 center, double turn, double chord) {
    const Vec2 v = at_ - center;
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / chord - 1e-9)));
    for (int k = 1; k <= n; ++k) {
      const double c = std::cos(turn * k / n), s = std::sin(turn * k / n);
      go(center + Vec2(c * v.x - s * v.y, s * v.x + c * v.y));
    }
    ++out_.arcs;
  }
  Vec2 at() const { return at_; }
  Plotted done() {
    if (down_) throw std::runtime_error("the pen stays on the paper");
    return std::move(out_);
  }

 private:
  Plotted out_;
  Vec2 at_{0};
  int pen_ = 0;
  bool down_ = false;
  double waiting_ = 0;
};

/// IN, SP, VS, PU, PD, PA and AA, whole units of 0.025 mm; throws on anything else.
inline Plotted read_hpgl(const std::string& text) {
  Plotter plotter;
  std::istringstream in(text);
  std::string one;
  bool begun = false;
  while (std::getline(in, one, ';')) {
    one.erase(std::remove(one.begin(), one.end(), '\n'), one.end());
    if (one.empty()) continue;
    const std::string word = one.substr(0, 2);
    std::vector<double> numbers;
    std::istringstream rest(one.substr(2));
    for (std::string number; std::getline(rest, number, ',');) {
      numbers.push_back(std::stod(number));
      const bool angle = word == "AA" && numbers.size() == 3;
      if (word != "VS" && !angle && numbers.back() != std::round(numbers.back())) {
        throw std::runtime_error("not whole: " + one);
      }
    }
    if (word != "IN" && !begun) throw std::runtime_error("no IN at first");
    begun = true;
    if (word == "IN" || word == "VS") continue;
    if (word == "SP") {
      plotter.take(numbers.empty() ? 0 : static_cast<int>(numbers[0]));
      continue;
    }
    if (word == "AA") {
      if (numbers.size() != 4 || numbers[3] < 1) throw std::runtime_error("half an arc: " + one);
      constexpr double kRadians = 3.14159265358979323846 / 180;
      plotter.arc(Vec2(numbers[0], numbers[1]) / 40.0, numbers[2] * kRadians,
                  numbers[3] * kRadians);
      continue;
    }
    if (word == "PU") plotter.up();
    if (word == "PD") plotter.down();
    if (word != "PU" && word != "PD" && word != "PA") throw std::runtime_error("unknown: " + one);
    if (numbers.size() % 2 != 0) throw std::runtime_error("half a place: " + one);
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
      plotter.go(Vec2(numbers[i], numbers[i + 1]) / 40.0);
    }
  }
  return plotter.done();
}

/// Millimetres and absolute places; the pen is down after M3, or where Z is no more than `z`.
inline Plotted read_gcode(const std::string& text, double z = 0) {
  Plotter plotter;
  std::istringstream in(text);
  Vec2 at(0);
  int pen = 1;
  bool metric = false, absolute = false, plane = false, ended = false;
  plotter.take(pen);
  for (std::string line; std::getline(in, line);) {
    if (ended) throw std::runtime_error("after the end: " + line);
    line = line.substr(0, line.find(';'));
    std::istringstream words(line);
    std::map<char, double> values;
    for (std::string word; words >> word;) {
      if (word == "G21") {
        metric = true;
      } else if (word == "G90") {
        absolute = true;
      } else if (word == "G17") {
        plane = true;
      } else {
        values[word[0]] = std::stod(word.substr(1));
      }
    }
    if (values.contains('M')) {
      const int code = static_cast<int>(values['M']);
      if (code == 3) plotter.down();
      if (code == 5) plotter.up();
      if (code == 0) plotter.take(++pen);
      ended = code == 2;
      continue;
    }
    if (!values.contains('G')) continue;
    if (!metric || !absolute) throw std::runtime_error("moves before G21 and G90");
    if (values['G'] == 2 || values['G'] == 3) {
      const Vec2 to(values.at('X'), values.at('Y'));
      const Vec2 center = at + Vec2(values.at('I'), values.at('J'));
      const Vec2 a = at - center, b = to - center;
      // Firmware stops where the two radii differ.
      if (!plane || std::abs(glm::length(a) - glm::length(b)) > 0.004 || at == to) {
        throw std::runtime_error("no arc: " + line);
      }
      constexpr double kTurn = 2 * 3.14159265358979323846;
      double turn = std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
      if (values['G'] == 3 && turn < 0) turn += kTurn;
      if (values['G'] == 2 && turn > 0) turn -= kTurn;
      plotter.arc(center, turn, 0.02);
      plotter.go(to);
      at = to;
      continue;
    }
    if (values['G'] > 1) continue;
    if (values.contains('Z')) values['Z'] <= z ? plotter.down() : plotter.up();
    if (!values.contains('X') && !values.contains('Y')) continue;
    if (values.contains('X')) at.x = values['X'];
    if (values.contains('Y')) at.y = values['Y'];
    plotter.go(at);
  }
  if (!ended) throw std::runtime_error("no end");
  return plotter.done();
}

using Lines = std::vector<std::vector<Vec2>>;

inline Lines lines_of(const Plotted& plotted) {
  Lines lines;
  for (const PlottedLine& line : plotted.lines) lines.push_back(line.points);
  return lines;
}

/// The visible lines of a drawing; closed ones repeat their first point.
inline Lines visible_lines(const Drawing& drawing) {
  Lines lines;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible && !path.in_full) continue;
      lines.push_back(path.points);
      if (path.closed) lines.back().push_back(path.points.front());
    }
  }
  return lines;
}

inline double length_of(const Lines& lines) {
  double length = 0;
  for (const auto& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  }
  return length;
}

/// Travel between lines in the order in which they stand.
inline double travel_of(const Lines& lines) {
  double travel = 0;
  Vec2 at(0);
  for (const auto& line : lines) {
    travel += glm::distance(at, line.front());
    at = line.back();
  }
  return travel;
}

/// Segments by the squares of 1 mm that they touch.
class Segments {
 public:
  explicit Segments(const Lines& lines) {
    for (const auto& line : lines) {
      for (std::size_t i = 0; i < std::max<std::size_t>(1, line.size() - 1); ++i) {
        add(line[i], line[std::min(i + 1, line.size() - 1)]);
      }
    }
  }
  /// mm from a place to the nearest segment, as far as 0.5 mm; else infinite.
  double distance(Vec2 p) const {
    double best = std::numeric_limits<double>::infinity();
    const auto found = cells_.find(cell(p));
    if (found == cells_.end()) return best;
    for (const auto& [a, b] : found->second) {
      const Vec2 d = b - a;
      const double dd = glm::dot(d, d);
      const double t = dd > 0 ? std::clamp(glm::dot(p - a, d) / dd, 0.0, 1.0) : 0;
      best = std::min(best, glm::distance(p, a + t * d));
    }
    return best;
  }
  /// The largest distance of points on lines, every 0.1 mm.
  double farthest(const Lines& lines) const {
    double worst = 0;
    for (const auto& line : lines) {
      worst = std::max(worst, distance(line.front()));
      for (std::size_t i = 1; i < line.size(); ++i) {
        const int n = static_cast<int>(std::ceil(glm::distance(line[i - 1], line[i]) / 0.1)) + 1;
        for (int k = 1; k <= n; ++k) {
          worst = std::max(worst, distance(glm::mix(line[i - 1], line[i], double(k) / n)));
        }
      }
    }
    return worst;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  static Cell cell(Vec2 p) { return {std::llround(p.x), std::llround(p.y)}; }

  // A segment stands in every square that it comes within half a square of.
  void add(Vec2 a, Vec2 b) {
    const int n = static_cast<int>(std::ceil(glm::distance(a, b) / 0.25)) + 1;
    for (int k = 0; k <= n; ++k) {
      const auto [x, y] = cell(glm::mix(a, b, double(k) / n));
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
          auto& here = cells_[{x + dx, y + dy}];
          if (here.empty() || here.back() != std::pair(a, b)) here.emplace_back(a, b);
        }
      }
    }
  }

  std::map<Cell, std::vector<std::pair<Vec2, Vec2>>> cells_;
};

}  // namespace burin::test
