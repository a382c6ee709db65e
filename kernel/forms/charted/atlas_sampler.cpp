#include <burin/forms/charted/atlas_sampler.h>

namespace burin {

SurfaceSample AtlasSampler::sample(std::int32_t face, Vec2 uv) const {
  const SurfaceDerivatives d = placed_.derivatives(face, uv);
  SurfaceSample s;
  s.position = d.p;
  s.normal = placed_.normal(face, uv, d);
  s.u = d.u;
  s.v = d.v;
  const Vec3 n = glm::cross(d.u, d.v);
  const double area = glm::length(n);
  if (!(area > 0)) return s;
  // n' = (N' - n (n.N')) / |N|, without what is along n: nobody asks how long a unit vector grows.
  const double turn = glm::dot(n, s.normal) > 0 ? 1 : -1;
  s.normal_u = turn / area * (glm::cross(d.uu, d.v) + glm::cross(d.u, d.uv));
  s.normal_v = turn / area * (glm::cross(d.uv, d.v) + glm::cross(d.u, d.vv));
  return s;
}

}  // namespace burin
