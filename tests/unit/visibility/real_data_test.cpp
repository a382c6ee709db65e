// Real models: no gaps, no specks, and agreement with dense rays that know nothing of cuts.

#include <burin/converters/mesh_reader.h>
#include <burin/repair/repair.h>

#include <burin_test/view.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace burin {
namespace {

using test::View;

View view_of(const std::filesystem::path& path, const ViewOptions& options) {
  const RunContext context;
  Diagnostics diagnostics;
  std::vector<TriMesh> meshes;
  for (PolygonSoup& soup : read_mesh_file(path, context).objects) {
    meshes.push_back(repair(std::move(soup), {}, diagnostics, context));
  }
  return View(std::move(meshes), options);
}

struct Line {
  Vec2 a, b;
  std::size_t curve;
  double at;  // parameter of its middle
};

std::vector<Line> visible_lines(const View& view) {
  std::vector<Line> lines;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    for (const Span& s : view.spans[c]) {
      if (!s.visible) continue;
      for (double at = s.begin; at < s.end;) {
        const double next = std::min(s.end, std::floor(at) + 1);
        lines.push_back({view.camera.to_paper(test::point_at(curve, at)),
                         view.camera.to_paper(test::point_at(curve, next)), c, 0.5 * (at + next)});
        at = next;
      }
    }
  }
  return lines;
}

double distance_to(const Line& line, Vec2 p) {
  const Vec2 d = line.b - line.a;
  const double dd = glm::dot(d, d);
  const double t = dd > 0 ? std::clamp(glm::dot(p - line.a, d) / dd, 0.0, 1.0) : 0;
  return glm::length(line.a + t * d - p);
}

struct Joints {
  int cuts = 0;    // places inside a curve where it becomes visible or hidden at another line
  int gaps = 0;    // those without a visible line within 0.02 mm of paper
  int specks = 0;  // visible pieces of cut curves shorter than 0.2 mm
};

// A change at a vertex where `self_hidden` changes is a cusp, no joint.
bool is_cusp(const Curve3& curve, double at) {
  if (at != std::floor(at) || curve.self_hidden.empty()) return false;
  const std::size_t n = curve.segment_count(), i = static_cast<std::size_t>(at) % n;
  return curve.self_hidden[i] != curve.self_hidden[(i + n - 1) % n];
}

Joints joints(const View& view) {
  const std::vector<Line> lines = visible_lines(view);
  Joints out;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    for (std::size_t k = 0; k + 1 < view.spans[c].size(); ++k) {
      const Span &s = view.spans[c][k], &next = view.spans[c][k + 1];
      if (s.visible == next.visible || is_cusp(curve, s.end)) continue;
      ++out.cuts;
      const Vec2 p = view.camera.to_paper(test::point_at(curve, s.end));
      double nearest = 1e9;
      for (const Line& line : lines) {
        if (line.curve == c && std::abs(line.at - s.end) < 2) continue;
        nearest = std::min(nearest, distance_to(line, p));
      }
      out.gaps += nearest > 0.02;
    }
    for (const Span& s : view.spans[c]) {
      out.specks += s.visible && view.spans[c].size() > 1 && !curve.closed &&
                    test::paper_length(view.camera, curve, s.begin, s.end) < 0.2;
    }
  }
  return out;
}

