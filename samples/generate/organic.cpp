// Forms without edges: blob, teapot, gyroid ball, carved head.
#include <burin/base/rng.h>

#include "implicit.h"
#include "models.h"

#include <numbers>

namespace burin::samples {

namespace {
constexpr double kPi = std::numbers::pi;
}

std::vector<Solid> blob(double cell) {
  // A tilted ring with limbs: saddles, necks and round ends that flow into each other.
  const Field field = [](Vec3 p) {
    const Vec3 q(p.x, 0.82 * p.y + 0.57 * p.z, 0.82 * p.z - 0.57 * p.y);
    double d = torus(q, {0, 0, 0}, 25, 10.5);
    d = smooth_min(d, limb(q, {22, 12, 4}, {34, 20, 26}, 9, 12), 16);
    d = smooth_min(d, limb(q, {-24, 8, 2}, {-46, 14, 8}, 8, 12), 16);
    d = smooth_min(d, limb(q, {4, -26, -4}, {12, -44, -14}, 9, 13), 16);
    return smooth_min(d, sphere(q, {-14, -20, 14}, 11), 14);
  };
  return {{"blob", mesh_implicit(field, {-66, -66, -66}, {66, 66, 66}, cell)}};
}

std::vector<Solid> teapot() {
  const Field field = [](Vec3 p) {
    double d = ellipsoid(p, {0, 0, 30}, {40, 40, 29});
    d = smooth_max(d, 3 - p.z, 3);
    d = smooth_min(d, torus(p, {0, 0, 4}, 23, 3.4), 4);
    // The lid: a shallow dome in a groove, with a knob.
    d = smooth_max(d, -torus(p, {0, 0, 55.5}, 22, 1.5), 1.5);
    d = smooth_min(d, ellipsoid(p, {0, 0, 55}, {17, 17, 7}), 5);
    d = smooth_min(d, ellipsoid(p, {0, 0, 67}, {6, 6, 5}), 4);
    // The spout, open at its mouth.
    double spout = limb(p, {30, 0, 19}, {47, 0, 32}, 9, 6.5);
    spout = smooth_min(spout, limb(p, {47, 0, 32}, {54, 0, 48}, 6.5, 5), 8);
    spout = smooth_min(spout, limb(p, {54, 0, 48}, {63, 0, 58}, 5, 5.8), 6);
    d = smooth_min(d, spout, 6);
    d = smooth_max(d, -limb(p, {57, 0, 51.3}, {72, 0, 68}, 2.4, 3.6), 1.5);
    // The handle: a ring that enters the body twice.
    const double handle = torus({p.x, p.z, p.y}, {-42, 33, 0}, 17, 3.8);
    return smooth_min(d, handle, 5);
  };
  return {{"teapot", mesh_implicit(field, {-75, -48, -4}, {78, 48, 80}, 0.92)}};
}

std::vector<Solid> gyroid() {
  const Field field = [](Vec3 p) {
    const double k = 2 * kPi / 34;
    const double g = std::sin(k * p.x) * std::cos(k * p.y) + std::sin(k * p.y) * std::cos(k * p.z) +
                     std::sin(k * p.z) * std::cos(k * p.x);
    // The gradient of the gyroid is about 1.5 k, so this is nearly the distance from the middle of
    // the sheet. With the distance from the ball as the other leg, the sheet ends in a round rim.
    const double across = g / (1.5 * k), beyond = std::max(0.0, glm::length(p) - 36);
    return std::hypot(across, beyond) - 3.0;
  };
  return {{"gyroid", mesh_implicit(field, {-41, -41, -41}, {41, 41, 41}, 1.3)}};
}

namespace {

double head_field(Vec3 p) {
  // Seen from -y: a long head that leans back, on shoulders; z is up, the ground at 0.
  Vec3 q = p;
  q.y -= 0.10 * (p.z - 60);
  const double narrow = 1 - 0.0018 * (q.z - 60);
  double d = round_box({q.x / narrow, q.y, q.z}, {0, 2, 74}, {22, 20, 44}, 11);
  d = smooth_min(d, limb(q, {-17, -17, 95}, {17, -17, 95}, 5.5, 5.5), 6);  // brow
  for (const double s : {-1.0, 1.0}) {
    d = smooth_max(d, -ellipsoid(q, {s * 12.5, -22, 84}, {8, 6, 6.5}), 6);     // sockets
    d = smooth_max(d, -ellipsoid(q, {s * 18, -23, 66}, {7, 5, 14}), 8);        // cheeks
    d = smooth_min(d, sphere(q, {s * 5.5, -26.5, 63}, 4.6), 3);                // nostrils
    d = smooth_min(d, round_box(q, {s * 23.5, 5, 76}, {3.4, 6, 20}, 2.6), 3);  // ears
    d = smooth_max(d, -limb(q, {s * 29, 3, 66}, {s * 29, 5, 88}, 2.4, 2.4), 2);
  }
  d = smooth_min(d, limb(q, {0, -19, 95}, {0, -28, 65}, 3.8, 5.8), 5);     // nose
  d = smooth_min(d, limb(q, {-9, -20, 52}, {9, -20, 52}, 3.1, 3.1), 2.5);  // lips
  d = smooth_min(d, limb(q, {-8, -19.5, 46.5}, {8, -19.5, 46.5}, 2.9, 2.9), 1.8);
  d = smooth_min(d, ellipsoid(q, {0, -15, 37}, {18, 9, 8}), 6);    // chin
  d = smooth_min(d, limb(p, {0, 1, 5}, {0, -1, 45}, 21, 17), 8);   // neck
  return smooth_min(d, ellipsoid(p, {0, 3, 0}, {45, 25, 30}), 9);  // shoulders
}

double gaussian(const Rng& rng, std::uint64_t i) {
  return std::sqrt(-2 * std::log(1 - rng.uniform(2 * i))) *
         std::cos(2 * kPi * rng.uniform(2 * i + 1));
}

}  // namespace

std::vector<Solid> moai(double cell, double noise) {
  TriMesh mesh = mesh_implicit(head_field, {-52, -45, -36}, {52, 45, 126}, cell);
  if (noise <= 0) return {{"moai", mesh}};
  // A scanner sees no underside and measures along the normal with an error.
  std::vector<Triangle> seen;
  for (const Triangle& t : mesh.triangles) {
    if (mesh.positions[t[0]].z > 0 && mesh.positions[t[1]].z > 0 && mesh.positions[t[2]].z > 0)
      seen.push_back(t);
  }
  std::vector<Vec3> normals(mesh.positions.size(), Vec3(0));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) normals[v] += mesh.normal(t);
  }
  const Rng rng(7, 0, 0);
  Builder builder;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] += noise * gaussian(rng, i) * normalize_or(normals[i], Vec3(0, 0, 1));
  }
  mesh.triangles = std::move(seen);
  builder.add(mesh);
  return {{"moai", builder.finish(true)}};
}

}  // namespace burin::samples
