#include "rows.h"

#include "../flat/sweep.h"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>
#include <utility>

namespace burin::csg {
namespace {

// Widths of rows that one polyhedron may have: libraries join sweeps of several outlines.
constexpr int kMostWidths = 8;
// Cells below which nobody swept anything.
constexpr std::size_t kFewestCells = 6;
// Differences between the numbers of corners that are tried as the width of a row, the commonest
// first; and the faces, spread evenly, by which the best of them is found.
constexpr std::size_t kTried = 6, kSample = 4000;

using Corners = std::array<std::uint32_t, 4>;
constexpr std::uint32_t kNoFace = 0xFFFFFFFF;

std::size_t at(std::int64_t i) { return static_cast<std::size_t>(i); }

Corners sorted(Corners c) {
  std::ranges::sort(c);
  return c;
}

/// Points first + row * columns + column; faces[cell] are one or two.
struct Found {
  std::uint32_t first = 0;
  PointGrid grid;
  std::vector<std::array<std::uint32_t, 2>> faces;
};

struct HashCorners {
  std::size_t operator()(const Corners& c) const {
    std::uint64_t h = 0;
    for (const std::uint32_t i : c) h = (h ^ i) * 0x9e3779b97f4a7c15ULL, h ^= h >> 29;
    return static_cast<std::size_t>(h);
  }
};

class Finder {
 public:
  Finder(const std::vector<Vec3>& points, const Faces& faces, RunContext& run)
      : points_(points), run_(run) {
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      const auto& c = faces[f];
      if (c.size() != 3 && c.size() != 4) continue;
      const Corners corners = sorted({c[0], c[1], c[2], c.size() == 3 ? kNoFace : c[3]});
      if (face_.emplace(corners, f).second) left_.push_back(corners);
    }
  }

  std::vector<Found> run() {
    for (int pass = 0; pass < kMostWidths && left_.size() >= kFewestCells; ++pass) {
      std::uint32_t best = 0;
      std::size_t most = 0;
      for (const std::uint32_t width : widths()) {
        run_.check();
        const std::size_t cells = count(width);
        if (cells > most) most = cells, best = width;
      }
      if (best == 0 || !take(best)) break;
    }
    return std::move(found_);
  }

 private:
  std::size_t stride() const { return left_.size() / kSample + 1; }

  /// Differences of numbers along the edges of faces that are left, and their neighbours: diagonals
  /// differ by one more or less.
  std::vector<std::uint32_t> widths() const {
    std::unordered_map<std::uint32_t, std::size_t> count;
    for (std::size_t f = 0; f < left_.size(); f += stride()) {
      const Corners& corners = left_[f];
      const std::size_t n = corners[3] == kNoFace ? 3 : 4;
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = i + 1; k < n; ++k) ++count[corners[k] - corners[i]];
      }
    }
    std::vector<std::pair<std::size_t, std::uint32_t>> order;
    for (const auto& [difference, times] : count) {
      if (difference > 1) order.emplace_back(times, difference);
    }
    std::ranges::sort(order, [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    if (order.size() > kTried) order.resize(kTried);
    std::set<std::uint32_t> out;
    for (const auto& [times, difference] : order) {
      for (const std::uint32_t w : {difference - 1, difference, difference + 1}) {
        if (w >= 2) out.insert(w);
      }
    }
    return {out.begin(), out.end()};
  }

  std::uint32_t face(const Corners& c) const {
    const auto f = face_.find(sorted(c));
    return f == face_.end() ? kNoFace : f->second;
  }
  /// The quadrangle a b c d, or two triangles of it; kNoFace first where there is no such cell.
  std::array<std::uint32_t, 2> cell(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                    std::uint32_t d) const {
    if (const std::uint32_t f = face({a, b, c, d}); f != kNoFace) return {f, kNoFace};
    for (const auto& [one, other] :
         {std::pair<Corners, Corners>{{a, b, c, kNoFace}, {a, c, d, kNoFace}},
          std::pair<Corners, Corners>{{a, b, d, kNoFace}, {b, c, d, kNoFace}}}) {
      const std::uint32_t f = face(one), g = f == kNoFace ? kNoFace : face(other);
      if (g != kNoFace) return {f, g};
    }
    return {kNoFace, kNoFace};
  }
  bool has(std::uint32_t p, std::uint32_t width) const {
    return std::uint64_t{p} + width + 1 < points_.size() &&
           cell(p, p + 1, p + width + 1, p + width)[0] != kNoFace;
  }

  /// Cells at the first corners of faces.
  std::size_t count(std::uint32_t width) const {
    std::size_t cells = 0;
    for (std::size_t f = 0; f < left_.size(); f += stride()) {
      cells += has(left_[f][0], width) ? 1 : 0;
    }
    return cells;
  }

  /// Whether between the row that begins at `from` and that at `to` all cells are there.
  bool joined(std::uint32_t from, std::uint32_t to, std::uint32_t width) const {
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      if (cell(from + i, from + i + 1, to + i + 1, to + i)[0] == kNoFace) return false;
    }
    return true;
  }
  bool wraps(std::uint32_t from, std::uint32_t to, std::uint32_t width) const {
    return width > 2 && cell(from + width - 1, from, to, to + width - 1)[0] != kNoFace;
  }

