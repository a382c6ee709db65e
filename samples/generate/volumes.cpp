#include "volumes.h"

#include <burin/base/rng.h>

#include "implicit.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <stdexcept>

namespace burin::samples {

namespace {

// Distance from the line through the origin along `axis`, or from its half towards `axis`.
double from_line(Vec3 p, Vec3 axis, bool half) {
  double along = glm::dot(p, axis);
  if (half) along = std::max(along, 0.0);
  return glm::length(p - along * axis);
}

}  // namespace

SampleVolume tube_joints() {
  constexpr double kOuter = 6.2, kBore = 3.8, kFillet = 5;  // samples
  constexpr double kLevel = 30000, kSlope = 4000;           // a sample
  SampleVolume v;
  v.size = {37, 28, 28};
  v.spacing = 2;
  v.comment = "coefficients of a cubic spline, surface at 30000";
  const Vec3 middle(18, 9, 9), branch = glm::normalize(Vec3(0.35, 1, 0));
  for (int k = 0; k < v.size[2]; ++k) {
    for (int j = 0; j < v.size[1]; ++j) {
      for (int i = 0; i < v.size[0]; ++i) {
        const Vec3 p = Vec3(i, j, k) - middle;
        const double run = from_line(p, {1, 0, 0}, false);
        const double side = from_line(p, branch, true), up = from_line(p, {0, 0, 1}, true);
        const double outer = smooth_min(smooth_min(run, side, kFillet), up, kFillet) - kOuter;
        const double bore = std::min(std::min(run, side), up) - kBore;
        const double value = kLevel - kSlope * std::max(outer, -bore);
        v.samples.push_back(
            static_cast<std::uint16_t>(std::clamp(std::round(value), 0.0, 65535.0)));
      }
    }
  }
  return v;
}

SampleVolume head() {
  SampleVolume v;
  v.size = {40, 48, 52};
  v.spacing = 4;
  v.comment = "a head, surface at 500";
  const Rng grain(11);
  std::uint64_t count = 0;
  // How far inside an ellipsoid, roughly, in mm.
  const auto inside = [](Vec3 p, Vec3 at, Vec3 half) {
    const Vec3 q = (p - at) / half;
    return (1 - glm::length(q)) * std::min({half.x, half.y, half.z});
  };
  const auto join = [](double a, double b, double fillet) { return -smooth_min(-a, -b, fillet); };
  for (int k = 0; k < v.size[2]; ++k) {
    for (int j = 0; j < v.size[1]; ++j) {
      for (int i = 0; i < v.size[0]; ++i) {
        // Millimetres; y runs from the face to the back, z up.
        const Vec3 p = 4.0 * Vec3(i - 19.5, j - 24, k - 26);
        const Vec3 half(std::abs(p.x), p.y, p.z);
        double d = inside(p, {0, 6, 28}, {62, 78, 66});              // skull
        d = join(d, inside(p, {0, -22, -18}, {46, 48, 62}), 16);     // face
        d = join(d, inside(p, {0, 22, -80}, {38, 40, 60}), 14);      // neck
        d = join(d, inside(p, {0, -72, -12}, {10, 18, 20}), 8);      // nose
        d = join(d, inside(p, {0, -60, -52}, {20, 14, 12}), 10);     // chin
        d = join(d, inside(half, {62, 14, -4}, {7, 16, 24}), 4);     // ears
        d = -join(-d, inside(half, {22, -76, 8}, {15, 16, 10}), 8);  // sockets
        d = join(d, inside(half, {21, -60, 7}, {11, 11, 9}), 3);     // eyes
        const double noise = 60 * (grain.uniform(count++) - 0.5);
        v.samples.push_back(
            static_cast<std::uint16_t>(std::clamp(std::round(500 + 60 * d + noise), 0.0, 1500.0)));
      }
    }
  }
  return v;
}

void write_nrrd(const SampleVolume& volume, const std::filesystem::path& path) {
  std::ofstream out(path, std::ios::binary);
  out << fmt::format(
      "NRRD0004\n# A sample of Burin: {4}\n"
      "type: uint16\ndimension: 3\nsizes: {0} {1} {2}\nspacings: {3} {3} {3}\nendian: little\n"
      "encoding: raw\n\n",
      volume.size[0], volume.size[1], volume.size[2], volume.spacing, volume.comment);
  for (const std::uint16_t s : volume.samples) {
    out.put(static_cast<char>(s & 0xff)).put(static_cast<char>(s >> 8));
  }
  if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace burin::samples
