#include <burin/base/input_name.h>
#include <burin/converters/file_info.h>

#include "pmi_info.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <utility>

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

/// Without the sign of a zero.
std::string point(const Vec3& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

std::string size(const Box3& b) {
  return fmt::format("{:.6g} x {:.6g} x {:.6g} mm", b.size().x, b.size().y, b.size().z);
}

/// One part in one line.
std::string brief(const PartInfo& p) {
  std::string text;
  for (const std::string& name : p.assembly) text += name + " / ";
  text += p.name + ": ";
  if (p.triangles) text += counted(*p.triangles, "triangle") + ", ";
  if (p.solids.value_or(0) > 1) text += counted(*p.solids, "solid") + ", ";
  text += counted(p.faces, "face") + ", ";
  if (p.edges) text += counted(*p.edges, "edge") + ", ";
  if (p.components) text += counted(*p.components, "component") + ", ";
  text += size(p.bounds) + ", " + surface(p);
  if (p.solids && p.closed()) text += fmt::format(", {:.6g} mm3", p.volume);
  if (!p.color.empty()) text += ", " + p.color;
  if (p.colors > 1) text += fmt::format(", in {} colours", p.colors);
  if (p.opacity < 1) text += fmt::format(", opacity {:.3g}", p.opacity);
  if (p.same_shape_as >= 0) text += fmt::format(", same shape as part {}", p.same_shape_as);
  return text;
}

Json to_json(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json to_json(const Box3& b) {
  return {{"min", to_json(b.min)}, {"max", to_json(b.max)}, {"size", to_json(b.size())}};
}

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
  out["bounds"] = to_json(p.bounds);
  return out;
}

Json to_json(const VolumeInfo& v) {
  Json out = {{"size", v.size}, {"type", v.type}, {"origin", to_json(v.origin)}};
  out["steps"] = Json::array({to_json(v.steps[0]), to_json(v.steps[1]), to_json(v.steps[2])});
  if (!v.space.empty()) out["space"] = v.space;
  out["bounds"] = to_json(v.bounds);
  out["min"] = v.min;
  out["max"] = v.max;
  for (std::size_t k = 0; k < v.percentiles.size(); ++k) {
    out["percentiles"][fmt::format("{}", VolumeInfo::kPercents[k])] = v.percentiles[k];
  }
  out["level"] = v.level;
  return out;
}

/// Lines of label and text.
using Lines = std::vector<std::pair<const char*, std::string>>;

Lines lines_of(const VolumeInfo& v) {
  Lines lines;
  lines.emplace_back("samples",
                     fmt::format("{} x {} x {} of {}", v.size[0], v.size[1], v.size[2], v.type));
  const Vec3 spacing(glm::length(v.steps[0]), glm::length(v.steps[1]), glm::length(v.steps[2]));
  lines.emplace_back("spacing",
                     fmt::format("{:.6g} x {:.6g} x {:.6g} mm", spacing.x, spacing.y, spacing.z));
  const auto direction = [&](int k) { return point(v.steps[k] / spacing[k]); };
  lines.emplace_back("axes", fmt::format("{}, {}, {}", direction(0), direction(1), direction(2)));
  if (!v.space.empty()) lines.emplace_back("space", v.space);
  lines.emplace_back("origin", point(v.origin));
  lines.emplace_back("size", size(v.bounds));
  lines.emplace_back("bounds", fmt::format("{} to {}", point(v.bounds.min), point(v.bounds.max)));
  lines.emplace_back("values", fmt::format("{:.6g} to {:.6g}", v.min, v.max));
  std::string shares;
  for (std::size_t k = 0; k < v.percentiles.size(); ++k) {
    shares += fmt::format("{}{}% below {:.6g}", k > 0 ? ", " : "", VolumeInfo::kPercents[k],
                          v.percentiles[k]);
  }
  lines.emplace_back("shares", shares);
  lines.emplace_back("try", fmt::format("--iso {:.6g}", v.level));
  return lines;
}

Json to_json(const FileInfo& info) {
  Json out;
  out["file"] = info.file;
  out["format"] = info.format;
  if (!info.schema.empty()) out["schema"] = info.schema;
  if (info.volume) out["volume"] = to_json(*info.volume);
  if (!info.volume || !info.parts.empty()) out.update(to_json(info.total()));
  out["parts"] = Json::array();
  for (std::size_t i = 0; i < info.parts.size(); ++i) {
    const PartInfo& p = info.parts[i];
    Json part = {{"id", i}, {"name", p.name}};
    if (!p.assembly.empty()) part["assembly"] = p.assembly;
    if (!p.color.empty()) part["color"] = p.color;
    if (p.colors > 1) part["colors"] = p.colors;
    if (p.opacity < 1) part["opacity"] = p.opacity;
    if (p.same_shape_as >= 0) part["same_shape_as"] = p.same_shape_as;
    part.update(to_json(p));
    if (p.pmi && p.same_shape_as < 0) part["pmi"] = pmi_json(*p.pmi);
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
  if (info.volume) {
    for (const auto& [label, text] : lines_of(*info.volume)) line(label, text);
  }
  const auto defects = [&] {
    if (info.diagnostics.empty()) line("defects", "none");
    for (const Diagnostic& d : info.diagnostics.entries()) {
      line(to_string(d.severity), fmt::format("{} x {}: {}", d.count, d.code, d.message));
    }
  };
  if (info.volume && info.parts.empty()) {
    defects();
    return out;
  }
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
  // A part alone that is called as its file has nothing to tell that does not stand above.
  if (info.parts.size() > 1 || !first.assembly.empty() || !first.color.empty() ||
      first.colors > 1 || first.opacity < 1 ||
      (!info.parts.empty() && first.name != model_stem(info.file))) {
    for (std::size_t i = 0; i < info.parts.size(); ++i) {
      line(fmt::format("part {}", i).c_str(), brief(info.parts[i]));
    }
  }
  for (const PartInfo& part : info.parts) {
    if (!part.pmi || part.same_shape_as >= 0) continue;
    const std::string name = info.parts.size() > 1 ? part.name : std::string();
    for (const auto& [label, text] : pmi_lines(*part.pmi, name)) line(label.c_str(), text);
  }
  defects();
  return out;
}

std::string to_json(std::span<const FileInfo> files) {
  Json out = {{"format", "burin-info"}, {"version", 1}, {"files", Json::array()}};
  for (const FileInfo& f : files) out["files"].push_back(to_json(f));
  // Names are bytes of the input: what is no UTF-8 is replaced.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace burin
