#include <burin/base/error.h>
#include <burin/drawing/path_data.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

namespace burin {
namespace {

constexpr std::size_t kMaxText = 200'000;
constexpr std::size_t kMaxCurves = 20'000;
constexpr double kMaxNumber = 1e9;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

CubicBezier line(Vec2 a, Vec2 b) {
  return {a, glm::mix(a, b, 1.0 / 3), glm::mix(a, b, 2.0 / 3), b};
}

CubicBezier quadratic(Vec2 a, Vec2 control, Vec2 b) {
  return {a, a + 2.0 / 3 * (control - a), b + 2.0 / 3 * (control - b), b};
}

/// An elliptic arc as SVG gives it: from where the pen is to `to`. The centre is found as
/// appendix B of SVG 2 has it.
struct Arc {
  Vec2 radii;
  double turned = 0;  // radians
  bool large = false, sweep = false;
  Vec2 to;

  void append(Vec2 from, std::vector<CubicBezier>& out) const {
    Vec2 r = glm::abs(radii);
    if (from == to) return;
    if (r.x == 0 || r.y == 0) {
      out.push_back(line(from, to));
      return;
    }
    const double c = std::cos(turned), s = std::sin(turned);
    const auto back = [&](Vec2 p) { return Vec2(c * p.x + s * p.y, c * p.y - s * p.x); };
    const Vec2 half = back(0.5 * (from - to));
    const double over = std::sqrt(glm::dot(half / r, half / r));
    if (over > 1) r *= over;  // too small to reach: as small as will do
    const Vec2 unit = half / r;
    const double away = std::max(0.0, 1 / glm::dot(unit, unit) - 1);
    const double side = (large != sweep ? 1 : -1) * std::sqrt(away);
    const Vec2 centre = side * Vec2(unit.y, -unit.x);  // of the unit circle
    const Vec2 a = unit - centre, b = -unit - centre;
    const double start = std::atan2(a.y, a.x);
    double angle = std::atan2(b.y, b.x) - start;
    if (sweep && angle < 0) angle += 2 * std::numbers::pi;
    if (!sweep && angle > 0) angle -= 2 * std::numbers::pi;
    const Vec2 middle = 0.5 * (from + to);
    const auto place = [&](Vec2 on) {
      const Vec2 p = (on + centre) * r;
      return middle + Vec2(c * p.x - s * p.y, s * p.x + c * p.y);
    };
    const int count =
        std::max(1, static_cast<int>(std::ceil(std::abs(angle) / (0.501 * std::numbers::pi))));
    const double step = angle / count, handle = 4.0 / 3 * std::tan(step / 4);
    Vec2 at = from;
    for (int i = 0; i < count; ++i) {
      const double t0 = start + i * step, t1 = t0 + step;
      const Vec2 p0(std::cos(t0), std::sin(t0)), p1(std::cos(t1), std::sin(t1));
      const Vec2 end = i + 1 == count ? to : place(p1);
      out.push_back({at, place(p0 + handle * Vec2(-p0.y, p0.x)),
                     place(p1 - handle * Vec2(-p1.y, p1.x)), end});
      at = end;
    }
  }
};

class PathParser {
 public:
  explicit PathParser(std::string_view text) : text_(text) {}

  std::vector<Subpath> run() {
    skip_spaces();
    if (at_ == text_.size()) throw UsageError("the path is empty");
    if (upper(text_[at_]) != 'M') fail(at_, "a path begins with M");
    while (at_ < text_.size()) command();
    end_subpath(false);
    if (out_.empty()) throw UsageError("the path draws nothing");
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(std::size_t at, const std::string& what) const {
    throw UsageError(fmt::format("column {}: {}", at + 1, what));
  }

  void skip_spaces() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }
  void skip_comma() {
    skip_spaces();
    if (at_ < text_.size() && text_[at_] == ',') {
      ++at_;
      skip_spaces();
    }
  }

  bool number_ahead() const {
    if (at_ >= text_.size()) return false;
    const char c = text_[at_];
    return is_digit(c) || c == '.' || c == '+' || c == '-';
  }

  // By the grammar of SVG: in "1.5.5" and "1-2" two of them.
  double number() {
    const std::size_t begin = at_;
    const auto digits = [&] {
      const std::size_t from = at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      return at_ - from;
    };
    if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
    std::size_t count = digits();
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      count += digits();
    }
    if (count == 0) {
      at_ = begin;
      missing("a number");
    }
    if (at_ < text_.size() && upper(text_[at_]) == 'E') {
      const std::size_t exponent = at_++;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      if (digits() == 0) at_ = exponent;
    }
    const std::size_t from = text_[begin] == '+' ? begin + 1 : begin;
    const std::string_view digits_of = text_.substr(from, at_ - from);
    double value = 0;
    const auto read = std::from_chars(digits_of.data(), digits_of.data() + digits_of.size(), value);
    // What is too small for a double has a negative exponent; short of 300 zeros.
    const bool small =
        digits_of.find("e-") != digits_of.npos || digits_of.find("E-") != digits_of.npos;
    if (read.ec != std::errc{} && small) return 0;
    if (read.ec != std::errc{} || !(std::abs(value) <= kMaxNumber)) {
      fail(begin, fmt::format("a number beyond {:g}", kMaxNumber));
    }
    return value;
  }

  [[noreturn]] void missing(std::string_view what) const {
    if (at_ >= text_.size())
      fail(at_, fmt::format("the path ends where {} follows {}", what, name_));
    fail(at_, fmt::format("{} follows {}, not '{}'", what, name_, text_[at_]));
  }

