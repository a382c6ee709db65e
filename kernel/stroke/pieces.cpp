#include "pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace burin::detail {
namespace {

// How lines end on the way into the light: every second one first, then every second of the others,
// by the ink at which the thinnest pen is too wide for all. With one pen the lines of the second
// family, which are never farther apart than its widest gap, do so below the ink of all of them;
// the last that end are every fourth.
class Fading {
 public:
  Fading(const Picture& picture, int family) {
    const HatchOptions& o = picture.options;
    one_pen_ = family == 2 && picture.one_pen();
    least_ = family == 1 ? o.tone_min : one_pen_ ? o.width_min / o.spacing_max : kFirstOfSecond;
    full_ = o.width_min / o.spacing_min;
    // As many halvings as the style's widest gap has room for.
    const auto room = std::lround(std::log2(o.spacing_max / o.spacing_min));
    if (family == 1 && picture.swells() && !(picture.level_step > 0))
      classes_ = std::clamp(static_cast<int>(room), 0, 2);
    if (one_pen_) classes_ = static_cast<int>(kTiers.size()) - 1;
  }

  // Of a line; where the tone is even along it, it ends nowhere, and its neighbours are to be as
  // far apart as each other.
  FadingRange range(std::int64_t number, bool even) const {
    // Those of odd number are 0, every second one of the others 1, and so on.
    int halving = 0;
    while (halving < classes_ && number % (std::int64_t{2} << halving) == 0) ++halving;
    const double spread = dice(number >> std::min(halving + 1, classes_));
    if (one_pen_) {
      const double tier = least_ * kTiers[static_cast<std::size_t>(halving)];
      const double least = tier * (1 + (even ? 0 : kSpreadOfOnePen * spread));
      return {least, least};
    }
    if (halving == classes_) return {least_, least_};
    const double by = std::ldexp(full_, -halving) * (1 + kSpread * spread);
    return {std::max(least_, kEnds * by), std::max(least_, kBegins * by)};
  }

 private:
  static constexpr double kFirstOfSecond = 0.03;  // ink: a second family shows as from there
  static constexpr double kEnds = 0.8, kBegins = 1.35;
  static constexpr double kSpread = 0.2;  // so that tips do not line up
  // Of what all lines of a second family of one pen give: where every second one begins, every
  // fourth, and the rest.
  static constexpr std::array<double, 3> kTiers{0.75, 0.45, 0.25};
  static constexpr double kSpreadOfOnePen = 0.25;

  // In [-1, 1], far apart for neighbours: the bits of the number the other way round.
  static double dice(std::int64_t number) {
    auto k = static_cast<std::uint32_t>(number);
    double sum = 0, bit = 1;
    for (; k != 0 && bit > 1e-6; k >>= 1, bit *= 0.5) sum += (k & 1u) ? bit : 0;
    return sum - 1;
  }

  double least_ = 0, full_ = 0;
  bool one_pen_ = false;
  int classes_ = 0;
};

// The pieces of a line in which there is enough ink, in their order.
std::vector<Piece> inked_pieces(const Picture& picture, const ViewRaster& raster, int family,
                                const Fading& fading, const RasterCell& cell, LevelLine line) {
  const std::size_t n = line.points.size();
  constexpr double kEven = 1e-3;  // ink
  std::vector<const RasterCell*> cells(n);
  double least = 1, most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    cells[i] = &raster.nearest(line.points[i]);
    if (cells[i]->part < 0) continue;
    least = std::min<double>(least, cells[i]->darkness);
    most = std::max<double>(most, cells[i]->darkness);
  }
  const FadingRange range = fading.range(line.number, most - least < kEven);
  std::vector<bool> ink(n);
  std::size_t dark = 0;
  for (std::size_t i = 0; i < n; ++i) {
    ink[i] = cells[i]->part >= 0 && picture.share(cells[i]->darkness, family) >= range.least;
    dark += ink[i];
  }
  std::vector<Piece> out;
  const auto add = [&](LevelLine l) {
    const double length = l.length();
    out.push_back({std::move(l), cell.part, cell.region, range, length});
  };
  if (dark == n) {
    add(std::move(line));
    return out;
  }
  // A closed line is opened where there is no ink.
  std::size_t start = 0;
  if (line.closed) start = static_cast<std::size_t>(std::ranges::find(ink, false) - ink.begin());
  for (std::size_t i = 0; i < n;) {
    if (!ink[(start + i) % n]) {
      ++i;
      continue;
    }
    LevelLine run;
    run.node = line.node;
    run.number = line.number;
    run.beside_end = line.beside_end;
    run.begin_inside = line.begin_inside && start + i == 0;
    for (; i < n && ink[(start + i) % n]; ++i) {
      run.points.push_back(line.points[(start + i) % n]);
      run.gaps.push_back(line.gaps[(start + i) % n]);
    }
    run.end_inside = line.end_inside && start + i == n;
    if (run.points.size() > 1) add(std::move(run));
  }
  return out;
}

}  // namespace

std::vector<Piece> left_of(const Piece& piece, std::size_t before, std::size_t after) {
  constexpr double kLeast = 2;  // gaps
  std::vector<Piece> out;
  const auto rest = [&](std::size_t a, std::size_t b) {
    if (b < a + 4) return;
    const auto cut = [&](const auto& from) {
      return std::decay_t<decltype(from)>(from.begin() + static_cast<std::ptrdiff_t>(a),
                                          from.begin() + static_cast<std::ptrdiff_t>(b));
    };
    Piece r{{}, piece.part, piece.region, piece.fading};
    r.line.points = cut(piece.line.points);
    r.line.gaps = cut(piece.line.gaps);
    r.line.node = piece.line.node;
    r.line.number = piece.line.number;
    r.line.beside_end = piece.line.beside_end;
    r.line.begin_inside = a > 0 || piece.line.begin_inside;
    r.line.end_inside = b < piece.line.points.size() || piece.line.end_inside;
    r.length = r.line.length();
    if (r.length > kLeast * r.line.gaps.front()) out.push_back(std::move(r));
  };
  rest(0, before);
  rest(after + 1, piece.line.points.size());
  return out;
}

std::vector<Region> regions_of(const Picture& picture, const ViewRaster& raster,
                               const std::vector<CellLine>& lines, int family) {
  const Fading fading(picture, family);
  std::map<std::pair<std::int32_t, std::int32_t>, Region> found;
  for (const CellLine& one : lines) {
    const RasterCell& cell = raster.cells[one.cell];
    Region& region = found[{cell.part, cell.region}];
    for (Piece& piece : inked_pieces(picture, raster, family, fading, cell, one.line)) {
      for (const Vec2& p : piece.line.points) region.box.add(p);
      region.pieces.push_back(std::move(piece));
    }
  }
  std::vector<Region> out;
  for (auto& [key, region] : found) {
    if (!region.pieces.empty()) out.push_back(std::move(region));
  }
  return out;
}

}  // namespace burin::detail
