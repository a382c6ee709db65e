#include "referee.h"

#include <cmath>
#include <numbers>

namespace burin::judge {
namespace {

constexpr double kTessellation = 0.004;  // paper mm
constexpr int kDirections = 12;
// Paper mm, and times what the slopes of both places explain, from which depths make a jump.
constexpr double kJump = 0.05;
constexpr double kSteeper = 2;

}  // namespace

Referee::Referee(const Scene& scene, const View& view, RunContext& context) : view_(view) {
  RealiseOptions options;
  options.tolerance = kTessellation / view.scale;
  options.curvature = false;
  for (const Part& part : scene.parts) {
    surfaces_.push_back(part.form->realise(options, context));
    proxies_.push_back(&surfaces_.back()->proxy());
  }
  occluder_ = std::make_unique<Occluder>(proxies_, context);
}

Referee::Seen Referee::look(Vec2 paper) const {
  const double back = 2 * occluder_->diagonal();
  const Vec3 origin = view_.over(paper) + back * view_.direction;
  Seen seen;
  seen.paper = paper;
  const auto hit = occluder_->first_hit(origin, -view_.direction, 0, 2 * back);
  if (!hit) return seen;
  const ProxyMesh& proxy = *proxies_[static_cast<std::size_t>(hit->where.part)];
  seen.hit = true;
  seen.part = hit->where.part;
  seen.face = proxy.face_source(hit->where.face);
  seen.depth = -hit->distance;
  const double c = std::abs(glm::dot(proxy.normal(hit->where.face, hit->bary), view_.direction));
  seen.slope = std::sqrt(1 - std::min(1.0, c * c)) / std::max(c, 1e-3);
  return seen;
}

bool Referee::differ(const Seen& a, const Seen& b) const {
  if (a.hit != b.hit) return true;
  if (!a.hit) return false;
  if (a.part != b.part || a.face != b.face) return true;
  const double explained = glm::distance(a.paper, b.paper) * std::max(a.slope, b.slope);
  return std::abs(a.depth - b.depth) * view_.scale > kSteeper * explained + kJump;
}

bool Referee::line_near(Vec2 paper, double radius) const {
  const Seen middle = look(paper);
  for (const double r : {radius, 0.5 * radius}) {
    for (int i = 0; i < kDirections; ++i) {
      const double a = 2 * std::numbers::pi * i / kDirections;
      if (differ(middle, look(paper + r * Vec2(std::cos(a), std::sin(a))))) return true;
    }
  }
  return false;
}

}  // namespace burin::judge
