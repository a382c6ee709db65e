#include "pmi_info.h"

#include <burin/converters/file_info.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

/// A long note is cut in lists; JSON has all of it.
std::string shortened(const std::string& text) {
  constexpr std::size_t kLongest = 90;
  if (text.size() <= kLongest) return text;
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "...";
}

std::string counts(const Pmi& pmi) {
  constexpr std::array<std::pair<PmiKind, const char*>, 6> kKinds{
      {{PmiKind::Dimension, "dimension"},
       {PmiKind::Tolerance, "tolerance"},
       {PmiKind::Datum, "datum"},
       {PmiKind::DatumTarget, "datum target"},
       {PmiKind::Note, "note"},
       {PmiKind::Other, "other annotation"}}};
  std::string text;
  for (const auto& [kind, name] : kKinds) {
    const auto n = std::ranges::count(pmi.items, kind, &PmiItem::kind);
    if (n == 0) continue;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", n, name, n == 1 ? "" : "s");
  }
  std::vector<std::string> views;
  for (const PmiView& view : pmi.views) views.push_back(view.name);
  if (!views.empty()) {
    text += fmt::format("; view{} {}", views.size() == 1 ? "" : "s", fmt::join(views, ", "));
  }
  return text;
}

std::string label_of(PmiKind kind) {
  return kind == PmiKind::DatumTarget ? "target" : to_string(kind);
}

Json numbers(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json json_of(const PmiItem& item) {
  Json out = {{"kind", to_string(item.kind)}, {"what", item.what}, {"text", item.text}};
  if (!item.name.empty()) out["name"] = item.name;
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value) out[key] = *value;
  };
  put("value", item.value);
  put("upper", item.upper);
  put("lower", item.lower);
  put("most", item.most);
  put("least", item.least);
  if (!item.unit.empty()) out["unit"] = item.unit;
  if (!item.fit.empty()) out["fit"] = item.fit;
  if (!item.modifiers.empty()) out["modifiers"] = item.modifiers;
  if (!item.datums.empty()) out["datums"] = item.datums;
  out["faces"] = item.faces;
  if (!item.views.empty()) out["views"] = item.views;
  out["shown"] = item.shown();
  if (item.shown_with >= 0) out["shown_with"] = item.shown_with;
  return out;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> pmi_lines(const Pmi& pmi,
                                                           const std::string& part) {
  std::vector<std::pair<std::string, std::string>> lines{{"pmi", counts(pmi)}};
  for (const PmiItem& item : pmi.items) {
    std::string text = shortened(item.text);
    if (!item.faces.empty()) {
      text += fmt::format("  face{} {}", item.faces.size() == 1 ? "" : "s",
                          fmt::join(item.faces, ", "));
    }
    if (!part.empty()) text += "  part " + part;
    if (!item.shown() && item.shown_with < 0) text += "  (not shown in the file)";
    lines.emplace_back(label_of(item.kind), text);
  }
  return lines;
}

nlohmann::ordered_json pmi_json(const Pmi& pmi) {
  Json out = {{"items", Json::array()}};
  for (const PmiItem& item : pmi.items) out["items"].push_back(json_of(item));
  for (const PmiView& view : pmi.views) {
    out["views"].push_back(
        {{"name", view.name}, {"direction", numbers(view.to_viewer)}, {"up", numbers(view.up)}});
  }
  return out;
}

std::string to_json(const Pmi& pmi) {
  return pmi_json(pmi).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace burin
