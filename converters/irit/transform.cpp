#include "transform.h"

#include <burin/base/affine.h>
#include <burin/base/error.h>

#include "lexer.h"

#include <algorithm>
#include <cmath>

namespace burin::irit {
namespace {

class Transform {
 public:
  explicit Transform(const Matrix& m) : m_(m) {}

  /// Whether all points keep their weights, but for a factor that they share.
  bool affine() const { return m_[3] == 0 && m_[7] == 0 && m_[11] == 0; }

  /// Of an affine one.
  Placement placement() const {
    Placement out;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<int>(k);
      for (int column = 0; column < 3; ++column) {
        out.linear[column][row] = m_[k + 4 * static_cast<std::size_t>(column)] / m_[15];
      }
      out.offset[row] = m_[k + 12] / m_[15];
    }
    if (!is_invertible(out)) throw GeometryError("its matrix flattens what it moves");
    return out;
  }

  /// Moves the point and gives the factor of its weight.
  double operator()(Vec3& p) const {
    const auto row = [&](std::size_t k) {
      return p.x * m_[k] + p.y * m_[k + 4] + p.z * m_[k + 8] + m_[k + 12];
    };
    const double w = row(3);
    if (!(affine() ? w != 0 : w > 0)) {
      throw GeometryError("its matrix sends points to infinity, or beyond");
    }
    p = Vec3(row(0), row(1), row(2)) / w;
    if (!(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kLargestCoordinate)) {
      throw GeometryError("its matrix makes coordinates absurdly large");
    }
    return w;
  }

  void operator()(std::vector<Vec3>& points, std::vector<double>& weights) const {
    if (!affine() && weights.empty()) weights.assign(points.size(), 1.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double factor = (*this)(points[i]);
      if (!affine()) weights[i] *= factor;
    }
  }

 private:
  const Matrix& m_;
};

}  // namespace

void transform(IritItem& item, const Matrix& matrix) {
  const Transform moved(matrix);
  if (auto* surface = std::get_if<IritSurface>(&item)) {
    moved(surface->data.points, surface->data.weights);
  } else if (auto* trimmed = std::get_if<IritTrimmed>(&item)) {
    for (TrimmedSurface& face : trimmed->faces) moved(face.surface.points, face.surface.weights);
  } else if (auto* curve = std::get_if<IritCurve>(&item)) {
    moved(curve->points, curve->weights);
  } else if (auto* polygon = std::get_if<IritPolygon>(&item)) {
    for (Vec3& p : polygon->points) moved(p);
  } else if (auto* trivariate = std::get_if<IritTrivariate>(&item)) {
    if (moved.affine()) {
      trivariate->placement = after(moved.placement(), trivariate->placement);
    } else {
      item = IritUnread{"TRIVAR in perspective", trivariate->line};
    }
  }
}

}  // namespace burin::irit
