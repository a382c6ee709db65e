#include <burin/base/error.h>

#include "dxf_lines.h"
#include "flat/clip.h"
#include "fragments.h"
#include "import_file.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace burin::csg {
namespace {

constexpr std::size_t kMostLines = 10'000'000;

/// One entity, as the group codes of the file fill it.
struct Entity {
  std::string kind, layer, name;
  std::vector<double> x, y;
  double radius = 0;             // 40; ellipses: minor to major axis
  double start = 0, stop = 0;    // 50, 51, degrees; inserts: rotation
  double first = 0, second = 0;  // 41, 42: ellipses from and to; inserts: scale
  int flags = 0;                 // 70
};

struct Line {
  Vec2 a, b;
  std::int32_t arc = -1;
};

class DxfReader {
 public:
  DxfReader(Evaluation& e, std::uint32_t node, const Source& source)
      : e_(e), node_(node), cursor_(source), fineness_(fineness_of(e.tree.nodes[node])) {
    const Node& n = e.tree.nodes[node];
    layer_ = unescaped(n.text("layer"));
    const std::vector<double> origin = n.numbers("origin");
    if (origin.size() >= 2) origin_ = {origin[0], origin[1]};
    // linear_extrude(file = ...) scales by its first number.
    const Value* scale = n.argument("scale");
    scale_ = scale && scale->is_list() ? n.numbers("scale").at(0) : n.number("scale", 1);
    if (!(scale_ > 0)) scale_ = 1;
  }

  Region read() {
    for (std::size_t pair = 0; !cursor_.at_end(); ++pair) {
      if (pair % kPoll == 0) e_.run.check();
      const std::string_view code = line();
      if (cursor_.at_end() && code.empty()) break;
      double id = 0;
      if (!parse_double(code, id)) {
        cursor_.fail(fmt::format("a group code expected, not {}; save the DXF file as text",
                                 in_quotes(code)));
      }
      group(static_cast<int>(id), line());
    }
    finish();
    report_unsupported();
    Region region;
    region.outlines = lines_.outlines();
    region.arcs = std::move(arcs_);
    return odd_places(region);
  }

 private:
  static constexpr std::size_t kPoll = 4096;

  std::string_view line() {
    cursor_.skip_blanks();
    const std::string_view text = cursor_.rest_of_line();
    cursor_.next_line();
    return text;
  }
  double number(std::string_view text) {
    double value = 0;
    if (!parse_double(text, value) || !std::isfinite(value)) {
      report(
          e_, node_, "openscad.dxf_number",
          fmt::format("the DXF file has {} for a number; its entity is left out", in_quotes(text)));
      broken_ = true;
    }
    return value;
  }

  void group(int code, std::string_view text) {
    switch (code) {
      case 0:
        finish();
        begin(text);
        break;
      case 2:
        entity_.name = text;
        break;
      case 8:
        entity_.layer = text;
        break;
      case 10:
      case 11:
        entity_.x.push_back(in_blocks_ ? number(text) : (number(text) - origin_.x) * scale_);
        break;
      case 20:
      case 21:
        entity_.y.push_back(in_blocks_ ? number(text) : (number(text) - origin_.y) * scale_);
        break;
      case 40:
        entity_.radius = in_blocks_ ? number(text) : number(text) * scale_;
        break;
      case 41:
        entity_.first = number(text);
        break;
      case 42:
        entity_.second = number(text);
        break;
      case 50:
        entity_.start = number(text);
        break;
      case 51:
        entity_.stop = number(text);
        break;
      case 70:
        entity_.flags = static_cast<int>(std::clamp(number(text), -1e9, 1e9));
        break;
      default:
        break;
    }
  }

  void begin(std::string_view kind) {
    entity_ = {};
    entity_.kind = kind;
    broken_ = false;
    if (kind == "INSERT") entity_.first = entity_.second = 1;
  }

  bool has(std::size_t points) {
    if (entity_.x.size() >= points && entity_.y.size() >= points) return true;
    report(e_, node_, "openscad.dxf_number",
           fmt::format("a {} of the DXF file lacks coordinates; it is left out",
                       in_quotes(entity_.kind)));
    return false;
  }
  Vec2 point(std::size_t i) const { return {entity_.x[i], entity_.y[i]}; }
  bool wanted() const {
    return in_blocks_ || (in_entities_ && (layer_.empty() || layer_ == entity_.layer));
  }

  /// What the entity that ends here means.
  void finish() {
    const std::string& kind = entity_.kind;
    if (broken_ || kind.empty()) return;
    if (kind == "SECTION") {
      in_entities_ = entity_.name == "ENTITIES";
      in_blocks_ = entity_.name == "BLOCKS";
    } else if (kind == "BLOCK") {
      block_ = entity_.name;
    } else if (kind == "ENDBLK") {
      block_.clear();
    } else if (kind != "ENDSEC" && kind != "EOF" && kind != "DIMENSION" && wanted()) {
      draw(kind);
    }
  }
  void draw(const std::string& kind) {
    if (kind == "LINE") {
      if (has(2)) add(point(0), point(1));
    } else if (kind == "LWPOLYLINE") {
      polyline();
    } else if (kind == "CIRCLE") {
      if (has(1)) arc(0, 360, true);
    } else if (kind == "ARC") {
      if (has(1)) arc(entity_.start, entity_.stop, false);
    } else if (kind == "ELLIPSE") {
      if (has(2)) ellipse();
    } else if (kind == "INSERT") {
      if (has(1)) insert();
    } else {
      ++unsupported_[kind];
    }
  }

