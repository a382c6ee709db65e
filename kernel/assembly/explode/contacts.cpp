#include "contacts.h"

#include <burin/base/parallel.h>
#include <burin/mesh/spread.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace burin::detail {
namespace {

constexpr std::size_t kPoints = 1024;
constexpr std::size_t kLarge = 4;  // points in a triangle
constexpr double kNear = 0.01;     // of the smaller part's diagonal
constexpr double kFacing = 0.8;    // cosine between faces that touch

struct Sample {
  std::uint32_t face = 0;
  Vec3 bary{0};
  double area = 0;
};

// Points all over a mesh, evenly by area, placed in each triangle by a sequence without gaps, and
// beside the corners of large triangles: they tell how far a contact reaches.
std::vector<Sample> samples_of(const TriMesh& mesh, double area) {
  std::vector<Sample> samples;
  double sum = 0;
  std::size_t next = 0;
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const Triangle& t = mesh.triangles[f];
    const double one = 0.5 * glm::length(glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                                    mesh.positions[t[2]] - mesh.positions[t[0]]));
    sum += one;
    const auto until = static_cast<std::size_t>(sum / area * static_cast<double>(kPoints));
    const std::size_t count = until > next ? until - next : 0;
    if (count >= kLarge) {
      constexpr double kIn = 1e-3;
      for (int k = 0; k < 3; ++k) {
        Vec3 bary(kIn);
        bary[k] = 1 - 2 * kIn;
        samples.push_back({f, bary, 0});
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      // No two triangles alike.
      samples.push_back({f, spread_bary(next + k), area / static_cast<double>(kPoints)});
    }
    next = std::max(next, until);
  }
  return samples;
}

/// What was found of one face and one other part.
struct Touch {
  NormalSum normals;
  std::vector<Vec3> points, directions;
};

// The point nearest to all lines through the points along the normals, in the plane across `axis`,
// half-way along it.
Vec3 middle_on_axis(const Touch& touch, Vec3 axis) {
  const Vec3 u = any_orthogonal(axis), v = glm::cross(axis, u);
  glm::dmat2 sum(0);
  Vec2 right(0);
  double low = 1e300, high = -1e300;
  for (std::size_t i = 0; i < touch.points.size(); ++i) {
    const Vec2 n = glm::normalize(
        Vec2(glm::dot(touch.directions[i], u), glm::dot(touch.directions[i], v)) + Vec2(1e-300));
    const Vec2 p(glm::dot(touch.points[i], u), glm::dot(touch.points[i], v));
    const glm::dmat2 across = glm::dmat2(1) - glm::outerProduct(n, n);
    sum += across;
    right += across * p;
    low = std::min(low, glm::dot(touch.points[i], axis));
    high = std::max(high, glm::dot(touch.points[i], axis));
  }
  const Vec2 c = glm::inverse(sum) * right;
  return c.x * u + c.y * v + 0.5 * (low + high) * axis;
}

Contact contact_of(std::size_t part, std::size_t other, const Touch& touch, const Mat3& frame) {
  Contact contact{.part = part, .other = other, .area = touch.normals.weight};
  constexpr std::size_t kEnough = 3;
  const bool flat = touch.normals.planar();
  if (flat || touch.points.size() >= kEnough) contact.axis = touch.normals.axis();
  contact.round = !flat && contact.axis != Vec3(0);
  if (contact.round) {
    contact.middle = middle_on_axis(touch, contact.axis);
  } else {
    Box3 box;
    const Mat3 rows = contact.axis != Vec3(0) ? rows_along(contact.axis, frame) : frame;
    for (const Vec3& p : touch.points) box.add(in_rows(rows, p));
    const Vec3 c = box.center();
    contact.middle = c.x * rows[0] + c.y * rows[1] + c.z * rows[2];
  }
  return contact;
}

std::vector<Contact> contacts_of(std::size_t part, const Shapes& shapes, const Occluder& occluder) {
  const ProxyMesh& proxy = *shapes.proxies[part];
  const double own = shapes.boxes[part].diagonal();
  std::map<std::pair<std::size_t, std::int32_t>, Touch> touches;
  std::vector<std::size_t> found;
  for (const Sample& sample : samples_of(proxy.mesh, shapes.signatures[part].area)) {
    const Vec3 p = proxy.position(sample.face, sample.bary),
               n = proxy.normal(sample.face, sample.bary);
    const double reach = kNear * own + 2 * proxy.tolerance;
    found.clear();
    (void)occluder.occluded_by(p - reach * n, n, 0, 2 * reach, [&](const Hit& hit) {
      const auto other = static_cast<std::size_t>(hit.where.part);
      if (other == part) return false;
      const double near = kNear * std::min(own, shapes.boxes[other].diagonal()) + proxy.tolerance +
                          shapes.proxies[other]->tolerance;
      const Vec3 m = shapes.proxies[other]->normal(hit.where.face, hit.bary);
      if (std::abs(hit.distance - reach) <= near && std::abs(glm::dot(n, m)) > kFacing) {
        found.push_back(other);
      }
      return false;
    });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const std::size_t other : found) {
      Touch& touch = touches[{other, proxy.face_source(sample.face)}];
      touch.normals.add(n, sample.area);
      touch.points.push_back(p);
      touch.directions.push_back(n);
    }
  }
  std::vector<Contact> contacts;
  for (const auto& [key, touch] : touches) {
    contacts.push_back(contact_of(part, key.first, touch, shapes.frame));
  }
  return contacts;
}

}  // namespace

std::vector<Contact> find_contacts(const Shapes& shapes, const Occluder& occluder,
                                   const RunContext& context) {
  std::vector<std::vector<Contact>> each(shapes.parts.size());
  parallel_for(
      shapes.parts.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          each[i] = contacts_of(shapes.parts[i], shapes, occluder);
        }
      },
      &context);
  std::vector<Contact> all;
  for (const auto& contacts : each) all.insert(all.end(), contacts.begin(), contacts.end());
  return all;
}

std::vector<std::vector<Neighbour>> neighbours_of(const std::vector<Contact>& contacts,
                                                  std::size_t count) {
  std::vector<std::map<std::size_t, double>> areas(count);
  for (const Contact& contact : contacts) {
    areas[contact.part][contact.other] += contact.area;
    areas[contact.other][contact.part] += contact.area;
  }
  std::vector<std::vector<Neighbour>> neighbours(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& [part, area] : areas[i]) neighbours[i].push_back({part, area});
  }
  return neighbours;
}

}  // namespace burin::detail
