// A lantern as binary glTF: metres with y up, one mesh for four posts, a glass that can be seen
// through.
#include "lantern.h"

#include <burin/base/error.h>

#include "kit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>

namespace burin::samples {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr double kArc = 0.05;  // mm between an arc and its chords

TriMesh turned(const std::vector<Corner>& profile, double radius, bool closed = false) {
  Builder builder;
  Outline outline = rounded(profile, closed, kArc);
  if (closed) outline.push_back(outline.front());
  builder.revolve(outline, {0, 0, 0}, {0, 0, 1}, circle_segments(radius, kArc));
  return builder.finish();
}

struct Mesh {
  const char* name;
  TriMesh triangles;
  int material;
};

std::vector<Mesh> meshes() {
  enum : int { Iron, Glass, Wax };
  std::vector<Mesh> all;
  all.push_back({"base", turned({{{0, 0}}, {{34, 0}, 1}, {{34, 8}, 1}, {{0, 8}}}, 34), Iron});
  all.push_back(
      {"glass",
       turned(
           {{{22, 8}}, {{22, 60}, 14}, {{15, 74}}, {{13.5, 74}}, {{20.5, 60}, 12.5}, {{20.5, 8}}},
           22, true),
       Glass});
  all.push_back({"candle",
                 turned({{{0, 8}}, {{9, 8}}, {{9, 36}, 2}, {{1, 36}}, {{1, 41}}, {{0, 41}}}, 9),
                 Wax});
  all.push_back(
      {"roof",
       turned({{{0, 74}}, {{35, 74}}, {{35, 77}}, {{9, 94}}, {{9, 99}}, {{7, 101}, 1}, {{0, 101}}},
              35),
       Iron});
  all.push_back({"post", plate(circle({29, 0}, 2, circle_segments(2)), {}, 66, {}), Iron});
  for (Vec3& p : all.back().triangles.positions) p.z += 8;
  return all;
}

/// The binary part, and what the JSON says of it.
struct Buffer {
  std::string bytes;
  std::vector<std::string> views, accessors;

  template <class T>
  void append(T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void view(std::size_t from, int target) {
    views.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})",
                                from, bytes.size() - from, target));
  }

  void positions(const TriMesh& mesh) {
    constexpr int kVertices = 34962;
    const std::size_t from = bytes.size();
    glm::vec3 low(1e9f), high(-1e9f);
    for (const Vec3& p : mesh.positions) {
      const glm::vec3 point(p.x / 1000, p.z / 1000, -p.y / 1000);
      low = glm::min(low, point), high = glm::max(high, point);
      for (int k = 0; k < 3; ++k) append(point[k]);
    }
    accessors.push_back(fmt::format(
        R"({{"bufferView":{},"componentType":5126,"count":{},"type":"VEC3","min":[{},{},{}],"max":[{},{},{}]}})",
        views.size(), mesh.positions.size(), low.x, low.y, low.z, high.x, high.y, high.z));
    view(from, kVertices);
  }

  void indices(const TriMesh& mesh) {
    constexpr int kIndices = 34963;
    const std::size_t from = bytes.size();
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t corner : t) append(corner);
    }
    accessors.push_back(
        fmt::format(R"({{"bufferView":{},"componentType":5125,"count":{},"type":"SCALAR"}})",
                    views.size(), 3 * mesh.triangles.size()));
    view(from, kIndices);
  }
};

std::string material(const char* name, const char* color, bool clear) {
  return fmt::format(R"({{"name":"{}",{}"pbrMetallicRoughness":{{"baseColorFactor":[{}]}}}})", name,
                     clear ? R"("alphaMode":"BLEND",)" : "", color);
}

std::string json(Buffer& buffer) {
  std::vector<std::string> drawn, nodes;
  const std::vector<Mesh> all = meshes();
  for (std::size_t i = 0; i < all.size(); ++i) {
    buffer.positions(all[i].triangles);
    buffer.indices(all[i].triangles);
    drawn.push_back(fmt::format(
        R"({{"name":"{}","primitives":[{{"attributes":{{"POSITION":{}}},"indices":{},"material":{}}}]}})",
        all[i].name, 2 * i, 2 * i + 1, all[i].material));
    if (i + 1 < all.size()) {
      nodes.push_back(fmt::format(R"({{"name":"{}","mesh":{}}})", all[i].name, i));
    }
  }
  for (int k = 0; k < 4; ++k) {
    const double half = (k + 0.5) * std::numbers::pi / 4;
    nodes.push_back(
        fmt::format(R"({{"name":"post.{:03}","mesh":{},"rotation":[0,{:.9g},0,{:.9g}]}})", k + 1,
                    all.size() - 1, std::sin(half), std::cos(half)));
  }
  std::vector<std::size_t> children(nodes.size());
  for (std::size_t i = 0; i < children.size(); ++i) children[i] = i;
  nodes.push_back(fmt::format(R"({{"name":"lantern","children":[{}]}})", fmt::join(children, ",")));
  const std::vector<std::string> materials = {material("iron", "0.05,0.05,0.06,1", false),
                                              material("glass", "0.7,0.85,0.9,0.25", true),
                                              material("wax", "0.9,0.85,0.6,1", false)};
  std::string text = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],)"
      R"("meshes":[{}],"materials":[{}],"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      nodes.size() - 1, fmt::join(nodes, ","), fmt::join(drawn, ","), fmt::join(materials, ","),
      fmt::join(buffer.accessors, ","), fmt::join(buffer.views, ","), buffer.bytes.size());
  text.resize((text.size() + 3) / 4 * 4, ' ');
  return text;
}

void write_chunk(std::ostream& out, std::uint32_t kind, const std::string& bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  for (const std::uint32_t word : {size, kind}) {
    out.write(reinterpret_cast<const char*>(&word), sizeof word);
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

void write_lantern(const std::filesystem::path& path) {
  constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJson = 0x4E4F534A,
                          kBinary = 0x004E4942;
  Buffer buffer;
  const std::string text = json(buffer);
  const auto size = static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + buffer.bytes.size());
  std::ofstream out(path, std::ios::binary);
  for (const std::uint32_t word : {kMagic, kVersion, size}) {
    out.write(reinterpret_cast<const char*>(&word), sizeof word);
  }
  write_chunk(out, kJson, text);
  write_chunk(out, kBinary, buffer.bytes);
  if (!out) throw OutputError("cannot write", path.string());
}

}  // namespace burin::samples
