#include "tone_balance.h"

#include <burin/base/smoothstep.h>

#include "picture.h"
#include "view_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace burin::detail {
namespace {

constexpr double kFlat = 0.9998;  // cosine: within a degree
// What is asked of one exponent: beyond it, light and shade of the style would be lost.
constexpr double kLeastGamma = 0.5, kMostGamma = 1.5;
// Ink below which a face stays the white paper that it is, and from which it takes all of a shift.
constexpr double kWhite = 0.06, kToned = 0.2;
constexpr double kMostShift = 0.08;  // of the ink of one face
constexpr int kBalanceRounds = 12;
constexpr int kLeastCells = 4;  // of a common edge that counts
constexpr double kSlantedTone =
    0.35;                          // sine of the slant from which a plane has all of its gradient
constexpr double kSameInk = 1e-6;  // faces that are as light for every purpose

using Key = std::pair<std::int32_t, std::int32_t>;  // part, region

struct Face {
  Vec3 normal{0};
  bool flat = true;
  double nearest = -std::numeric_limits<double>::infinity();
  double farthest = std::numeric_limits<double>::infinity();
  double facing = 0;
  double across = 0;  // the sum of paper x + y of its cells: which of two like faces is which
  double cells = 0;
  double shift = 0;
};

// Where two faces meet: the ink on both sides of their common edge.
struct ToneBorder {
  double cells = 0, first = 0, second = 0;
};

// Cells side by side that show two faces of one part which meet there.
bool meet(const Picture& picture, double pitch, const RasterCell& a, const RasterCell& b) {
  if (a.part < 0 || a.part != b.part || a.region == b.region) return false;
  const double scale = picture.camera.scale();
  const double steep = std::max(Picture::slope(a.facing, scale), Picture::slope(b.facing, scale));
  return std::abs(a.depth - b.depth) <= pitch * steep + picture.same_place;
}

double gamma_for(std::vector<float> ink, double least, double most) {
  if (ink.empty()) return 1;
  const auto middle = ink.begin() + static_cast<std::ptrdiff_t>(ink.size() / 2);
  std::ranges::nth_element(ink, middle);
  const double median = std::clamp(static_cast<double>(*middle), 1e-3, 1 - 1e-3);
  const double wanted = std::clamp(median, least, most);
  return std::clamp(std::log(wanted) / std::log(median), kLeastGamma, kMostGamma);
}

std::map<Key, Face> faces_of(const Picture& picture, const ViewRaster& raster) {
  std::map<Key, Face> faces;
  Key last{-1, -1};
  Face* face = nullptr;
  for (std::int32_t y = 0; y < raster.ny; ++y) {
    for (std::int32_t x = 0; x < raster.nx; ++x) {
      const RasterCell& cell = raster.at(x, y);
      if (cell.part < 0) continue;
      if (const Key key{cell.part, cell.region}; key != last || !face) {
        face = &faces[key];
        last = key;
      }
      const ProxyPoint place = cell.place();
      const Vec3 normal = picture.surface(cell.part).proxy().normal(place.face, place.bary);
      if (face->cells == 0) face->normal = normal;
      face->flat &= glm::dot(face->normal, normal) >= kFlat;
      face->nearest = std::max(face->nearest, cell.depth);
      face->farthest = std::min(face->farthest, cell.depth);
      face->facing = cell.facing;
      face->across += raster.center(x, y).x + raster.center(x, y).y;
      face->cells += 1;
    }
  }
  return faces;
}

template <class Ink>
std::map<std::pair<Key, Key>, ToneBorder> borders_of(const Picture& picture,
                                                     const ViewRaster& raster, const Ink& ink) {
  std::map<std::pair<Key, Key>, ToneBorder> borders;
  for (std::int32_t y = 0; y < raster.ny; ++y) {
    for (std::int32_t x = 0; x < raster.nx; ++x) {
      for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}}) {
        if (x + dx >= raster.nx || y + dy >= raster.ny) continue;
        const RasterCell *a = &raster.at(x, y), *b = &raster.at(x + dx, y + dy);
        if (!meet(picture, raster.pitch, *a, *b)) continue;
        if (b->region < a->region) std::swap(a, b);
        ToneBorder& border = borders[{{a->part, a->region}, {b->part, b->region}}];
        border.cells += 1;
        border.first += ink(*a);
        border.second += ink(*b);
      }
    }
  }
  return borders;
}

