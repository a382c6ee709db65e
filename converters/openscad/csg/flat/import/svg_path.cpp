#include "fragments.h"
#include "svg_shapes.h"
#include "text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace burin::csg {
namespace {

constexpr int kCurvePieces = 20;

double degrees(Vec2 v) { return std::atan2(v.y, v.x) * 180 / M_PI; }

/// The numbers and letters of path data; the flags of arcs may stand without a gap.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  std::optional<char> letter() {
    skip();
    if (text_.empty() || !is_letter(text_[0])) return std::nullopt;
    const char c = text_[0];
    text_.remove_prefix(1);
    return c;
  }
  std::optional<double> number() {
    skip();
    double value = 0;
    const char* end = scan_double(text_.data(), text_.data() + text_.size(), value);
    if (!end || is_letter(text_.empty() ? 'x' : text_[0])) return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }
  std::optional<double> flag() {
    skip();
    if (text_.empty() || (text_[0] != '0' && text_[0] != '1')) return number();
    const double value = text_[0] - '0';
    text_.remove_prefix(1);
    return value;
  }
  /// What is neither is left out.
  bool at_end() {
    skip();
    return text_.empty();
  }
  void drop() { text_.remove_prefix(1); }

 private:
  void skip() {
    while (!text_.empty() && (is_blank(text_[0]) || is_line_end(text_[0]) || text_[0] == ','))
      text_.remove_prefix(1);
  }
  std::string_view text_;
};

class PathReader {
 public:
  PathReader(std::string_view data, const SvgStroke& stroke) : words_(data), stroke_(stroke) {}

  Region read() {
    paths_.emplace_back();
    char command = 0;
    while (!words_.at_end()) {
      if (const auto letter = words_.letter()) {
        command = *letter;
        if (lowered(command) == 'z') close();
        continue;
      }
      std::array<double, 7> v{};
      if (!values(command, v)) {
        words_.drop();
        continue;
      }
      draw(command, v);
      // More pairs behind a move are lines.
      if (lowered(command) == 'm') command = command == 'm' ? 'l' : 'L';
    }
    while (!paths_.empty() && paths_.back().points.empty()) paths_.pop_back();
    if (!closed_ && !paths_.empty()) stroke_if_open();
    return {std::move(paths_), std::move(arcs_)};
  }

 private:
  static std::size_t count_of(char command) {
    switch (lowered(command)) {
      case 'a':
        return 7;
      case 'c':
        return 6;
      case 's':
      case 'q':
        return 4;
      case 'm':
      case 'l':
      case 't':
        return 2;
      case 'h':
      case 'v':
        return 1;
      default:
        return 0;
    }
  }
  bool values(char command, std::array<double, 7>& v) {
    const std::size_t count = count_of(command);
    const bool arc = lowered(command) == 'a';
    for (std::size_t i = 0; i < count; ++i) {
      const auto value = arc && (i == 3 || i == 4) ? words_.flag() : words_.number();
      if (!value) return false;
      v[i] = *value;
    }
    return count > 0;
  }

  std::vector<Vec2>& path() { return paths_.back().points; }
  /// `arc`: what the edge that ends here stands for.
  void add(Vec2 p, std::int32_t arc = -1) {
    Outline& outline = paths_.back();
    if (!outline.arc.empty()) outline.arc.back() = arc;
    outline.points.push_back(p);
    outline.arc.push_back(-1);
  }
  static bool open(const std::vector<Vec2>& path) {
    constexpr double kGap = 0.1;  // user units; OpenSCAD's
    return glm::length(path.front() - path.back()) > kGap;
  }
  void stroke_if_open() {
    if (!open(path())) return;
    const std::vector<Vec2> line = std::move(path());
    paths_.pop_back();
    for (Outline& o : stroked(line, stroke_)) paths_.push_back(std::move(o));
  }
  void close() {
    if (!path().empty()) at_ = path().front();
    paths_.emplace_back();
    closed_ = true;
    cubic_ = square_ = false;
  }
  void move(Vec2 to) {
    if (!path().empty()) {
      stroke_if_open();
      paths_.emplace_back();
    }
    add(to);
  }