  /// Takes every grid of that width; false where there was none after all.
  bool take(std::uint32_t width) {
    const std::size_t before = found_.size();
    for (std::uint32_t p = 0; std::uint64_t{p} + 2 * width <= points_.size();) {
      // A row begins where the one before it does not go on.
      const bool begins = has(p, width) && (p == 0 || !has(p - 1, width));
      if (p % 4096 == 0) run_.check();
      if (!begins || !joined(p, p + width, width)) {
        ++p;
        continue;
      }
      const bool closes = wraps(p, p + width, width);
      std::uint32_t rows = 2;
      while (std::uint64_t{p} + std::uint64_t{rows + 1} * width <= points_.size() &&
             joined(p + (rows - 1) * width, p + rows * width, width) &&
             wraps(p + (rows - 1) * width, p + rows * width, width) == closes) {
        ++rows;
      }
      if ((rows - 1) * (width - 1) >= kFewestCells) add(p, rows, width, closes);
      p += rows * width;
    }
    for (std::size_t i = before; i < found_.size(); ++i) forget(found_[i]);
    return found_.size() > before;
  }

  void add(std::uint32_t first, std::uint32_t rows, std::uint32_t width, bool closes) {
    Found f;
    f.first = first;
    PointGrid& g = f.grid;
    g.rows = static_cast<std::int32_t>(rows);
    g.columns = static_cast<std::int32_t>(width);
    g.columns_close = closes;
    const std::uint32_t last = first + (rows - 1) * width;
    g.rows_close = rows > 2 && joined(last, first, width) && wraps(last, first, width) == closes;
    g.points.assign(points_.begin() + first, points_.begin() + first + rows * width);
    for (std::int32_t j = 0; j < g.cell_rows(); ++j) {
      for (std::int32_t i = 0; i < g.cell_columns(); ++i) {
        const auto number = [&](std::int32_t row, std::int32_t column) {
          return first + static_cast<std::uint32_t>(row % g.rows * g.columns + column % g.columns);
        };
        f.faces.push_back(
            cell(number(j, i), number(j, i + 1), number(j + 1, i + 1), number(j + 1, i)));
      }
    }
    found_.push_back(std::move(f));
  }

  /// Its faces are no part of others.
  void forget(const Found& f) {
    std::set<std::uint32_t> gone;
    for (const auto& pair : f.faces) gone.insert(pair.begin(), pair.end());
    std::erase_if(left_, [&](const Corners& c) { return gone.contains(face_.find(c)->second); });
    std::erase_if(face_, [&](const auto& entry) { return gone.contains(entry.second); });
  }

  const std::vector<Vec3>& points_;
  RunContext& run_;
  std::unordered_map<Corners, std::uint32_t, HashCorners> face_;
  /// Those that are no cells yet, in the order of the list.
  std::vector<Corners> left_;
  std::vector<Found> found_;
};

}  // namespace

FaceSurfaces surfaces_by_rows(const std::vector<Vec3>& points, const Faces& faces,
                              RunContext& run) {
  FaceSurfaces out;
  out.of.assign(faces.size(), kMeantFlat);
  for (Found& f : Finder(points, faces, run).run()) {
    run.check();
    SmoothGrids smooth = smooth_grids(std::move(f.grid), Rows::Judged);
    const std::int32_t first = add_grids(out.surfaces, std::move(smooth.pieces));
    for (std::size_t c = 0; c < f.faces.size(); ++c) {
      if (smooth.piece_of[c] < 0) continue;
      for (const std::uint32_t face : f.faces[c]) {
        if (face != kNoFace) out.of[at(face)] = first + smooth.piece_of[c];
      }
    }
  }
  return out;
}

}  // namespace burin::csg
