// Models that others made, good and broken: each is read as the list of them says, or refused in
// one clear line.
#include <burin/forms/mesh/mesh_form.h>
#include <burin/repair/repair.h>

#include "reading.h"

#include <cctype>
#include <map>
#include <sstream>

namespace burin {
namespace {

struct Listed {
  std::string path, content;
};

/// The meshes of the list with what it says of them.
std::vector<Listed> listed() {
  std::vector<Listed> out;
  std::ifstream in(test::data("MANIFEST.tsv"));
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> columns;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, '\t');) columns.push_back(cell);
    if (columns.size() < 7) continue;
    const bool ours = columns[0].starts_with("mesh/") || columns[0].starts_with("broken/");
    if (ours && is_mesh_suffix(columns[0])) out.push_back({columns[0], columns[6]});
  }
  return out;
}

/// The whole number that ends where `at` is, e.g. 12 in "12 tris" at 2; -1 where there is none.
std::int64_t number_before(const std::string& content, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(content[begin - 1]))) --begin;
  return begin == at ? -1 : std::stoll(content.substr(begin, at - begin));
}

std::int64_t number(const std::string& content, const std::string& unit) {
  const std::size_t at = content.find(" " + unit);
  return at == std::string::npos ? -1 : number_before(content, at);
}

std::int64_t euler(const std::string& content) {
  const std::size_t at = content.find("chi ");
  return at == std::string::npos ? -999 : std::stoll(content.substr(at + 4));
}

/// What the whole file adds up to after repair; throws where a part is not manifold.
test::MeshNumbers total(const Scene& scene) {
  test::MeshNumbers sum;
  for (const Part& part : scene.parts) {
    const test::MeshNumbers n = test::numbers(dynamic_cast<const MeshForm&>(*part.form).mesh());
    sum.components += n.components;
    sum.boundary_edges += n.boundary_edges;
    sum.euler += n.euler;
  }
  return sum;
}

const std::map<std::string, std::string>& refused() {
  static const std::map<std::string, std::string> table = {
      {"broken/assimp/OutOfMemory.off", "cannot fit into"},
      {"broken/assimp/box_UTF16BE.obj", "UTF-16"},
      {"broken/assimp/invalid.off", "refers to vertex 20"},
      {"broken/assimp/malformed.obj", "refers to vertex 0"},
      {"broken/assimp/number_formats.obj", "'3.1+e2' is not a coordinate"},
      {"broken/derived/count_lies.stl", "claims 4294967280 triangles"},
      {"broken/derived/truncated_ascii.stl", "truncated"},
      {"broken/derived/truncated_binary.stl", "its bytes hold 2777"},
      {"broken/f3d/lfs_pointer_suzanne.stl", "Git LFS pointer"},
      {"broken/trimesh/points_emptyface.ply", "no face"}};
  return table;
}

TEST(RealFiles, EachIsReadManifoldOrRefusedClearly) {
  if (!std::filesystem::exists(test::data("MANIFEST.tsv")))
    GTEST_SKIP() << "no " << test::data("MANIFEST.tsv");
  const RunContext context;
  std::size_t read = 0, errors = 0;
  for (const Listed& l : listed()) {
    const auto expected = refused().find(l.path);
    try {
      const Scene scene = read_mesh(test::data(l.path), context);
      EXPECT_EQ(expected, refused().end()) << l.path << " was read";
      EXPECT_NO_THROW(total(scene)) << l.path;
      ++read;
    } catch (const InputError& e) {
      ++errors;
      ASSERT_NE(expected, refused().end()) << l.path << ": " << e.what();
      EXPECT_NE(std::string(e.what()).find(expected->second), std::string::npos)
          << l.path << ": " << e.what();
    }
  }
  EXPECT_EQ(errors, refused().size());
  EXPECT_GE(read, 90u);
}

TEST(RealFiles, ClosedModelsAreReadAsListed) {
  if (!std::filesystem::exists(test::data("MANIFEST.tsv")))
    GTEST_SKIP() << "no " << test::data("MANIFEST.tsv");
  const RunContext context;
  int compared = 0;
  for (const Listed& l : listed()) {
    const std::int64_t triangles = number(l.content, "tris");
    if (triangles < 0 || refused().contains(l.path) ||
        l.content.find("closed") == std::string::npos)
      continue;
    if (l.content.find("zero-area") != std::string::npos) continue;
    const Scene scene = read_mesh(test::data(l.path), context);
    const bool edges = test::count_of(scene.diagnostics, "mesh.nonmanifold_edges") > 0;
    const bool vertices = test::count_of(scene.diagnostics, "mesh.nonmanifold_vertices") > 0;
    const bool flat = test::count_of(scene.diagnostics, "mesh.zero_area_faces") > 0;
    const test::MeshNumbers n = total(scene);
    EXPECT_EQ(n.boundary_edges, 0) << l.path;
    if (edges || vertices || flat) continue;  // taken apart: more components than connected ones
    std::int64_t sum = 0;
    for (const Part& part : scene.parts) {
      sum += static_cast<std::int64_t>(
          dynamic_cast<const MeshForm&>(*part.form).mesh().triangles.size());
    }
    EXPECT_EQ(sum, triangles) << l.path;
    EXPECT_EQ(n.components, number(l.content, "comp")) << l.path;
    EXPECT_EQ(n.euler, euler(l.content)) << l.path;
    ++compared;
  }
  EXPECT_GE(compared, 50);
}

TEST(RealFiles, BordersAreThoseListed) {
  if (!std::filesystem::exists(test::data("MANIFEST.tsv")))
    GTEST_SKIP() << "no " << test::data("MANIFEST.tsv");
  const RunContext context;
  int compared = 0;
  for (const Listed& l : listed()) {
    const std::int64_t border = number(l.content, "border edges");
    const bool plain = l.content.find(" 0 non-manifold edges") != std::string::npos &&
                       l.content.find("clashes") == std::string::npos;
    if (border < 0 || !plain || refused().contains(l.path)) continue;
    const Scene scene = read_mesh(test::data(l.path), context);
    // The list joins no points; where reading joined some, it found fewer ends.
    const std::int64_t found = total(scene).boundary_edges;
    const bool is_stl = l.path.ends_with("stl") || l.path.ends_with("STL");
    if (is_stl) {
      EXPECT_EQ(found, border) << l.path;
    } else {
      EXPECT_LE(found, border) << l.path;
    }
    ++compared;
  }
  EXPECT_GE(compared, 20);
}

TEST(RealFiles, HugeAndDistantModelsKeepTheirShape) {
  const auto huge = test::data("broken/derived/huge_1e30.obj"),
             spot = test::data("mesh/common3d/spot.obj");
  if (!std::filesystem::exists(huge)) GTEST_SKIP() << "no " << huge;
  const RunContext context;
  const Scene a = read_mesh(huge, context), b = read_mesh(spot, context);
  EXPECT_EQ(total(a).euler, total(b).euler);
  const double ratio = a.bounds().diagonal() / b.bounds().diagonal();
  EXPECT_GT(ratio, 1e29);
  EXPECT_LT(ratio, 1e31);
}

}  // namespace
}  // namespace burin
