#include <burin/converters/file_info.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

std::string counted(std::int64_t n, const char* thing) {
  return fmt::format("{} {}{}", n, thing, n == 1 ? "" : "s");
}

std::string surface(const PartInfo& p) {
  if (p.closed()) return "closed";
  return fmt::format("open, {}", counted(p.boundary_edges, "boundary edge"));
}

std::string point(const Vec3& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

std::string size(const Box3& b) {
  return fmt::format("{:.6g} x {:.6g} x {:.6g} mm", b.size().x, b.size().y, b.size().z);
}

/// One part in one line.
std::string brief(const PartInfo& p) {
  std::string text;
  for (const std::string& name : p.assembly) text += name + " / ";
  text += p.name + ": ";
  if (p.triangles) text += counted(*p.triangles, "triangle") + ", ";
  text += fmt::format("{} faces, ", p.faces);
  if (p.edges) text += counted(*p.edges, "edge") + ", ";
  if (p.components) text += counted(*p.components, "component") + ", ";
  text += size(p.bounds) + ", " + surface(p);
  if (p.solids && p.closed()) text += fmt::format(", {:.6g} mm3", p.volume);
  if (!p.color.empty()) text += ", " + p.color;
  if (p.same_shape_as >= 0) text += fmt::format(", same shape as part {}", p.same_shape_as);
  return text;
}

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

void put(Json& out, const char* key, const std::optional<std::int64_t>& n) {
  if (n) out[key] = *n;
}

Json to_json(const PartInfo& p) {
  Json out;
  put(out, "vertices", p.vertices);
  put(out, "triangles", p.triangles);
  put(out, "solids", p.solids);
  put(out, "shells", p.shells);
  out["faces"] = p.faces;
  put(out, "edges", p.edges);
  put(out, "components", p.components);
  out["closed"] = p.closed();
  out["boundary_edges"] = p.boundary_edges;
  put(out, "self_intersections", p.self_intersections);
  out["area"] = p.area;
  out["volume"] = p.volume;
  out["bounds"] = {{"min", to_json(p.bounds.min)},
                   {"max", to_json(p.bounds.max)},
                   {"size", to_json(p.bounds.size())}};
  return out;
}

Json to_json(const FileInfo& info) {
  Json out;
  out["file"] = info.file;
  out["format"] = info.format;
  if (!info.schema.empty()) out["schema"] = info.schema;
  out.update(to_json(info.total()));
  out["parts"] = Json::array();
  for (std::size_t i = 0; i < info.parts.size(); ++i) {
    const PartInfo& p = info.parts[i];
    Json part = {{"id", i}, {"name", p.name}};
    if (!p.assembly.empty()) part["assembly"] = p.assembly;
    if (!p.color.empty()) part["color"] = p.color;
    if (p.same_shape_as >= 0) part["same_shape_as"] = p.same_shape_as;
    part.update(to_json(p));
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

std::string to_text(const FileInfo& info) {
  const PartInfo all = info.total();
  std::string out = fmt::format("{}: {}\n", info.file, info.format);
  const auto line = [&](const char* label, const std::string& text) {
    fmt::format_to(std::back_inserter(out), "  {:<11} {}\n", label, text);
  };
  const auto number = [&](const char* label, const std::optional<std::int64_t>& n,
                          const char* what = "") {
    if (n) line(label, fmt::format("{}{}", *n, what));
  };
  if (!info.schema.empty()) line("schema", info.schema);
  number("parts", static_cast<std::int64_t>(info.parts.size()));
  number("triangles", all.triangles);
  number("solids", all.solids);
  number("faces", all.faces, all.triangles ? " (smooth regions)" : "");
  number("edges", all.edges);
  number("components", all.components);
  line("size", size(all.bounds));
  line("bounds", fmt::format("{} to {}", point(all.bounds.min), point(all.bounds.max)));
  line("surface", surface(all));
  if (all.solids) line("area", fmt::format("{:.6g} mm2", all.area));
  if (all.solids) line("volume", fmt::format("{:.6g} mm3", all.volume));
  number("crossings", all.self_intersections, " (pairs of triangles that cross)");
  const PartInfo& first = info.parts.empty() ? all : info.parts.front();
  if (info.parts.size() > 1 || !first.assembly.empty() || !first.color.empty()) {
    for (std::size_t i = 0; i < info.parts.size(); ++i) {
      line(fmt::format("part {}", i).c_str(), brief(info.parts[i]));
    }
  }
  if (info.diagnostics.empty()) line("defects", "none");
  for (const Diagnostic& d : info.diagnostics.entries()) {
    line(to_string(d.severity), fmt::format("{} x {}: {}", d.count, d.code, d.message));
  }
  return out;
}

std::string to_json(std::span<const FileInfo> files) {
  Json out = {{"format", "burin-info"}, {"version", 1}, {"files", Json::array()}};
  for (const FileInfo& f : files) out["files"].push_back(to_json(f));
  // Names are bytes of the input: what is no UTF-8 is replaced.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace burin
