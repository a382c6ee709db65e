// Spline models: horn, teapot.
#include "splines.h"

#include <cmath>
#include <numbers>

namespace burin::samples {
namespace {

/// The place at t in [0, 1] of the helix of the horn, and the circle about it.
Ring horn_ring(double t) {
  const auto center = [](double s) {
    const double angle = 2.2 * 2 * std::numbers::pi * s + 2.7, radius = 12 + 20 * s;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), 62 * (1 - s) * (1 - 0.15 * s));
  };
  constexpr double kStep = 1e-5;  // of the whole length
  const Vec3 along = glm::normalize(center(t + kStep) - center(t - kStep));
  const Vec3 out = center(t) * Vec3(1, 1, 0);
  const Vec3 a = glm::normalize(out - glm::dot(out, along) * along);
  const double radius = 2 + 10 * std::pow(t, 1.6) + 5 * std::pow(t, 12);
  return {center(t), radius * a, radius * glm::cross(along, a)};
}

Ring between(const Ring& p, const Ring& q, double t) {
  return {p.center + t * (q.center - p.center), p.a + t * (q.a - p.a), p.b + t * (q.b - p.b)};
}

Ring scaled(const Ring& r, double by) { return {r.center, by * r.a, by * r.b}; }

constexpr int kHornRings = 40;

std::vector<Ring> horn_rings() {
  std::vector<Ring> rings;
  for (int i = 0; i < kHornRings; ++i)
    rings.push_back(horn_ring(0.02 + 0.98 * i / (kHornRings - 1)));
  return rings;
}

/// A tube in the plane y = 0: centers, half width in the plane and across it.
struct Station {
  double x, z, in_plane, across;
};

/// The direction of the path at station i.
Vec3 heading(const std::vector<Station>& path, std::size_t i) {
  const Station& p = path[i == 0 ? 0 : i - 1];
  const Station& q = path[std::min(i + 1, path.size() - 1)];
  return glm::normalize(Vec3(q.x - p.x, 0, q.z - p.z));
}

std::vector<Ring> tube_rings(const std::vector<Station>& path) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec3 along = heading(path, i), side(0, path[i].across, 0);
    rings.push_back(
        {{path[i].x, 0, path[i].z}, path[i].in_plane * glm::cross(Vec3(0, 1, 0), along), side});
  }
  return rings;
}

/// A round end before the first ring: a pole on the line through the rings' centers.
std::vector<Ring> rounded_start(std::vector<Ring> rings) {
  const Vec3 back = rings[0].center - rings[1].center;
  Ring pole{rings[0].center + 0.5 * back, Vec3(0), Vec3(0)};
  Ring shoulder = scaled(rings[0], 0.6);
  shoulder.center = pole.center;
  rings.insert(rings.begin(), {pole, shoulder});
  return rings;
}

}  // namespace

std::vector<SplineObject> horn() {
  const std::vector<Ring> wall = horn_rings();
  const std::size_t last = wall.size() - 1;
  // The second ring of what goes on lies on the line of the wall's last two: a smooth border.
  std::vector<Ring> rim = {wall[last], between(wall[last - 1], wall[last], 1.12)};
  Ring lip = between(wall[last - 1], wall[last], 1.2);
  rim.push_back(scaled(lip, 0.985));
  lip = between(wall[last - 1], wall[last], 1.12);
  rim.push_back(scaled(lip, 0.93));
  for (int i = 0; i < 9; ++i) rim.push_back(scaled(horn_ring(1 - 0.022 * i), 0.9 - 0.01 * i));
  rim.push_back(scaled(rim.back(), 0.6));
  rim.push_back(scaled(rim.back(), 0));
  std::vector<Ring> tip = {wall[0], between(wall[1], wall[0], 1.5)};
  tip.push_back(scaled(between(wall[1], wall[0], 1.8), 0.6));
  tip.push_back(scaled(tip.back(), 0));
  return {{"HORN", "196,160,80", {sweep(wall), sweep(rim), sweep(tip)}}};
}

std::vector<SplineObject> spline_teapot() {
  const NurbsData body =
      turn({{0, 0},     {15, 0},    {27, 0},    {29.5, 0.4},  {30.5, 2}, {31, 4.5},  {34, 7},
            {40, 11},   {43.5, 17}, {42.5, 25}, {38, 35},     {33, 44},  {27.5, 51}, {23.6, 53.2},
            {22, 54.2}, {22.2, 56}, {21, 57.2}, {19.8, 56.8}, {19, 55},  {10, 54},   {0, 54}});
  const NurbsData lid = turn({{0, 55},
                              {12, 55},
                              {18.8, 55.2},
                              {20.6, 56.4},
                              {20.4, 58.6},
                              {17.5, 60.2},
                              {12, 62},
                              {6, 63.4},
                              {3.2, 64.2},
                              {2.6, 66},
                              {4.2, 68.4},
                              {5.6, 71},
                              {4.6, 74.2},
                              {2, 75.2},
                              {0, 75.2}});
  const std::vector<Station> handle = {
      {-30, 44, 3, 4.6},     {-38, 46.5, 2.9, 4.5}, {-50, 49.5, 2.7, 4.3}, {-61, 48, 2.6, 4.2},
      {-66.5, 39, 2.6, 4.2}, {-63.5, 28, 2.6, 4.2}, {-54, 18.5, 2.6, 4.2}, {-44, 12.5, 2.8, 4.3},
      {-36, 9.5, 3, 4.5},    {-28, 7.5, 3, 4.6}};
  std::vector<Ring> grip = rounded_start(tube_rings(handle));
  std::reverse(grip.begin(), grip.end());
  grip = rounded_start(std::move(grip));
  std::vector<Station> path = {{28, 19, 11, 9},        {36, 19.5, 10.6, 8.6}, {45, 22, 8.6, 7.4},
                               {52, 29, 6.4, 6},       {56, 39, 5, 5},        {60, 49, 4.3, 4.3},
                               {65.5, 56.5, 4.2, 4.2}, {70.5, 60.5, 4.6, 4.6}};
  const std::vector<Ring> outside = tube_rings(path);
  std::vector<Ring> spout = rounded_start(outside);
  const std::size_t end = outside.size() - 1;
  spout.push_back(scaled(between(outside[end - 1], outside[end], 1.12), 0.93));
  spout.push_back(scaled(outside[end], 0.8));
  spout.push_back(scaled(outside[end - 1], 0.76));
  spout.push_back(scaled(outside[end - 2], 0.74));
  spout.push_back(scaled(outside[end - 2], 0.4));
  spout.push_back(scaled(outside[end - 2], 0));
  return {{"BODY", "150,90,60", {body}},
          {"LID", "150,90,60", {lid}},
          {"SPOUT", "150,90,60", {sweep(spout)}},
          {"HANDLE", "60,40,30", {sweep(grip)}}};
}

}  // namespace burin::samples
