#pragma once
// Whether an exploded view is one: no parts in each other, and steps that a hand could do.

#include <burin/base/rng.h>
#include <burin/explode/explode.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/surface/scene.h>
#include <burin/visibility/occluder.h>

#include <burin_test/turned.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

inline void add_part(Scene& scene, std::string name, TriMesh mesh,
                     std::vector<std::string> assembly = {}) {
  Part part;
  part.name = std::move(name);
  part.form = std::make_shared<MeshForm>(std::move(mesh));
  part.assembly = std::move(assembly);
  scene.parts.push_back(std::move(part));
}

/// A ring about z.
inline TriMesh ring(double inner, double outer, double from, double to, Vec3 at = Vec3(0)) {
  return moved(turned({{inner, from}, {outer, from}, {outer, to}, {inner, to}}, 48, true), Mat3(1),
               at);
}

/// A solid turned about z: a shank and a head.
inline TriMesh bolt(double shank, double head, double low, double neck, double high,
                    Vec3 at = Vec3(0)) {
  return moved(turned({{shank, low}, {shank, neck}, {head, neck}, {head, high}}, 48), Mat3(1), at);
}

/// A plate with stacks of a bush, a washer and a bolt.
inline Scene stacks(int count) {
  Scene scene;
  const int row = static_cast<int>(std::ceil(std::sqrt(count)));
  add_part(scene, "plate", box({-20, -20, -10}, {40.0 * row, 40.0 * row, 0}));
  for (int i = 0; i < count; ++i) {
    const int line = i / row;
    const Vec3 at(40.0 * (i % row), 40.0 * line, 0);
    add_part(scene, "bush", ring(5, 14, 0, 12 + i % 5, at));
    add_part(scene, "washer", ring(5, 10, 12 + i % 5, 14 + i % 5, at));
    add_part(scene, "bolt", bolt(5, 9, 0, 14 + i % 5, 22 + i % 5, at));
  }
  return scene;
}

/// The triangles of all parts, which stand where moves take them.
class Placed {
 public:
  explicit Placed(const Scene& scene) {
    RunContext context;
    RealiseOptions options;
    options.tolerance = 2e-4 * scene.bounds().diagonal();
    options.curvature = false;
    for (const Part& part : scene.parts) {
      together_.push_back(part.form->realise(options, context)->proxy());
    }
    diagonal_ = scene.bounds().diagonal();
    place(std::vector<Vec3>(together_.size(), Vec3(0)));
  }

  void place(const std::vector<Vec3>& moves) {
    placed_ = together_;
    proxies_.clear();
    boxes_.assign(placed_.size(), {});
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      for (Vec3& p : placed_[i].mesh.positions) {
        p += moves[i];
        boxes_[i].add(p);
      }
      proxies_.push_back(&placed_[i]);
    }
    RunContext context;
    occluder_ = std::make_unique<Occluder>(proxies_, context);
  }

  double diagonal() const { return diagonal_; }
  std::size_t size() const { return placed_.size(); }
  const Box3& box(std::size_t part) const { return boxes_[part]; }
  /// How far parts may lie in each other: what a fit has, and the chords.
  double fit(std::size_t a, std::size_t b) const {
    const auto least = [&](std::size_t i) {
      const Vec3 s = boxes_[i].size();
      return std::min({s.x, s.y, s.z});
    };
    return 0.01 * std::min(least(a), least(b)) + 1e-3 * diagonal_;
  }

  /// For each part on a ray the stretches inside it.
  using Stretches = std::map<std::size_t, std::vector<std::pair<double, double>>>;
  Stretches inside(Vec3 origin, Vec3 along) const {
    std::map<std::size_t, std::vector<double>> hits;
    (void)occluder_->occluded_by(origin, along, 0, 1e6 * diagonal_, [&](const Hit& hit) {
      hits[static_cast<std::size_t>(hit.where.part)].push_back(hit.distance);
      return false;
    });
    Stretches stretches;
    for (auto& [part, t] : hits) {
      std::ranges::sort(t);
      // Asked twice about one hit, or through an edge.
      t.erase(std::unique(t.begin(), t.end(),
                          [&](double a, double b) { return b - a < 1e-9 * diagonal_; }),
              t.end());
      if (t.size() % 2 != 0) continue;
      for (std::size_t i = 0; i < t.size(); i += 2) stretches[part].emplace_back(t[i], t[i + 1]);
    }
    return stretches;
  }

 private:
  std::vector<ProxyMesh> together_, placed_;
  std::vector<const ProxyMesh*> proxies_;
  std::vector<Box3> boxes_;
  std::unique_ptr<Occluder> occluder_;
  double diagonal_ = 0;
};