  void add(Vec2 a, Vec2 b, std::int32_t arc = -1) {
    if (++count_ > kMostLines) cursor_.fail("more than ten million lines in a DXF file");
    if (in_entities_)
      lines_.add(a, b, arc);
    else if (!block_.empty())
      blocks_[block_].push_back({a, b, arc});
  }
  void polyline() {
    const std::size_t n = std::max(entity_.x.size(), entity_.y.size());
    if (!has(n) || n == 0) return;
    for (std::size_t i = 1; i < n; ++i) add(point(i - 1), point(i));
    if (entity_.flags & 1) add(point(n - 1), point(0));
  }
  std::int32_t new_arc(const Arc& arc) {
    arcs_.push_back(arc);
    return static_cast<std::int32_t>(arcs_.size()) - 1;
  }
  void arc(double start, double stop, bool whole) {
    const Vec2 middle = point(0);
    const double r = entity_.radius;
    if (start > stop) stop += 360 * std::ceil((start - stop) / 360);
    int n = fragments(r, fineness_);
    if (!whole) n = static_cast<int>(std::ceil(n * std::min((stop - start) / 360, 100.0)));
    const double step = (stop - start) / std::max(n, 1);
    const std::int32_t round =
        step * kFewestRound <= 360 ? new_arc({middle, r, step * M_PI / 180}) : -1;
    for (int i = 0; i < n; ++i) {
      add(middle + r * direction(start + step * i), middle + r * direction(start + step * (i + 1)),
          round);
    }
  }
  void ellipse() {
    const Vec2 middle = point(0), major = point(1);
    const double length = glm::length(major);
    if (!(length > 0)) return;
    const Vec2 x = major / length, y(-x.y, x.x);
    const double minor = length * entity_.radius, start = entity_.first;
    double stop = entity_.second;
    if (start > stop) stop += 2 * M_PI * std::ceil((start - stop) / (2 * M_PI));
    const double sweep = stop - start;
    const int n = static_cast<int>(
        std::ceil(fragments(length, fineness_) * std::min(sweep / (2 * M_PI), 100.0)));
    const auto at = [&](int i) {
      const double a = start + sweep * i / n;
      return middle + std::cos(a) * length * x + std::sin(a) * minor * y;
    };
    for (int i = 0; i < n; ++i) add(at(i), at(i + 1));
  }
  void insert() {
    const auto block = blocks_.find(entity_.name);
    if (block == blocks_.end()) return;
    const Vec2 turn = direction(entity_.start), origin = point(0);
    const auto placed = [&](Vec2 p) {
      p *= Vec2(entity_.first, entity_.second);
      return Vec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y) * scale_ + origin;
    };
    // A copy: a block may insert itself.
    const std::vector<Line> lines = block->second;
    const double scale = std::abs(entity_.first) * scale_;
    const bool round = std::abs(entity_.first) == std::abs(entity_.second);
    std::map<std::int32_t, std::int32_t> moved{{-1, -1}};
    for (const Line& l : lines) {
      const auto [to, is_new] = moved.try_emplace(round ? l.arc : -1, -1);
      if (is_new) {
        const Arc arc = arcs_[static_cast<std::size_t>(l.arc)];
        to->second = new_arc({placed(arc.middle), arc.radius * scale, arc.step});
      }
      add(placed(l.a), placed(l.b), to->second);
    }
  }

  void report_unsupported() {
    for (const auto& [kind, count] : unsupported_) {
      e_.diagnostics.add(
          Severity::Warning, "openscad.dxf_entity", count,
          fmt::format("{} entities of a DXF file are left out, as OpenSCAD does", in_quotes(kind)));
    }
  }

  Evaluation& e_;
  std::uint32_t node_;
  TextCursor cursor_;
  Fineness fineness_;
  std::string layer_;
  Vec2 origin_{0};
  double scale_ = 1;
  Entity entity_;
  bool broken_ = false, in_entities_ = false, in_blocks_ = false;
  std::string block_;
  std::unordered_map<std::string, std::vector<Line>> blocks_;
  std::map<std::string, std::int64_t> unsupported_;
  std::size_t count_ = 0;
  std::vector<Arc> arcs_;
  DxfLines lines_;
};

}  // namespace

Region import_dxf(Evaluation& e, std::uint32_t node) {
  return if_there(e, node, [&]() -> Region {
    const Source source(file_of(e, node), e.run);
    return DxfReader(e, node, source).read();
  });
}

}  // namespace burin::csg
