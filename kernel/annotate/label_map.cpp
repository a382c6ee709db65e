#include <burin/annotate/label_map.h>
#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin {
namespace {

constexpr double kPixel = 0.5;  // paper mm
constexpr double kMostPixels = 2e6;

/// One pass of the exact distance transform of a sampled function: the lower envelope of parabolas.
/// `f` holds squared distances and is replaced. @cite Felzenszwalb2012
class Envelope {
 public:
  void pass(std::vector<double>& f) {
    const std::size_t n = f.size();
    at_.resize(n), from_.resize(n + 1), out_.resize(n);
    std::size_t k = 0;
    at_[0] = 0, from_[0] = -kFar, from_[1] = kFar;
    for (std::size_t q = 1; q < n; ++q) {
      double s = meet(f, q, at_[k]);
      while (k > 0 && s <= from_[k]) s = meet(f, q, at_[--k]);
      at_[++k] = q;
      from_[k] = s, from_[k + 1] = kFar;
    }
    k = 0;
    for (std::size_t q = 0; q < n; ++q) {
      const auto x = static_cast<double>(q);
      while (from_[k + 1] < x) ++k;
      const double d = x - static_cast<double>(at_[k]);
      out_[q] = d * d + f[at_[k]];
    }
    f.swap(out_);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  static double meet(const std::vector<double>& f, std::size_t q, std::size_t v) {
    const auto a = static_cast<double>(q), b = static_cast<double>(v);
    return ((f[q] + a * a) - (f[v] + b * b)) / (2 * (a - b));
  }

  std::vector<std::size_t> at_;
  std::vector<double> from_, out_;
};

/// Whether a pixel has a neighbour that another part, or nothing, is seen in.
bool is_border(const LabelMap& map, std::size_t x, std::size_t y) {
  if (x == 0 || y == 0 || x + 1 == map.width || y + 1 == map.height) return true;
  const std::size_t i = y * map.width + x;
  const std::int32_t own = map.parts[i];
  return map.parts[i - 1] != own || map.parts[i + 1] != own || map.parts[i - map.width] != own ||
         map.parts[i + map.width] != own;
}

/// Calls `one` with the indices of pixels along a line, a step of half a pixel each.
template <class F>
void for_each_pixel(const LabelMap& map, const std::vector<Vec2>& line, const F& one) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 a = (line[i - 1] - map.origin) / map.pixel, b = (line[i] - map.origin) / map.pixel;
    const double length = glm::distance(a, b);
    if (!(length < 1e6)) continue;
    const int steps = static_cast<int>(std::ceil(2 * length)) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Vec2 p = glm::mix(a, b, static_cast<double>(k) / steps);
      if (!(p.x >= 0 && p.y >= 0)) continue;
      const auto x = static_cast<std::size_t>(p.x), y = static_cast<std::size_t>(p.y);
      if (x < map.width && y < map.height) one(x, y);
    }
  }
}

/// Squared pixels from each pixel to the nearest that is a border or has a line.
std::vector<double> border_distances(const LabelMap& map,
                                     std::span<const std::vector<Vec2>> lines) {
  std::vector<char> inked(map.parts.size(), 0);
  for (const std::vector<Vec2>& line : lines) {
    for_each_pixel(map, line, [&](std::size_t x, std::size_t y) { inked[y * map.width + x] = 1; });
  }
  const double far = 4 * (static_cast<double>(map.width * map.width) +
                          static_cast<double>(map.height * map.height));
  std::vector<double> all(map.parts.size(), far), line;
  Envelope envelope;
  for (std::size_t y = 0; y < map.height; ++y) {
    line.assign(map.width, far);
    for (std::size_t x = 0; x < map.width; ++x) {
      if (inked[y * map.width + x] != 0 || is_border(map, x, y)) line[x] = 0;
    }
    envelope.pass(line);
    std::ranges::copy(line, all.begin() + static_cast<std::ptrdiff_t>(y * map.width));
  }
  for (std::size_t x = 0; x < map.width; ++x) {
    line.resize(map.height);
    for (std::size_t y = 0; y < map.height; ++y) line[y] = all[y * map.width + x];
    envelope.pass(line);
    for (std::size_t y = 0; y < map.height; ++y) all[y * map.width + x] = line[y];
  }
  return all;
}

}  // namespace

std::int32_t LabelMap::at(Vec2 paper) const {
  const Vec2 p = (paper - origin) / pixel;
  if (!(p.x >= 0 && p.y >= 0 && p.x < static_cast<double>(width) &&
        p.y < static_cast<double>(height))) {
    return -1;
  }
  return parts[static_cast<std::size_t>(p.y) * width + static_cast<std::size_t>(p.x)];
}

bool LabelMap::shows(std::int32_t part, Vec2 paper) const {
  for (const double dy : {0.0, -pixel, pixel}) {
    for (const double dx : {0.0, -pixel, pixel}) {
      if (at(paper + Vec2(dx, dy)) == part) return true;
    }
  }
  return false;
}

LabelMap make_label_map(const Box2& box, const std::function<std::int32_t(Vec2)>& part_at,
                        const RunContext& context) {
  LabelMap map;
  if (box.empty()) return map;
  const Vec2 size = glm::max(box.size(), Vec2(kPixel));
  map.pixel = std::max(kPixel, std::sqrt(size.x * size.y / kMostPixels));
  map.origin = box.min;
  map.width = static_cast<std::size_t>(std::ceil(size.x / map.pixel));
  map.height = static_cast<std::size_t>(std::ceil(size.y / map.pixel));
  map.parts.assign(map.width * map.height, -1);
  parallel_for(
      map.height, 4,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t y = begin; y < end; ++y) {
          for (std::size_t x = 0; x < map.width; ++x) {
            map.parts[y * map.width + x] = part_at(map.center(x, y));
          }
        }
      },
      &context);
  return map;
}

std::vector<Pole> find_poles(const LabelMap& map, std::size_t count,
                             std::span<const std::vector<Vec2>> lines) {
  std::vector<Pole> poles(count);
  for (std::size_t i = 0; i < count; ++i) poles[i].part = static_cast<std::int32_t>(i);
  if (map.parts.empty()) return poles;
  const std::vector<double> distances = border_distances(map, lines);
  for (std::size_t y = 0; y < map.height; ++y) {
    for (std::size_t x = 0; x < map.width; ++x) {
      const std::int32_t part = map.parts[y * map.width + x];
      if (part < 0 || static_cast<std::size_t>(part) >= count) continue;
      Pole& pole = poles[static_cast<std::size_t>(part)];
      // To the border itself it is half a pixel more than to the middle of the last one.
      const double radius = map.pixel * (0.5 + std::sqrt(distances[y * map.width + x]));
      if (radius > pole.radius) pole = {part, map.center(x, y), radius};
    }
  }
  return poles;
}

}  // namespace burin
