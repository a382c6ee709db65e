#include "balls.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace burin::recognised {
namespace {

// Cosines: of a facet against the mean normal around a vertex inside a smooth stretch (30 degrees),
// and of neighbouring facets (40.5 degrees).
constexpr double kAround = 0.866, kNeighbouring = 0.760;
// How far vertices may be off, as a share of the sagitta.
constexpr double kOffBall = 0.05;
constexpr std::size_t kLeastPoints = 5, kLeastCore = 4;
// Facets of more corners are caps or what a plane has cut: their rims are no smooth stretches.
constexpr std::size_t kMostCorners = 8;

class BallFinder {
 public:
  BallFinder(const TriMesh& mesh, const Facets& facets, const RunContext& context)
      : mesh_(mesh), facets_(facets), context_(context), around_(mesh.positions.size()) {
    for (std::size_t f = 0; f < facets.list.size(); ++f) {
      for (const std::uint32_t v : facets.list[f].vertices) {
        around_[v].push_back(static_cast<std::int32_t>(f));
      }
    }
    for (std::uint32_t v = 0; v < around_.size(); ++v) inside_.push_back(smooth_around(v));
  }

  std::vector<Ball> run() {
    std::vector<std::uint8_t> done(around_.size(), 0);
    taken_.assign(facets_.list.size(), 0);
    for (std::uint32_t v = 0; v < around_.size(); ++v) {
      if (v % 256 == 0) context_.check();
      if (!inside_[v] || done[v]) continue;
      try_at(v, done);
    }
    return std::move(balls_);
  }

 private:
  const Facet& facet(std::int32_t f) const { return facets_.list[static_cast<std::size_t>(f)]; }

  bool smooth_around(std::uint32_t v) const {
    if (around_[v].size() < 3) return false;
    Vec3 sum(0);
    for (const std::int32_t f : around_[v]) sum += facet(f).normal;
    if (!(glm::length(sum) > 0)) return false;
    sum = glm::normalize(sum);
    return std::all_of(around_[v].begin(), around_[v].end(), [&](std::int32_t f) {
      return facet(f).area > 0 && facet(f).vertices.size() <= kMostCorners &&
             glm::dot(facet(f).normal, sum) >= kAround;
    });
  }

  /// Vertices inside smooth stretches that share a facet with `v`, itself included.
  std::vector<std::uint32_t> near(std::uint32_t v) const {
    std::vector<std::uint32_t> out;
    for (const std::int32_t f : around_[v]) {
      for (const std::uint32_t w : facet(f).vertices) {
        if (inside_[w]) out.push_back(w);
      }
    }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  bool fit(const std::vector<std::uint32_t>& points, Ball& ball) const {
    if (points.size() < kLeastPoints) return false;
    const Vec3 o = mesh_.positions[points.front()];
    Eigen::MatrixXd m(points.size(), 4);
    Eigen::VectorXd b(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 p = mesh_.positions[points[i]] - o;
      const auto row = static_cast<Eigen::Index>(i);
      m.row(row) << 2 * p.x, 2 * p.y, 2 * p.z, 1.0;
      b(row) = glm::dot(p, p);
    }
    const Eigen::Vector4d x = m.colPivHouseholderQr().solve(b);
    const Vec3 c(x(0), x(1), x(2));
    const double square = x(3) + glm::dot(c, c);
    if (!x.allFinite() || !(square > 0)) return false;
    ball.center = o + c;
    ball.radius = std::sqrt(square);
    return true;
  }

  double depth(const Ball& ball, const Facet& f) const {
    return std::abs(ball.radius) - std::abs(glm::dot(f.normal, ball.center) - f.offset);
  }
  double off(const Ball& ball, std::uint32_t v) const {
    return glm::length(mesh_.positions[v] - ball.center) - std::abs(ball.radius);
  }
  double allowed(const Ball& ball) const { return kOffBall * ball.sagitta + 3 * facets_.noise; }

  std::vector<std::uint32_t> grow(std::uint32_t seed, const Ball& ball) const {
    std::vector<std::uint32_t> points{seed};
    std::vector<std::uint8_t> seen(around_.size(), 0);
    seen[seed] = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const std::uint32_t w : near(points[i])) {
        if (seen[w] || std::abs(off(ball, w)) > allowed(ball)) continue;
        seen[w] = 1;
        points.push_back(w);
      }
    }
    return points;
  }

