#pragma once
/// How dark a drawing really is: strokes painted on a fine grid, as a printer would, and blurred as
/// an eye does.

#include <burin/drawing/drawing.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin::test {

/// A sheet of square cells that are inked or not.
class Sheet {
 public:
  Sheet(double width, double height, double pitch)
      : pitch_(pitch),
        nx_(static_cast<int>(width / pitch)),
        ny_(static_cast<int>(height / pitch)),
        ink_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), 0) {}

  int nx() const { return nx_; }
  int ny() const { return ny_; }

  /// Paints a line of varying width: every cell whose centre lies within half the local width of
  /// it.
  void paint(const Path& path, double extra = 0) {
    const std::size_t n = path.points.size();
    for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
      const std::size_t j = (i + 1) % n;
      const auto width = [&](std::size_t k) {
        return (path.width.size() == 1 ? path.width[0] : path.width[k]) / 2 + extra;
      };
      segment(path.points[i], path.points[j], width(i), width(j));
    }
  }

  /// The share of ink in each cell of a coarser grid of `factor` x `factor` cells.
  std::vector<float> shares(int factor) const {
    const int cx = nx_ / factor, cy = ny_ / factor;
    std::vector<float> out(static_cast<std::size_t>(cx) * static_cast<std::size_t>(cy), 0);
    for (int y = 0; y < cy * factor; ++y) {
      for (int x = 0; x < cx * factor; ++x) {
        out[static_cast<std::size_t>(y / factor * cx + x / factor)] +=
            static_cast<float>(ink_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
                                    static_cast<std::size_t>(x)]) /
            static_cast<float>(factor * factor);
      }
    }
    return out;
  }

 private:
  void segment(Vec2 a, Vec2 b, double ra, double rb) {
    const double r = std::max(ra, rb);
    const auto cell = [&](double v, int n) {
      return std::clamp(static_cast<int>(std::floor(v / pitch_)), 0, n - 1);
    };
    const int x0 = cell(std::min(a.x, b.x) - r, nx_), x1 = cell(std::max(a.x, b.x) + r, nx_);
    const int y0 = cell(std::min(a.y, b.y) - r, ny_), y1 = cell(std::max(a.y, b.y) + r, ny_);
    const Vec2 d = b - a;
    const double dd = glm::dot(d, d);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const Vec2 p = pitch_ * Vec2(x + 0.5, y + 0.5);
        const double t = dd > 0 ? std::clamp(glm::dot(p - a, d) / dd, 0.0, 1.0) : 0;
        if (glm::length(p - a - t * d) <= ra + t * (rb - ra)) {
          ink_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
               static_cast<std::size_t>(x)] = 1;
        }
      }
    }
  }

  double pitch_;
  int nx_, ny_;
  std::vector<std::uint8_t> ink_;
};

/// Mean over a disc of `radius` cells around each cell, of the cells where `mask` is set; 0 where
/// none is.
inline std::vector<float> disc_mean(const std::vector<float>& plane,
                                    const std::vector<std::uint8_t>& mask, int nx, int ny,
                                    int radius) {
  std::vector<float> out(plane.size(), 0);
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      double sum = 0;
      int count = 0;
      for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
          const int px = x + dx, py = y + dy;
          if (dx * dx + dy * dy > radius * radius || px < 0 || py < 0 || px >= nx || py >= ny)
            continue;
          const auto i = static_cast<std::size_t>(py * nx + px);
          if (!mask[i]) continue;
          sum += plane[i];
          ++count;
        }
      }
      if (count > 0) out[static_cast<std::size_t>(y * nx + x)] = static_cast<float>(sum / count);
    }
  }
  return out;
}

}  // namespace burin::test
