#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/base/version.h>
#include <burin/converters/diff.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <ostream>
#include <string_view>

namespace burin {
namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson vector_of(Vec3 v) { return OrderedJson::array({v.x, v.y, v.z}); }

/// Both revisions' numbers; null where there is none.
template <class Get>
OrderedJson pair_of(const PartDifference& part, const Get& get) {
  OrderedJson both = OrderedJson::array();
  for (const auto* numbers : {&part.numbers_before, &part.numbers_after}) {
    both.push_back(*numbers ? OrderedJson(get(**numbers)) : OrderedJson());
  }
  return both;
}

OrderedJson json_of(const PartDifference& part, int item) {
  OrderedJson json;
  json["item"] = item;
  json["change"] = to_string(part.change());
  OrderedJson changes = OrderedJson::array();
  for (const PartChange change : part.changes()) changes.push_back(to_string(change));
  json["changes"] = changes;
  json["old"] = part.numbers_before ? OrderedJson(part.before) : OrderedJson();
  json["new"] = part.numbers_after ? OrderedJson(part.after) : OrderedJson();
  if (part.motion) {
    OrderedJson moved;
    moved["distance"] = glm::length(part.motion->by);
    moved["by"] = vector_of(part.motion->by);
    moved["degrees"] = part.motion->degrees ? OrderedJson(*part.motion->degrees) : OrderedJson();
    moved["axis"] = vector_of(part.motion->axis);
    json["moved"] = moved;
  }
  if (part.match.changed) json["surface_changed"] = part.surface_changed;
  json["volume"] = pair_of(part, [](const PartNumbers& n) { return n.volume; });
  json["area"] = pair_of(part, [](const PartNumbers& n) { return n.area; });
  json["box"] = pair_of(part, [](const PartNumbers& n) { return vector_of(n.box); });
  json["middle"] = pair_of(part, [](const PartNumbers& n) { return vector_of(n.middle); });
  json["faces"] = pair_of(part, [](const PartNumbers& n) { return n.faces; });
  if (part.match.look) {
    json["color"] = OrderedJson::array({part.color_before, part.color_after});
    json["opacity"] = OrderedJson::array({part.opacity_before, part.opacity_after});
    json["face_colors"] = part.match.face_colors;
    json["drawn"] = OrderedJson::array({part.drawn_before, part.drawn_after});
  }
  return json;
}

OrderedJson json_of(const Difference& difference) {
  OrderedJson json;
  json["tolerance"]["place"] = difference.tolerance.place;
  json["tolerance"]["shape"] = difference.tolerance.shape;
  for (std::size_t i = 0; i < kPartChanges; ++i) {
    json["counts"][to_string(static_cast<PartChange>(i))] = difference.counts[i];
  }
  json["parts"] = OrderedJson::array();
  int item = 0;
  for (const PartDifference& part : difference.parts) {
    json["parts"].push_back(json_of(part, ++item));
  }
  return json;
}

OrderedJson json_of(const std::vector<Text>& texts) {
  OrderedJson list = OrderedJson::array();
  for (const Text& text : texts) {
    OrderedJson one;
    one["text"] = text.text;
    one["at"] = OrderedJson::array({text.at.x, text.at.y});
    list.push_back(one);
  }
  return list;
}

OrderedJson json_of(const InkTint& ink) {
  if (ink.ink.empty()) return nullptr;
  return {{"name", ink.ink}, {"tint", ink.tint}};
}

OrderedJson json_of(const LineDifference& difference) {
  OrderedJson json;
  json["tolerance"]["line"] = difference.tolerance;
  json["same_sheet"] = difference.same_sheet;
  for (std::size_t i = 0; i < kLineChanges; ++i) {
    const char* name = to_string(static_cast<LineChange>(i));
    json["counts"][name] = difference.counts[i];
    json["lengths"][name] = difference.lengths[i];
  }
  json["lines"] = OrderedJson::array();
  for (const ChangedLine& line : difference.lines) {
    OrderedJson one;
    one["change"] = to_string(line.change);
    one["part"] = line.part;
    one["layer"] = line.layer;
    one["kind"] = to_string(line.kind);
    one["place"] = OrderedJson::array({line.layer_index, line.path_index});
    one["length"] = line.length;
    if (line.change == LineChange::Moved) one["distance"] = line.distance;
    json["lines"].push_back(one);
  }
  json["fills"] = OrderedJson::array();
  for (const ChangedFill& fill : difference.fills) {
    OrderedJson one;
    one["part"] = fill.part;
    one["color"] = OrderedJson::array({fill.before, fill.after});
    if (!fill.ink_before.ink.empty() || !fill.ink_after.ink.empty()) {
      one["ink"] = OrderedJson::array({json_of(fill.ink_before), json_of(fill.ink_after)});
    }
    one["size"] = fill.size;
    one["at"] = OrderedJson::array({fill.at.x, fill.at.y});
    json["fills"].push_back(one);
  }
  json["inks"] = OrderedJson::array();
  for (const ChangedInk& ink : difference.inks) {
    json["inks"].push_back({{"name", ink.name}, {"color", {ink.before, ink.after}}});
  }
  json["texts_new"] = json_of(difference.texts_new);
  json["texts_gone"] = json_of(difference.texts_gone);
  return json;
}

/// How the names of files of both kinds end.
constexpr std::string_view kDrawingEnd = ".drawing.json";

}  // namespace

bool is_drawing_file(const std::filesystem::path& path) {
  if (lowered(path.extension().string()) != ".json") return false;
  // Programs may write it behind other members, but hardly behind the lines.
  constexpr std::streamsize kLooked = 64 * 1024;
  std::string begin(static_cast<std::size_t>(kLooked), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), kLooked);
  begin.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return begin.find("\"burin-drawing\"") != std::string::npos;
}

std::string difference_text(const DiffOutcome& outcome) {
  std::string text;
  for (const DifferenceRow& row : outcome.rows) {
    if (row.change == "same") continue;
    text +=
        fmt::format("{:8} {}{}{}\n", row.change, row.name, row.what.empty() ? "" : ": ", row.what);
  }
  return text + outcome.counts + "\n";
}

std::string difference_json(const DiffOutcome& outcome) {
  OrderedJson json;
  json["format"] = "burin-difference";
  json["version"] = 1;
  json["generator"] = fmt::format("burin {}", version());
  json["of"] = outcome.models ? "models" : "drawings";
  json["old"] = outcome.before;
  json["new"] = outcome.after;
  json["same"] = outcome.same;
  json.update(outcome.models ? json_of(*outcome.models) : json_of(*outcome.lines));
  json["diagnostics"] = OrderedJson::array();
  for (const Diagnostic& d : outcome.diagnostics.entries()) {
    OrderedJson one;
    one["severity"] = to_string(d.severity);
    one["code"] = d.code;
    one["count"] = d.count;
    one["message"] = d.message;
    json["diagnostics"].push_back(one);
  }
  return json.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

bool is_difference_report(const std::string& name, const Format& format) {
  return format.name == "json" && !lowered(name).ends_with(kDrawingEnd);
}

void write_difference(const DiffOutcome& outcome, const std::string& name, const Format& format,
                      const WriteOptions& options, std::ostream& out, const RunContext& context) {
  if (is_difference_report(name, format)) {
    out << difference_json(outcome);
    return;
  }
  if (!outcome.drawing) throw UsageError("nothing was drawn; ask for the drawing");
  if (format.name == "html") {
    return write_difference_page(*outcome.drawing, outcome.rows, outcome.counts, options, out,
                                 context);
  }
  write_drawing(*outcome.drawing, format, options, out, context);
}

}  // namespace burin
