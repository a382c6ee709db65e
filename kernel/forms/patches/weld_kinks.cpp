// Patches with kinks inside, cut there.

#include <burin/forms/charted/continuity.h>

#include "weld.h"

#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

// A part of a chart between two kinks. There its derivatives are taken a little inside: a knot
// belongs to the span above it.
class ChartPiece final : public Chart {
 public:
  ChartPiece(std::shared_ptr<const Chart> whole, ParameterBox box)
      : whole_(std::move(whole)), box_(box) {
    const ParameterBox d = whole_->domain();
    inner_ = box;
    const Vec2 nudge = 1e-12 * d.size();
    for (int i = 0; i < 2; ++i) {
      if (box.min[i] > d.min[i]) inner_.min[i] += nudge[i];
      if (box.max[i] < d.max[i]) inner_.max[i] -= nudge[i];
    }
  }
  Vec3 position(Vec2 uv) const override {
    return whole_->position(glm::clamp(uv, box_.min, box_.max));
  }
  SurfaceDerivatives derivatives(Vec2 uv) const override {
    return whole_->derivatives(glm::clamp(uv, inner_.min, inner_.max));
  }
  ParameterBox domain() const override { return box_; }
  FaceKind kind() const override { return whole_->kind(); }
  std::vector<double> breaks(int direction, int order) const override {
    std::vector<double> inside;
    for (const double b : whole_->breaks(direction, order)) {
      if (b > box_.min[direction] && b < box_.max[direction]) inside.push_back(b);
    }
    return inside;
  }

 private:
  std::shared_ptr<const Chart> whole_;
  ParameterBox box_, inner_;
};

bool is_kink(const Chart& chart, int direction, double at) {
  constexpr int kPlaces = 16;
  const ParameterBox d = chart.domain();
  const double limit = std::cos(kSharpAngle * std::numbers::pi / 180);
  const double step = 1e-9 * d.size()[direction];
  for (int i = 0; i < kPlaces; ++i) {
    Vec2 uv = d.min + d.size() * ((i + 0.5) / kPlaces);
    Vec3 n[2];
    for (int k = 0; k < 2; ++k) {
      uv[direction] = at + (k == 0 ? -step : step);
      n[k] = chart_normal(chart.derivatives(uv), false, uv, d.center());
    }
    if (n[0] != Vec3(0) && n[1] != Vec3(0) && glm::dot(n[0], n[1]) < limit) return true;
  }
  return false;
}

}  // namespace

ChartList split_at_kinks(const ChartList& patches) {
  ChartList result;
  for (const auto& patch : patches) {
    const ParameterBox d = patch->domain();
    std::vector<double> cuts[2];
    for (int i = 0; i < 2; ++i) {
      cuts[i].push_back(d.min[i]);
      for (const double b : patch->breaks(i, 2)) {
        if (b > d.min[i] && b < d.max[i] && is_kink(*patch, i, b)) cuts[i].push_back(b);
      }
      cuts[i].push_back(d.max[i]);
    }
    if (cuts[0].size() == 2 && cuts[1].size() == 2) {
      result.push_back(patch);
      continue;
    }
    for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i) {
      for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j) {
        const ParameterBox box{{cuts[0][i], cuts[1][j]}, {cuts[0][i + 1], cuts[1][j + 1]}};
        result.push_back(std::make_shared<ChartPiece>(patch, box));
      }
    }
  }
  return result;
}

}  // namespace burin::detail
