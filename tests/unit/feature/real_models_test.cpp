// Real meshes: what must hold for the features of any of them, and a few numbers.

#include <burin/converters/mesh_reader.h>
#include <burin/forms/mesh/mesh_form.h>

#include "feature_support.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>
#include <string>

namespace burin::test {
namespace {

using Key = std::array<double, 3>;
Key key(Vec3 p) { return {p.x, p.y, p.z}; }

struct Model {
  std::string file;
  bool closed = true;
  std::size_t most_chains = 0;
};

std::vector<TriMesh> read(const Model& model) {
  const RunContext context;
  const Scene scene = read_mesh(data(model.file), context);
  std::vector<TriMesh> meshes;
  for (const Part& p : scene.parts) {
    meshes.push_back(std::dynamic_pointer_cast<const MeshForm>(p.form)->mesh());
  }
  return meshes;
}

void expect_sound(const Looked& s) {
  for (const Curve3& c : s.curves) {
    const std::size_t n = c.points.size(), m = c.segment_count();
    ASSERT_GE(n, c.closed ? 3u : 2u);
    ASSERT_EQ(c.normals.size(), n);
    ASSERT_EQ(c.faces.size(), m);
    ASSERT_EQ(c.self_hidden.size(), m);
    ASSERT_GE(c.source.part, 0);
    ASSERT_GE(c.source.face, 0);
    const ProxyMesh& proxy = s.proxies[static_cast<std::size_t>(c.source.part)];
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_NEAR(glm::length(c.normals[i]), 1, 1e-9);
      if (i < m) {
        EXPECT_NE(c.points[i], c.points[c.next(i)]);
        EXPECT_EQ(proxy.face_region[static_cast<std::size_t>(c.faces[i])], c.source.face);
      }
    }
  }
}

/// Front and back of a closed surface have closed borders: at any point an even number of contours
/// end.
void expect_closed_contours(const Looked& s) {
  std::map<Key, int> ends;
  for (const Curve3& c : s.of(LineClass::Contour)) {
    if (c.closed) continue;
    ++ends[key(c.points.front())];
    ++ends[key(c.points.back())];
  }
  for (const auto& [point, count] : ends) EXPECT_EQ(count % 2, 0);
}

/// A line shorter than 0.3 mm is there to join others: both its ends lie on other lines.
void expect_no_specks(const Looked& s) {
  std::map<Key, int> touched;
  for (const Curve3& c : s.curves) {
    std::set<Key> points;
    for (const Vec3& p : c.points) points.insert(key(p));
    for (const Key& p : points) ++touched[p];
  }
  for (const Curve3& c : s.curves) {
    double sum = 0;
    for (std::size_t i = 0; i < c.segment_count(); ++i) {
      sum += glm::length(s.camera.to_paper(c.points[c.next(i)]) - s.camera.to_paper(c.points[i]));
    }
    if (sum >= 0.3 || all_hidden(c)) continue;
    // A line that is short because it points to the viewer is none.
    if (length(c) * s.camera.scale() >= 0.3) continue;
    EXPECT_FALSE(c.closed);
    EXPECT_GE(touched[key(c.points.front())], 2);
    EXPECT_GE(touched[key(c.points.back())], 2);
  }
}

class RealModel : public testing::TestWithParam<Model> {};

TEST_P(RealModel, HasSoundFeatures) {
  const Model& model = GetParam();
  if (!std::filesystem::exists(data(model.file))) GTEST_SKIP() << "no " << data(model.file);
  const std::vector<TriMesh> meshes = read(model);
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0, -1, 0), Vec3(0.31, 0.2, -0.8)}) {
    const Looked s(meshes, {.direction = direction});
    expect_sound(s);
    if (model.closed) expect_closed_contours(s);
    expect_no_specks(s);
    std::size_t seen = 0;
    double ink = 0;
    for (const Curve3& c : s.curves) {
      seen += !all_hidden(c);
      ink += open_length(s.camera, c);
    }
    EXPECT_LT(seen, model.most_chains);
    EXPECT_GT(ink, 300);  // an outline on A4 at the least
    EXPECT_LT(ink, 30000);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealModel,
                         testing::Values(Model{"mesh/common3d/stanford-bunny.obj", false, 600},
                                         Model{"mesh/cgal/fandisk.off", true, 60},
                                         Model{"mesh/cgal/knot1.off", true, 24},
                                         Model{"mesh/cgal/anchor_dense.off", true, 100},
                                         Model{"mesh/prusa/extruder-body.stl", true, 1000}),
                         [](const auto& run) {
                           std::string name = std::filesystem::path(run.param.file).stem().string();
                           std::erase_if(name, [](char c) {
                             return std::isalnum(static_cast<unsigned char>(c)) == 0;
                           });
                           return name;
                         });

}  // namespace
}  // namespace burin::test
