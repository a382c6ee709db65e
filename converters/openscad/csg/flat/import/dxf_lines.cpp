#include "dxf_lines.h"

#include "flat/origins.h"

#include <algorithm>
#include <cmath>

namespace burin::csg {
namespace {

// mm: OpenSCAD's coarse grid.
constexpr double kCoarse = 0x1p-10;

/// Whether OpenSCAD turns a chain round, by its sides at the first of its leftmost points.
bool runs_back(const std::vector<Vec2>& p) {
  const auto left = std::min_element(p.begin(), p.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  const auto b = static_cast<std::size_t>(left - p.begin());
  const Vec2 before = p[b == 0 ? p.size() - 2 : b - 1] - p[b];
  const Vec2 after = p[b == p.size() - 1 ? 1 : b + 1] - p[b];
  return std::atan2(before.x, before.y) < std::atan2(after.x, after.y);
}

}  // namespace

std::size_t DxfLines::PlaceHash::operator()(const Place& p) const {
  return GridPointHash()({p.x, p.y});
}

std::uint32_t DxfLines::place(Vec2 p) {
  on_grid(p);
  Place at{static_cast<std::int64_t>(std::round(p.x / kCoarse)),
           static_cast<std::int64_t>(std::round(p.y / kCoarse))};
  if (!numbers_.contains(at)) {
    // The nearest of the eight places around it that is taken.
    const Place middle = at;
    std::int64_t best = 3;
    for (std::int64_t x = middle.x - 1; x <= middle.x + 1; ++x) {
      for (std::int64_t y = middle.y - 1; y <= middle.y + 1; ++y) {
        const std::int64_t distance = std::abs(middle.x - x) + std::abs(middle.y - y);
        if (distance >= best || !numbers_.contains({x, y})) continue;
        best = distance;
        at = {x, y};
      }
    }
  }
  const auto [found, is_new] = numbers_.try_emplace(at, static_cast<std::uint32_t>(points_.size()));
  if (is_new) {
    points_.emplace_back(static_cast<double>(at.x) * kCoarse, static_cast<double>(at.y) * kCoarse);
    at_.emplace_back();
    left_at_.push_back(0);
    begin_.push_back(0);
  }
  return found->second;
}

void DxfLines::add(Vec2 a, Vec2 b, std::int32_t arc) {
  const auto line = static_cast<std::uint32_t>(lines_.size());
  const std::uint32_t from = place(a), to = place(b);
  lines_.push_back({from, to});
  arc_.push_back(arc);
  used_.push_back(false);
  for (const std::uint32_t p : {from, to}) {
    at_[p].push_back(line);
    ++left_at_[p];
  }
}

bool DxfLines::loose(std::uint32_t line, int end) const {
  if (lines_[line][0] == lines_[line][1]) return left_at_[lines_[line][0]] == 2;
  return left_at_[lines_[line][static_cast<std::size_t>(end)]] == 1;
}

std::int64_t DxfLines::next_at(std::uint32_t place) {
  std::vector<std::uint32_t>& lines = at_[place];
  std::uint32_t& begin = begin_[place];
  while (begin < lines.size() && used_[lines[begin]]) ++begin;
  return begin < lines.size() ? static_cast<std::int64_t>(lines[begin]) : -1;
}

void DxfLines::follow(std::uint32_t line, int end, bool closed, std::vector<Outline>& out) {
  Outline outline;
  std::vector<std::uint32_t> passed{lines_[line][static_cast<std::size_t>(end)]};
  for (;;) {
    used_[line] = true;
    outline.arc.push_back(arc_[line]);
    for (const std::uint32_t p : lines_[line]) --left_at_[p];
    passed.push_back(lines_[line][static_cast<std::size_t>(1 - end)]);
    const std::int64_t next = next_at(passed.back());
    if (next < 0) break;
    line = static_cast<std::uint32_t>(next);
    end = lines_[line][0] == passed.back() ? 0 : 1;
  }
  // What hung on this chain alone may have a loose end now.
  for (const std::uint32_t p : passed) {
    outline.points.push_back(points_[p]);
    if (left_at_[p] == 1) candidates_.push(static_cast<std::uint32_t>(next_at(p)));
  }
  outline.arc.push_back(-1);  // from the last point to the first
  open_ = open_ || !closed;
  // Without loose ends a chain is taken for closed, also where a crossing has ended it elsewhere:
  // then OpenSCAD loses the end that comes first once the chain runs its way.
  const bool meets = passed.front() == passed.back();
  if (closed && !open_ && runs_back(outline.points)) {
    outline.points.pop_back();
    outline.arc.pop_back();
    if (!meets) outline.arc.back() = -1;
  } else if (closed) {
    outline.points.erase(outline.points.begin());
    if (meets) outline.arc.back() = outline.arc.front();
    outline.arc.erase(outline.arc.begin());
  }
  if (outline.points.size() >= 3) out.push_back(std::move(outline));
}

std::vector<Outline> DxfLines::outlines() {
  std::vector<Outline> out;
  const auto count = static_cast<std::uint32_t>(lines_.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (loose(i, 0) || loose(i, 1)) candidates_.push(i);
  }
  // Always the first of the file: where lines cross, that decides which go together.
  while (!candidates_.empty()) {
    const std::uint32_t line = candidates_.top();
    candidates_.pop();
    for (const int end : {0, 1}) {
      if (!used_[line] && loose(line, end)) follow(line, end, false, out);
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!used_[i]) follow(i, 0, true, out);
  }
  candidates_ = {};
  return out;
}

}  // namespace burin::csg
