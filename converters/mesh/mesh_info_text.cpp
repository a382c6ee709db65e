#include <burin/converters/mesh_info.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

std::string surface(const PartInfo& p) {
  if (p.closed()) return "closed";
  return fmt::format("open, {} boundary edge{}", p.boundary_edges,
                     p.boundary_edges == 1 ? "" : "s");
}

std::string point(const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

std::string size(const Box3& b) {
  return fmt::format("{:.6g} x {:.6g} x {:.6g} mm", b.size().x, b.size().y, b.size().z);
}

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json to_json(const PartInfo& p) {
  Json out;
  out["vertices"] = p.vertices;
  out["triangles"] = p.triangles;
  out["faces"] = p.faces;
  out["components"] = p.components;
  out["closed"] = p.closed();
  out["boundary_edges"] = p.boundary_edges;
  out["self_intersections"] = p.self_intersections;
  out["area"] = p.area;
  out["volume"] = p.volume;
  out["bounds"] = {{"min", to_json(p.bounds.min)},
                   {"max", to_json(p.bounds.max)},
                   {"size", to_json(p.bounds.size())}};
  return out;
}

Json to_json(const MeshInfo& info) {
  Json out;
  out["file"] = info.file;
  out["format"] = info.format;
  out.update(to_json(info.total()));
  out["parts"] = Json::array();
  for (std::size_t i = 0; i < info.parts.size(); ++i) {
    Json part = {{"id", i}, {"name", info.parts[i].name}};
    part.update(to_json(info.parts[i]));
    out["parts"].push_back(std::move(part));
  }
  out["diagnostics"] = Json::array();
  for (const Diagnostic& d : info.diagnostics.entries()) {
    out["diagnostics"].push_back({{"severity", to_string(d.severity)},
                                  {"code", d.code},
                                  {"count", d.count},
                                  {"message", d.message}});
  }
  return out;
}

}  // namespace

std::string to_text(const MeshInfo& info) {
  const PartInfo all = info.total();
  std::string out = fmt::format("{}: {}\n", info.file, info.format);
  const auto line = [&](const char* label, const std::string& text) {
    fmt::format_to(std::back_inserter(out), "  {:<11} {}\n", label, text);
  };
  line("parts", std::to_string(info.parts.size()));
  line("triangles", std::to_string(all.triangles));
  line("faces", fmt::format("{} (smooth regions)", all.faces));
  line("components", std::to_string(all.components));
  line("size", size(all.bounds));
  line("bounds", fmt::format("{} to {}", point(all.bounds.min), point(all.bounds.max)));
  line("surface", surface(all));
  line("crossings", fmt::format("{} (pairs of triangles that cross)", all.self_intersections));
  if (info.parts.size() > 1) {
    for (std::size_t i = 0; i < info.parts.size(); ++i) {
      const PartInfo& p = info.parts[i];
      line(fmt::format("part {}", i).c_str(),
           fmt::format("{}: {} triangles, {} faces, {} component{}, {}, {}", p.name, p.triangles,
                       p.faces, p.components, p.components == 1 ? "" : "s", size(p.bounds),
                       surface(p)));
    }
  }
  if (info.diagnostics.empty()) line("defects", "none");
  for (const Diagnostic& d : info.diagnostics.entries()) {
    line(to_string(d.severity), fmt::format("{} x {}: {}", d.count, d.code, d.message));
  }
  return out;
}

std::string to_json(std::span<const MeshInfo> files) {
  Json out = {{"format", "burin-info"}, {"version", 1}, {"files", Json::array()}};
  for (const MeshInfo& f : files) out["files"].push_back(to_json(f));
  // Names are bytes of the input: what is no UTF-8 is replaced.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace burin