  void draw(char command, const std::array<double, 7>& v) {
    const Vec2 from = at_, base = command >= 'a' ? at_ : Vec2(0);
    const auto p = [&](std::size_t i) { return base + Vec2(v[i], v[i + 1]); };
    bool cubic = false, square = false;
    switch (lowered(command)) {
      case 'm':
        move(at_ = p(0));
        break;
      case 'l':
        add(at_ = p(0));
        break;
      case 'h':
        at_.x = base.x + v[0];
        add(at_);
        break;
      case 'v':
        at_.y = base.y + v[0];
        add(at_);
        break;
      case 'c':
        curve(from, p(0), control_ = p(2), at_ = p(4));
        cubic = true;
        break;
      case 's': {
        const Vec2 first = cubic_ ? 2.0 * from - control_ : from;
        curve(from, first, control_ = p(0), at_ = p(2));
        cubic = true;
        break;
      }
      case 'q':
        curve(from, control_ = p(0), at_ = p(2));
        square = true;
        break;
      case 't':
        control_ = square_ ? 2.0 * from - control_ : from;
        curve(from, control_, at_ = p(0));
        square = true;
        break;
      case 'a':
        at_ = p(5);
        arc(from, glm::abs(Vec2(v[0], v[1])), v[2], v[3] > 0.5, v[4] > 0.5);
        break;
      default:
        break;
    }
    cubic_ = cubic;
    square_ = square;
  }

  void curve(Vec2 a, Vec2 b, Vec2 c) {
    for (int i = 1; i <= kCurvePieces; ++i) {
      const double t = static_cast<double>(i) / kCurvePieces, s = 1 - t;
      add(s * s * a + 2 * s * t * b + t * t * c);
    }
  }
  void curve(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    for (int i = 1; i <= kCurvePieces; ++i) {
      const double t = static_cast<double>(i) / kCurvePieces, s = 1 - t;
      add(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
    }
  }

  /// From `from` to the present point, by the equations F.6.5 of SVG 1.1.
  void arc(Vec2 from, Vec2 r, double turned, bool large, bool sweep) {
    if (!(r.x > 0 && r.y > 0) || from == at_) {
      add(at_);
      return;
    }
    const Vec2 u = direction(turned), half = 0.5 * (from - at_);
    const Vec2 p(u.x * half.x + u.y * half.y, -u.y * half.x + u.x * half.y);
    r *= std::max(1.0, glm::length(p / r));
    const double over = r.x * r.x * p.y * p.y + r.y * r.y * p.x * p.x;
    const double under = std::max(0.0, r.x * r.x * r.y * r.y - over);
    const double t = std::sqrt(under / over) * (large == sweep ? -1 : 1);
    const Vec2 c(t * r.x * p.y / r.y, -t * r.y * p.x / r.x);
    const auto out = [&](Vec2 q) { return Vec2(u.x * q.x - u.y * q.y, u.y * q.x + u.x * q.y); };
    const Vec2 middle = out(c) + 0.5 * (from + at_);
    const Vec2 first = (p - c) / r, last = (-p - c) / r;
    double way = degrees(last) - degrees(first);
    if (way < 0) way += 360;
    if (!sweep) way -= 360;
    const int steps = static_cast<int>(std::abs(way) * 10 / 180 + 4);
    std::int32_t round = -1;
    if (r.x == r.y) {
      round = static_cast<std::int32_t>(arcs_.size());
      arcs_.push_back({middle, r.x, std::abs(way) * M_PI / 180 / steps});
    }
    for (int i = 0; i <= steps; ++i) {
      add(middle + out(r * direction(degrees(first) + way * i / steps)), i > 0 ? round : -1);
    }
  }

  Words words_;
  const SvgStroke& stroke_;
  std::vector<Outline> paths_;
  std::vector<Arc> arcs_;
  Vec2 at_{0}, control_{0};
  bool cubic_ = false, square_ = false, closed_ = false;
};

}  // namespace

Region svg_path(std::string_view data, const SvgStroke& stroke) {
  return PathReader(data, stroke).read();
}

}  // namespace burin::csg
