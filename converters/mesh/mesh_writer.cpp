#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/converters/mesh_writer.h>

#include "package.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <ostream>

namespace burin {
namespace {

// So many triangles pass between two looks at the run.
constexpr std::size_t kPoll = 65536;

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

template <class T>
void append_bytes(std::string& out, T value) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  out.append(bytes.data(), bytes.size());
}

void append_vector(std::string& out, Vec3 v) {
  for (int k = 0; k < 3; ++k) append_bytes(out, static_cast<float>(v[k]));
}

void write_stl(const TriMesh& mesh, std::ostream& out, const RunContext& context) {
  constexpr std::size_t kHeader = 80;
  std::string block = "Burin";  // a head that begins with "solid" would be taken for text
  block.resize(kHeader, ' ');
  append_bytes(block, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    append_vector(block, mesh.normal(t));
    for (const std::uint32_t v : mesh.triangles[t]) append_vector(block, mesh.positions[v]);
    append_bytes(block, std::uint16_t{0});
    if (t % kPoll != 0) continue;
    context.check();
    out << block;
    block.clear();
  }
  out << block;
}

void write_off(const TriMesh& mesh, std::ostream& out, const RunContext& context) {
  out << fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
  std::size_t count = 0;
  for (const Vec3& p : mesh.positions) {
    if (++count % kPoll == 0) context.check();
    out << fmt::format("{} {} {}\n", p.x, p.y, p.z);
  }
  for (const Triangle& t : mesh.triangles) {
    if (++count % kPoll == 0) context.check();
    out << fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  }
}

/// The core specification of 3MF: a mesh of vertices and triangles, one object, built once.
std::string model_of(const TriMesh& mesh, const RunContext& context) {
  std::string xml;
  const auto add = [&](const std::string& text) { xml += text; };
  add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"millimeter\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<resources><object id=\"1\" type=\"model\"><mesh><vertices>\n");
  std::size_t count = 0;
  for (const Vec3& p : mesh.positions) {
    if (++count % kPoll == 0) context.check();
    add(fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", p.x, p.y, p.z));
  }
  add("</vertices><triangles>\n");
  for (const Triangle& t : mesh.triangles) {
    if (++count % kPoll == 0) context.check();
    add(fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t[0], t[1], t[2]));
  }
  add("</triangles></mesh></object></resources>\n<build><item "
      "objectid=\"1\"/></build>\n</model>\n");
  return xml;
}

void write_3mf(const TriMesh& mesh, std::ostream& out, const RunContext& context) {
  constexpr const char* kTypes =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
      "<Default Extension=\"rels\" "
      "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
      "<Default Extension=\"model\" "
      "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
  constexpr const char* kRelations =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";
  out << zip_archive({{"[Content_Types].xml", kTypes},
                      {"_rels/.rels", kRelations},
                      {"3D/3dmodel.model", model_of(mesh, context)}});
}

constexpr std::array kFormats = {MeshWriter{"stl", "binary STL", write_stl},
                                 MeshWriter{"off", "OFF", write_off},
                                 MeshWriter{"3mf", "3MF", write_3mf}};

}  // namespace

const MeshWriter* mesh_writer_named(std::string_view name) {
  const auto at = std::ranges::find_if(
      kFormats, [&](const MeshWriter& f) { return equal_but_for_case(f.name, name); });
  return at == kFormats.end() ? nullptr : &*at;
}

}  // namespace burin
