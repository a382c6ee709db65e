#pragma once
/// Meshes as the bytes of files, for tests and benchmarks of the readers.

#include <burin/mesh/tri_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

namespace burin::test {

/// The bytes of a number in an order.
template <class T>
std::string raw(T value, std::endian order = std::endian::little) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

inline std::string stl_binary(const TriMesh& m, std::string header = "made by a test") {
  header.resize(80, ' ');
  std::string out = header + raw(static_cast<std::uint32_t>(m.triangles.size()));
  for (const Triangle& t : m.triangles) {
    out.append(12, '\0');
    for (const std::uint32_t v : t) {
      for (int k = 0; k < 3; ++k) out += raw(static_cast<float>(m.positions[v][k]));
    }
    out.append(2, '\0');
  }
  return out;
}

inline std::string stl_ascii(const TriMesh& m, const std::string& name = "part") {
  std::string out = "solid " + name + "\n";
  for (const Triangle& t : m.triangles) {
    out += "  facet normal 0 0 0\n    outer loop\n";
    for (const std::uint32_t v : t) {
      const Vec3& p = m.positions[v];
      fmt::format_to(std::back_inserter(out), "      vertex {} {} {}\n", p.x, p.y, p.z);
    }
    out += "    endloop\n  endfacet\n";
  }
  return out + "endsolid " + name + "\n";
}

inline std::string vertex_lines(const TriMesh& m, const char* prefix) {
  std::string out;
  for (const Vec3& p : m.positions) {
    fmt::format_to(std::back_inserter(out), "{}{} {} {}\n", prefix, p.x, p.y, p.z);
  }
  return out;
}

inline std::string face_lines(const TriMesh& m, const char* prefix, std::uint32_t first) {
  std::string out;
  for (const Triangle& t : m.triangles) {
    fmt::format_to(std::back_inserter(out), "{}{} {} {}\n", prefix, t[0] + first, t[1] + first,
                   t[2] + first);
  }
  return out;
}

inline std::string obj(const TriMesh& m) { return vertex_lines(m, "v ") + face_lines(m, "f ", 1); }

inline std::string off(const TriMesh& m) {
  return fmt::format("OFF\n{} {} 0\n", m.positions.size(), m.triangles.size()) +
         vertex_lines(m, "") + face_lines(m, "3 ", 0);
}

inline std::string ply_ascii(const TriMesh& m) {
  return fmt::format(
             "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
             "property double z\nelement face {}\nproperty list uchar int vertex_indices\n"
             "end_header\n",
             m.positions.size(), m.triangles.size()) +
         vertex_lines(m, "") + face_lines(m, "3 ", 0);
}

inline std::string ply_binary(const TriMesh& m, std::endian order = std::endian::little) {
  std::string out = fmt::format(
      "ply\nformat binary_{}_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      order == std::endian::little ? "little" : "big", m.positions.size(), m.triangles.size());
  for (const Vec3& p : m.positions) {
    for (int k = 0; k < 3; ++k) out += raw(p[k], order);
  }
  for (const Triangle& t : m.triangles) {
    out += '\x03';
    for (const std::uint32_t v : t) out += raw(static_cast<std::int32_t>(v), order);
  }
  return out;
}

}  // namespace burin::test