/// Pairs of parts that lie in each other, as rays along three directions over each part see them.
inline std::vector<std::pair<std::size_t, std::size_t>> overlaps(const Placed& placed) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t part = 0; part < placed.size(); ++part) {
    const Rng rng(7, part);
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Vec3 share(rng.uniform(4 * i), rng.uniform(4 * i + 1), rng.uniform(4 * i + 2));
      const Vec3 p = placed.box(part).min + share * placed.box(part).size();
      const Vec3 along = glm::normalize(i % 3 == 0   ? Vec3(1, 0.013, 0.027)
                                        : i % 3 == 1 ? Vec3(0.017, 1, 0.011)
                                                     : Vec3(0.023, 0.019, 1));
      const auto on_ray = placed.inside(p - 20 * placed.diagonal() * along, along);
      const auto own = on_ray.find(part);
      if (own == on_ray.end()) continue;
      for (const auto& [other, stretches] : on_ray) {
        if (other <= part) continue;
        const double eps = placed.fit(part, other);
        for (const auto& a : own->second) {
          for (const auto& b : stretches) {
            if (std::min(a.second, b.second) - std::max(a.first, b.first) > eps) {
              found.emplace_back(part, other);
            }
          }
        }
      }
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// What is in the way of a step, as (moved, other): whether matter of the one, swept by the step,
/// meets matter of the other on a ray and on eight around it.
inline std::vector<std::pair<std::size_t, std::size_t>> in_the_way(const Placed& placed,
                                                                   const ExplodeStep& step) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const Vec3 u = any_orthogonal(step.along), v = glm::cross(step.along, u);
  const auto meets = [&](const Placed::Stretches& ray, std::size_t a, std::size_t b, double eps) {
    const auto one = ray.find(a), other = ray.find(b);
    if (one == ray.end() || other == ray.end()) return false;
    for (const auto& s : one->second) {
      for (const auto& t : other->second) {
        const double from = std::max(s.second, t.first),
                     to = std::min(s.second + step.by, t.second);
        if (to - from > eps) return true;
      }
    }
    return false;
  };
  for (const std::size_t part : step.parts) {
    const Rng rng(11, part);
    for (std::uint64_t i = 0; i < 300; ++i) {
      const Vec3 share(rng.uniform(4 * i), rng.uniform(4 * i + 1), rng.uniform(4 * i + 2));
      const Vec3 p = placed.box(part).min + share * placed.box(part).size() -
                     20 * placed.diagonal() * step.along;
      const auto ray = placed.inside(p, step.along);
      for (const auto& [other, stretches] : ray) {
        if (std::ranges::binary_search(step.parts, other)) continue;
        const double eps = placed.fit(part, other);
        if (!meets(ray, part, other, eps)) continue;
        bool all = true;
        for (int k = 0; k < 8 && all; ++k) {
          const Vec3 off = std::cos(k * kPi / 4) * u + std::sin(k * kPi / 4) * v;
          all = meets(placed.inside(p + eps * off, step.along), part, other, eps);
        }
        if (all) found.emplace_back(part, other);
      }
    }
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Carries steps out one after the other: nothing stands in the way of any, and in the end no parts
/// lie in each other that did not before.
inline void expect_takes_apart(const Scene& scene, const std::vector<ExplodeStep>& steps) {
  const auto name = [&](std::size_t part) {
    std::string path;
    for (const std::string& above : scene.parts[part].assembly) path += above + "/";
    return path + scene.parts[part].name;
  };
  Placed placed(scene);
  const auto before = overlaps(placed);
  std::vector<Vec3> moves(scene.parts.size(), Vec3(0));
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const auto& [part, other] : in_the_way(placed, steps[i])) {
      ADD_FAILURE() << "step " << i << ": " << name(other) << " is in the way of " << name(part);
    }
    for (const std::size_t part : steps[i].parts) moves[part] += steps[i].by * steps[i].along;
    placed.place(moves);
  }
  for (const auto& pair : overlaps(placed)) {
    if (std::ranges::binary_search(before, pair) && moves[pair.first] == moves[pair.second])
      continue;
    ADD_FAILURE() << name(pair.first) << " and " << name(pair.second) << " lie in each other";
  }
}

}  // namespace burin::test