// A ray from outside the fold that a contour lies on, with no knowledge of triangles but their
// size.
bool plainly_visible(const View& view, const Curve3& curve, std::size_t segment, double t) {
  const auto face = static_cast<std::size_t>(curve.faces[segment]);
  const ProxyMesh& proxy = view.proxies[static_cast<std::size_t>(curve.source.part)];
  double sagitta = 0, edge = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sagitta = std::max(sagitta, static_cast<double>(proxy.wedge_sagitta[proxy.wedges[face][i]]));
    edge = std::max(edge, glm::length(proxy.wedge_position(proxy.wedges[face][i]) -
                                      proxy.wedge_position(proxy.wedges[face][(i + 1) % 3])));
  }
  const double small = 1e-5 * view.occluder->diagonal();
  const bool fold = curve.kind == LineClass::Contour && curve.crease_sign == 0;
  const Vec3 n = normalize_or(
      glm::mix(curve.normals[segment], curve.normals[curve.next(segment)], t), Vec3(0));
  const Vec3 p = glm::mix(curve.points[segment], curve.points[curve.next(segment)], t) +
                 n * (small + (fold ? sagitta : 0));
  return !view.occluder->occluded(p, view.camera.to_viewer(p), fold ? 2 * edge : small,
                                  view.camera.distance_to_viewer(p));
}

// Share of the length on which dense rays say the same.
double agreement(const View& view, double spacing) {
  double same = 0, all = 0;
  for (std::size_t c = 0; c < view.features.size(); ++c) {
    const Curve3& curve = view.features[c];
    for (std::size_t i = 0; i < curve.segment_count(); ++i) {
      if (curve.self_hidden[i]) continue;
      const double length = glm::length(view.camera.to_paper(curve.points[curve.next(i)]) -
                                        view.camera.to_paper(curve.points[i]));
      const int count = static_cast<int>(length / spacing) + 1;
      for (int k = 0; k < count; ++k) {
        const double t = (k + 0.5) / count, at = static_cast<double>(i) + t;
        const auto span = std::ranges::find_if(
            view.spans[c], [&](const Span& s) { return s.begin <= at && at <= s.end; });
        all += length / count;
        if (span->visible == plainly_visible(view, curve, i, t)) same += length / count;
      }
    }
  }
  return same / all;
}

struct Model {
  const char* path;
  Vec3 direction, up;
  int gaps, specks;  // at most
  double agreement;  // at least
};

class RealModel : public testing::TestWithParam<Model> {};

TEST_P(RealModel, HasNoGapsAndNoSpecks) {
  const auto path = test::data(GetParam().path);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const View view = view_of(path, {.direction = GetParam().direction, .up = GetParam().up});
  const Joints j = joints(view);
  EXPECT_GE(j.cuts, 4);
  EXPECT_LE(j.gaps, GetParam().gaps) << "of " << j.cuts;
  EXPECT_LE(j.specks, GetParam().specks);
}

TEST_P(RealModel, AgreesWithDenseRays) {
  const auto path = test::data(GetParam().path);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const View view = view_of(path, {.direction = GetParam().direction, .up = GetParam().up});
  EXPECT_GE(agreement(view, 0.05), GetParam().agreement);
}

constexpr Vec3 kIso{1, -1, 1}, kZ{0, 0, 1}, kY{0, 1, 0};

INSTANTIATE_TEST_SUITE_P(
    VisibleSpans, RealModel,
    testing::Values(Model{"mesh/cgal/fandisk.off", kIso, kZ, 0, 0, 0.99},
                    // Facets that nobody rounds: contours go from their edges into them.
                    Model{"mesh/cgal/knot1.off", kIso, kZ, 3, 1, 0.99},
                    Model{"mesh/cgal/anchor_dense.off", kIso, kZ, 0, 0, 0.99},
                    Model{"mesh/cgal/cheese.off", kIso, kZ, 0, 2, 0.99},
                    Model{"mesh/prusa/extruder-body.stl", kIso, kZ, 0, 1, 0.99},
                    Model{"mesh/prusa/x-end-idler.stl", {-1, -2, 0.7}, kZ, 0, 1, 0.99},
                    Model{"mesh/common3d/stanford-bunny.obj", {0.3, 0.3, 1}, kY, 4, 4, 0.98}),
    [](const auto& parameter) {
      std::string name = std::filesystem::path(parameter.param.path).stem().string();
      std::erase_if(name, [](char ch) { return ch == '-' || ch == '_'; });
      return name;
    });

}  // namespace
}  // namespace burin
