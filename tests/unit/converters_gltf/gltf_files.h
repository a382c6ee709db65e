#pragma once
/// Small glTF files, put together piece by piece.

#include <burin/base/error.h>
#include <burin/converters/gltf_reader.h>

#include <burin_test/folder.h>
#include <burin_test/mesh_checks.h>
#include <burin_test/mesh_files.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace burin::test {

using Json = nlohmann::json;

constexpr int kUByte = 5121, kShort = 5122, kUShort = 5123, kUInt = 5125, kFloat = 5126;

/// The JSON of a glTF and its one buffer.
class Gltf {
 public:
  Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  std::string bytes;

  /// A view of these bytes; its number.
  int view(const std::string& data, int stride = 0) {
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    Json one = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
    if (stride > 0) one["byteStride"] = stride;
    bytes += data;
    json["bufferViews"].push_back(one);
    return static_cast<int>(json["bufferViews"].size()) - 1;
  }
  template <class T>
  static std::string packed(const std::vector<T>& values) {
    std::string out;
    for (const T v : values) out += raw(v);
    return out;
  }
  int accessor(int view, int component, std::size_t count, const char* type) {
    json["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int points(const std::vector<Vec3>& points) {
    std::vector<float> values;
    for (const Vec3& p : points) {
      for (int k = 0; k < 3; ++k) values.push_back(static_cast<float>(p[k]));
    }
    return accessor(view(packed(values)), kFloat, points.size(), "VEC3");
  }
  int indices(const std::vector<std::uint16_t>& values) {
    return accessor(view(packed(values)), kUShort, values.size(), "SCALAR");
  }
  /// A mesh of one primitive of triangles; its number.
  int mesh(const TriMesh& m, const std::string& name = "", int material = -1) {
    std::vector<std::uint16_t> corners;
    for (const Triangle& t : m.triangles) {
      for (const std::uint32_t v : t) corners.push_back(static_cast<std::uint16_t>(v));
    }
    Json primitive = {{"attributes", {{"POSITION", points(m.positions)}}},
                      {"indices", indices(corners)}};
    if (material >= 0) primitive["material"] = material;
    json["meshes"].push_back({{"primitives", Json::array({primitive})}});
    if (!name.empty()) json["meshes"].back()["name"] = name;
    return static_cast<int>(json["meshes"].size()) - 1;
  }
  int node(const Json& node, bool root = true) {
    json["nodes"].push_back(node);
    const int number = static_cast<int>(json["nodes"].size()) - 1;
    if (json["scenes"].empty()) json["scenes"].push_back({{"nodes", Json::array()}});
    if (root) json["scenes"][0]["nodes"].push_back(number);
    return number;
  }

  std::string glb() {
    json["buffers"] = Json::array({{{"byteLength", bytes.size()}}});
    std::string text = json.dump(), data = bytes;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    data.resize((data.size() + 3) / 4 * 4, '\0');
    const auto number = [](std::size_t n) { return raw(static_cast<std::uint32_t>(n)); };
    return "glTF" + number(2) + number(28 + text.size() + data.size()) + number(text.size()) +
           "JSON" + text + number(data.size()) + std::string("BIN\0", 4) + data;
  }
  std::string gltf(const std::string& uri) {
    json["buffers"] = Json::array({{{"byteLength", bytes.size()}, {"uri", uri}}});
    return json.dump();
  }
  std::string data_uri() const {
    constexpr const char* kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out = "data:application/octet-stream;base64,";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const bool there = i + k < bytes.size();
        bits = bits << 8 | (there ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        out += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
      }
    }
    return out;
  }
};

inline Scene read_gltf_bytes(const std::string& bytes, const std::string& name = "a.glb") {
  const TempFile file(name, bytes);
  const RunContext context;
  return read_gltf(file.path(), context);
}

inline Box3 bounds_of(const Scene& scene, std::size_t part) {
  return scene.parts.at(part).form->bounds(Mat3(1));
}

inline void expect_box(const Box3& box, Vec3 low, Vec3 high) {
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.min[k], low[k], 1e-3) << k;
    EXPECT_NEAR(box.max[k], high[k], 1e-3) << k;
  }
}

/// 10 x 20 x 30 mm, in metres; y is up.
inline TriMesh small_box() { return box({0, 0, 0}, {0.01, 0.02, 0.03}); }

}  // namespace burin::test