  void try_at(std::uint32_t seed, std::vector<std::uint8_t>& done) {
    Ball ball;
    std::vector<std::uint32_t> points = near(seed);
    if (!fit(points, ball)) return;
    for (const std::int32_t f : around_[seed]) {
      ball.sagitta = std::max(ball.sagitta, depth(ball, facet(f)));
    }
    // Facets that reach farther than 28 degrees of the sphere are no approximation.
    if (!(ball.sagitta > 0) || ball.sagitta > 0.12 * ball.radius) return;
    const auto fits = [&](std::uint32_t w) { return std::abs(off(ball, w)) <= allowed(ball); };
    if (!std::all_of(points.begin(), points.end(), fits)) return;
    // The neighbourhood of one vertex on two circles around an axis lies on a sphere by itself.
    for (const std::int32_t f : around_[seed]) {
      const auto& corners = facet(f).vertices;
      if (!std::all_of(corners.begin(), corners.end(),
                       [&](std::uint32_t w) { return within(ball, w); })) {
        return;
      }
    }
    points = grow(seed, ball);
    if (!fit(points, ball)) return;
    points = grow(seed, ball);
    std::vector<std::int32_t> core;
    std::size_t count = 0;
    for (const std::uint32_t v : points) {
      const bool all = std::all_of(around_[v].begin(), around_[v].end(), [&](std::int32_t f) {
        const auto& corners = facet(f).vertices;
        return std::all_of(corners.begin(), corners.end(),
                           [&](std::uint32_t w) { return within(ball, w); });
      });
      if (!all) continue;
      ++count;
      core.insert(core.end(), around_[v].begin(), around_[v].end());
    }
    if (count < kLeastCore) return;
    for (const std::int32_t f : core) {
      ball.sagitta = std::max(ball.sagitta, depth(ball, facet(f)));
    }
    const Facet& first = facet(core.front());
    if (glm::dot(first.normal, first.center - ball.center) < 0) ball.radius = -ball.radius;
    gather(core, ball);
    for (const std::uint32_t v : points) done[v] = 1;
    balls_.push_back(std::move(ball));
  }

  bool within(const Ball& ball, std::uint32_t v) const {
    const double d = off(ball, v);
    return d <= allowed(ball) && d >= -1.1 * ball.sagitta - allowed(ball);
  }

  bool belongs(const Ball& ball, const Facet& f) const {
    if (depth(ball, f) > 1.05 * ball.sagitta + 3 * facets_.noise) return false;
    const double side = ball.radius > 0 ? 1 : -1;
    if (side * glm::dot(f.normal, f.center - ball.center) < 0.8 * std::abs(ball.radius)) {
      return false;
    }
    return std::all_of(f.vertices.begin(), f.vertices.end(),
                       [&](std::uint32_t v) { return within(ball, v); });
  }

  void gather(const std::vector<std::int32_t>& core, Ball& ball) {
    const auto take = [&](std::int32_t f) {
      if (taken_[static_cast<std::size_t>(f)] || !belongs(ball, facet(f))) return;
      taken_[static_cast<std::size_t>(f)] = 1;
      ball.facets.push_back(f);
    };
    for (const std::int32_t f : core) take(f);
    for (std::size_t i = 0; i < ball.facets.size(); ++i) {
      const std::int32_t f = ball.facets[i];
      for (const FacetLink& l : facet(f).links) {
        if (glm::dot(facet(f).normal, facet(l.facet).normal) >= kNeighbouring) take(l.facet);
      }
    }
  }

  const TriMesh& mesh_;
  const Facets& facets_;
  const RunContext& context_;
  std::vector<std::vector<std::int32_t>> around_;
  std::vector<std::uint8_t> inside_, taken_;
  std::vector<Ball> balls_;
};

}  // namespace

std::vector<Ball> find_balls(const TriMesh& mesh, const Facets& facets, const RunContext& context) {
  return BallFinder(mesh, facets, context).run();
}

}  // namespace burin::recognised