// Moves planes apart that meet and are nearly as dark: the one in shade first, then the other.
void set_apart(std::map<Key, Face>& faces, const std::map<std::pair<Key, Key>, ToneBorder>& borders,
               double contrast) {
  for (int round = 0; round < kBalanceRounds; ++round) {
    for (const auto& [key, border] : borders) {
      if (border.cells < kLeastCells) continue;
      Face &a = faces.at(key.first), &b = faces.at(key.second);
      const double ink_a = border.first / border.cells + a.shift,
                   ink_b = border.second / border.cells + b.shift;
      const double lack = contrast - std::abs(ink_a - ink_b);
      if (lack <= 0) continue;
      const bool a_darker = std::abs(ink_a - ink_b) > kSameInk
                                ? ink_a > ink_b
                                : a.across / a.cells > b.across / b.cells;
      Face &dark = a_darker ? a : b, &light = a_darker ? b : a;
      const double up = dark.flat ? std::min(lack, kMostShift - dark.shift) : 0;
      dark.shift += up;
      if (light.flat) light.shift -= std::min(lack - up, kMostShift + light.shift);
    }
  }
}

}  // namespace

ToneBalance::ToneBalance(const Picture& picture, const ViewRaster& raster,
                         const tone::ToneOptions& options) {
  if (options.median_min > 0 || options.median_max < 1) {
    std::vector<float> ink;
    for (const RasterCell& cell : raster.cells) {
      if (cell.part >= 0) ink.push_back(cell.darkness);
    }
    gamma_ = gamma_for(std::move(ink), options.median_min, options.median_max);
  }
  if (options.contrast <= 0 && options.gradient <= 0) return;
  std::map<Key, Face> faces = faces_of(picture, raster);
  if (options.contrast > 0) {
    const auto ink = [&](const RasterCell& cell) {
      return this->ink(cell.darkness, cell.part, cell.region, cell.depth);
    };
    set_apart(faces, borders_of(picture, raster, ink), options.contrast);
  }
  shifts_.resize(picture.surfaces.size());
  for (const auto& [key, face] : faces) {
    if (!face.flat) continue;
    auto& shifts = shifts_[static_cast<std::size_t>(key.first)];
    if (shifts.empty()) {
      shifts.resize(static_cast<std::size_t>(picture.surface(key.first).proxy().region_count));
    }
    Shift& shift = shifts[static_cast<std::size_t>(key.second)];
    shift.ink = static_cast<float>(face.shift);
    const double range = face.nearest - face.farthest;
    if (range <= picture.same_place) continue;
    const double slant = std::sqrt(std::max(0.0, 1 - face.facing * face.facing));
    shift.a_depth =
        static_cast<float>(options.gradient * std::min(1.0, slant / kSlantedTone) / range);
    shift.depth = static_cast<float>(0.5 * (face.nearest + face.farthest));
  }
}

double ToneBalance::ink(double asked, std::int32_t part, std::int32_t region, double depth) const {
  const double ink = gamma_ == 1 ? asked : std::pow(asked, gamma_);
  if (shifts_.empty()) return ink;
  const auto& shifts = shifts_[static_cast<std::size_t>(part)];
  if (shifts.empty()) return ink;
  const Shift& shift = shifts[static_cast<std::size_t>(region)];
  const double by = shift.ink + shift.a_depth * (depth - shift.depth);
  return by == 0 ? ink : std::clamp(ink + by * smoothstep(kWhite, kToned, ink), 0.0, 1.0);
}

}  // namespace burin::detail
