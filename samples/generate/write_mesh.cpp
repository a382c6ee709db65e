#include "write_mesh.h"

#include <burin/base/error.h>

#include <fmt/format.h>
#include <zip.h>

#include <cstring>
#include <fstream>

namespace burin::samples {

namespace {

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

void put(std::string& out, Vec3 p) {
  for (int k = 0; k < 3; ++k) put(out, static_cast<float>(p[k]));
}

TriMesh joined(const std::vector<Solid>& solids) {
  TriMesh all;
  for (const Solid& s : solids) {
    const auto base = static_cast<std::uint32_t>(all.positions.size());
    all.positions.insert(all.positions.end(), s.mesh.positions.begin(), s.mesh.positions.end());
    for (const Triangle& t : s.mesh.triangles) {
      all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
  }
  return all;
}

std::string stl(const TriMesh& m) {
  std::string out = "binary STL, mm";
  out.resize(80, ' ');
  put(out, static_cast<std::uint32_t>(m.triangles.size()));
  for (std::uint32_t t = 0; t < m.triangles.size(); ++t) {
    put(out, m.normal(t));
    for (const std::uint32_t v : m.triangles[t]) put(out, m.positions[v]);
    put(out, std::uint16_t{0});
  }
  return out;
}

std::string ply(const TriMesh& m) {
  std::string out = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float "
      "y\nproperty float z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      m.positions.size(), m.triangles.size());
  for (const Vec3& p : m.positions) put(out, p);
  for (const Triangle& t : m.triangles) {
    put(out, std::uint8_t{3});
    for (const std::uint32_t v : t) put(out, v);
  }
  return out;
}

std::string off(const TriMesh& m) {
  std::string out = fmt::format("OFF\n{} {} 0\n", m.positions.size(), m.triangles.size());
  for (const Vec3& p : m.positions) out += fmt::format("{:.7g} {:.7g} {:.7g}\n", p.x, p.y, p.z);
  for (const Triangle& t : m.triangles) out += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return out;
}

std::string obj(const std::vector<Solid>& solids) {
  std::string out = "# mm\n";
  std::uint32_t base = 1;
  for (const Solid& s : solids) {
    out += fmt::format("o {}\n", s.name);
    for (const Vec3& p : s.mesh.positions)
      out += fmt::format("v {:.7g} {:.7g} {:.7g}\n", p.x, p.y, p.z);
    for (const Triangle& t : s.mesh.triangles)
      out += fmt::format("f {} {} {}\n", t[0] + base, t[1] + base, t[2] + base);
    base += static_cast<std::uint32_t>(s.mesh.positions.size());
  }
  return out;
}

std::string model_xml(const std::vector<Solid>& solids) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<resources>\n";
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const TriMesh& m = solids[i].mesh;
    out += fmt::format("<object id=\"{}\" type=\"model\" name=\"{}\"><mesh><vertices>\n", i + 1,
                       solids[i].name);
    for (const Vec3& p : m.positions) {
      out += fmt::format("<vertex x=\"{:.7g}\" y=\"{:.7g}\" z=\"{:.7g}\"/>\n", p.x, p.y, p.z);
    }
    out += "</vertices><triangles>\n";
    for (const Triangle& t : m.triangles) {
      out += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t[0], t[1], t[2]);
    }
    out += "</triangles></mesh></object>\n";
  }
  out += "</resources>\n<build>\n";
  for (std::size_t i = 0; i < solids.size(); ++i)
    out += fmt::format("<item objectid=\"{}\"/>\n", i + 1);
  return out + "</build>\n</model>\n";
}

void write_3mf(const std::vector<Solid>& solids, const std::filesystem::path& path) {
  const std::pair<const char*, std::string> entries[] = {
      {"[Content_Types].xml",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types "
       "xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default "
       "Extension=\"rels\" "
       "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default "
       "Extension=\"model\" "
       "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n"},
      {"_rels/.rels",
       "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships "
       "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
       "Id=\"rel0\" "
       "Target=\"/3D/3dmodel.model\" "
       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n"},
      {"3D/3dmodel.model", model_xml(solids)}};
  int code = 0;
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code);
  if (archive == nullptr) throw OutputError("cannot write", path.string());
  for (const auto& [name, text] : entries) {
    zip_source_t* source = zip_source_buffer(archive, text.data(), text.size(), 0);
    const auto index = zip_file_add(archive, name, source, ZIP_FL_ENC_UTF_8);
    // One fixed date: the same model gives the same bytes.
    if (index >= 0) zip_file_set_mtime(archive, static_cast<zip_uint64_t>(index), 1704067200, 0);
    if (index >= 0)
      zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_DEFLATE, 9);
  }
  if (zip_close(archive) != 0) throw OutputError("cannot write", path.string());
}

}  // namespace

void write(const std::vector<Solid>& solids, const std::filesystem::path& path) {
  const std::string suffix = path.extension().string();
  if (suffix == ".3mf") {
    write_3mf(solids, path);
    return;
  }
  const std::string text = suffix == ".stl"   ? stl(joined(solids))
                           : suffix == ".ply" ? ply(joined(solids))
                           : suffix == ".off" ? off(joined(solids))
                                              : obj(solids);
  std::ofstream out(path, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  if (!out) throw OutputError("cannot write", path.string());
}

}  // namespace burin::samples