  bool bit() {
    if (at_ < text_.size() && (text_[at_] == '0' || text_[at_] == '1')) return text_[at_++] == '1';
    missing("0 or 1");
  }

  double next() {
    skip_comma();
    return number();
  }
  Vec2 point() {
    const double x = next();
    return base_ + Vec2(x, next());
  }

  void command() {
    skip_spaces();
    if (at_ == text_.size()) return;
    const std::size_t begin = at_;
    const char c = text_[at_++];
    const char kind = upper(c);
    name_ = c;
    if (std::string_view("MLHVCSQTAZ").find(kind) == std::string_view::npos) {
      fail(begin, fmt::format("'{}' is no command of paths (M L H V C S Q T A Z)", c));
    }
    if (kind == 'Z') {
      end_subpath(true);
      return;
    }
    const bool relative = c != kind;
    bool first = true;
    do {
      base_ = relative ? pen_ : Vec2(0);
      segment(kind == 'M' && !first ? 'L' : kind);
      first = false;
      skip_comma();
    } while (number_ahead());
  }

  void segment(char kind) {
    switch (kind) {
      case 'M':
        end_subpath(false);
        pen_ = start_ = point();
        last_ = 0;
        return;
      case 'L':
        return go(line(pen_, point()), 0);
      case 'H':
        return go(line(pen_, Vec2(base_.x + next(), pen_.y)), 0);
      case 'V':
        return go(line(pen_, Vec2(pen_.x, base_.y + next())), 0);
      case 'C': {
        const Vec2 a = point(), b = point();
        return go({pen_, a, b, point()}, 'C', b);
      }
      case 'S': {
        const Vec2 a = last_ == 'C' ? 2.0 * pen_ - control_ : pen_, b = point();
        return go({pen_, a, b, point()}, 'C', b);
      }
      case 'Q': {
        const Vec2 a = point();
        return go(quadratic(pen_, a, point()), 'Q', a);
      }
      case 'T': {
        const Vec2 a = last_ == 'Q' ? 2.0 * pen_ - control_ : pen_;
        return go(quadratic(pen_, a, point()), 'Q', a);
      }
      default:
        return arc();
    }
  }

  void arc() {
    Arc arc;
    arc.radii.x = next();
    arc.radii.y = next();
    arc.turned = next() * std::numbers::pi / 180;
    skip_comma();
    arc.large = bit();
    skip_comma();
    arc.sweep = bit();
    arc.to = point();
    std::vector<CubicBezier> curves;
    arc.append(pen_, curves);
    for (const CubicBezier& c : curves) go(c, 0);
    pen_ = arc.to;
    last_ = 0;
  }

  // Control points of what went before are mirrored by S and T.
  void go(const CubicBezier& curve, char kind, Vec2 control = Vec2(0)) {
    const bool moves = curve[0] != curve[1] || curve[0] != curve[2] || curve[0] != curve[3];
    if (moves) {
      if (++count_ > kMaxCurves) {
        throw UsageError(fmt::format("the path has more than {} curves", kMaxCurves));
      }
      path_.curves.push_back(curve);
    }
    pen_ = curve[3];
    control_ = control;
    last_ = kind;
  }

  void end_subpath(bool close) {
    if (close && pen_ != start_) go(line(pen_, start_), 0);
    if (!path_.curves.empty()) {
      path_.closed = close;
      out_.push_back(std::move(path_));
    }
    path_ = {};
    pen_ = start_;
    last_ = 0;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  char name_ = 0;
  std::vector<Subpath> out_;
  Subpath path_;
  std::size_t count_ = 0;
  Vec2 pen_{0}, start_{0}, base_{0}, control_{0};
  char last_ = 0;
};

}  // namespace

std::vector<Subpath> parse_path_data(std::string_view text) {
  if (text.size() > kMaxText) {
    throw UsageError(fmt::format("the path has more than {} characters", kMaxText));
  }
  return PathParser(text).run();
}

std::string to_path_data(std::span<const Subpath> path) {
  std::string out;
  const auto put = [&](Vec2 p) { out += fmt::format(" {:.7g} {:.7g}", p.x, p.y); };
  for (const Subpath& sub : path) {
    if (sub.curves.empty()) continue;
    out += out.empty() ? "M" : " M";
    put(sub.curves.front()[0]);
    for (const CubicBezier& c : sub.curves) {
      const bool straight = c == line(c[0], c[3]);
      out += straight ? " L" : " C";
      for (std::size_t i = straight ? 3 : 1; i < 4; ++i) put(c[i]);
    }
    if (sub.closed) out += " Z";
  }
  return out;
}

std::vector<Vec2> flattened(const Subpath& path, double tolerance) {
  constexpr double kMostPieces = 256;
  std::vector<Vec2> points;
  for (const CubicBezier& c : path.curves) {
    // A piece of length 1/n of the parameter is off its chord by at most the second derivative (6
    // times the larger second difference of the control points) over 8 n^2.
    const double bend =
        std::max(glm::length(c[0] - 2.0 * c[1] + c[2]), glm::length(c[1] - 2.0 * c[2] + c[3]));
    const double pieces = std::ceil(std::sqrt(0.75 * bend / std::max(tolerance, 1e-300)));
    const int n = static_cast<int>(std::clamp(pieces, 1.0, kMostPieces));
    if (points.empty()) points.push_back(c[0]);
    for (int i = 1; i <= n; ++i) points.push_back(i == n ? c[3] : evaluate(c, double(i) / n));
  }
  if (path.closed && points.size() > 1 && points.back() == points.front()) points.pop_back();
  return points;
}

}  // namespace burin
