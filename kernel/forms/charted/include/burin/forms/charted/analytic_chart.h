#pragma once
/// Planes, cylinders, cones, spheres and tori in OCCT's parametrisation, in closed form.

#include <burin/forms/charted/chart.h>

#include <memory>

namespace burin {

/// Origin and axes, orthonormal but not always right-handed.
struct ChartAxes {
  Vec3 origin{0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

/// origin + u x + v y
std::shared_ptr<const Chart> plane_chart(const ChartAxes& axes, const ParameterBox& domain);
/// radius (cos u x + sin u y) + v z
std::shared_ptr<const Chart> cylinder_chart(const ChartAxes& axes, double radius, double v0,
                                            double v1);
/// (radius + v sin a) (cos u x + sin u y) + v cos a z; the domain ends at the tip.
std::shared_ptr<const Chart> cone_chart(const ChartAxes& axes, double radius, double half_angle,
                                        double v0, double v1);
/// radius (cos v (cos u x + sin u y) + sin v z)
std::shared_ptr<const Chart> sphere_chart(const ChartAxes& axes, double radius);
/// (major + minor cos v) (cos u x + sin u y) + minor sin v z
std::shared_ptr<const Chart> torus_chart(const ChartAxes& axes, double major, double minor);

}  // namespace burin
