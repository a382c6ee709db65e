#include <burin/base/ascii.h>
#include <burin/base/error.h>
#include <burin/converters/read_drawing.h>

#include "source.h"
#include "values.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Json = nlohmann::json;

constexpr int kDeepest = 100;

/// Takes each path and layer out of the parsed text as soon as it is whole: a tree of all values
/// would take ten times the memory of the drawing.
class LayerTaker {
 public:
  LayerTaker(std::vector<Layer>& layers, const RunContext& context)
      : layers_(layers), context_(context) {}

  using Event = Json::parse_event_t;
  /// nlohmann's parser callback; false drops the value.
  bool operator()(int depth, Event event, Json& value) {
    switch (event) {
      case Event::key:
        if (depth == kRoot + 1) root_key_ = value.get<std::string>();
        if (depth == kLayer + 1) layer_key_ = value.get<std::string>();
        break;
      case Event::object_start:
      case Event::array_start:
        if (depth > kDeepest) throw InputError(fmt::format("is nested deeper than {}", kDeepest));
        if (depth == kLayers && root_key_ == "layers") layers_.clear();
        if (depth == kLayer) layer_key_.clear();
        if (depth == kLayer || (depth == kPaths && layer_key_ == "paths")) paths_.clear();
        break;
      case Event::object_end:
        return !take(depth, value);
      case Event::array_end:
      case Event::value:
        // Before the layers, which may look otherwise in another version.
        if (depth == kRoot + 1 && root_key_ == "version")
          check_version(JsonPlace(value, "version"));
        if (depth == kPath && root_key_ == "layers" && layer_key_ == "paths") {
          JsonPlace(value, path_place()).check_object();
        }
        if (depth == kLayer && root_key_ == "layers") {
          JsonPlace(value, layer_place()).check_object();
        }
        break;
    }
    return true;
  }

 private:
  // The depths of the values on the way to a path.
  static constexpr int kRoot = 0, kLayers = 1, kLayer = 2, kPaths = 3, kPath = 4;

  std::string layer_place() const { return fmt::format("layers[{}]", layers_.size()); }
  std::string path_place() const {
    return layer_place() + fmt::format(".paths[{}]", paths_.size());
  }

  bool take(int depth, Json& value) {
    if (root_key_ != "layers") return false;
    if (depth == kPath && layer_key_ == "paths") {
      context_.check();
      paths_.push_back(read_path(JsonPlace(value, path_place())));
      return true;
    }
    if (depth != kLayer) return false;
    const JsonPlace place(value, layer_place());
    Layer layer;
    place.optional("name", [&](const JsonPlace& name) { name.set(layer.name); });
    place.optional("paths", [](const JsonPlace& paths) { paths.each([](const auto&, auto) {}); });
    layer.paths = std::exchange(paths_, {});
    place.optional("color", [&](const JsonPlace& color) { read_color(color, layer.color); });
    place.optional("dashes", [&](const JsonPlace& dashes) { read_dashes(dashes, layer.dashes); });
    place.optional("texts", [&](const JsonPlace& texts) {
      texts.each(
          [&](const JsonPlace& text, std::size_t) { layer.texts.push_back(read_text(text)); });
    });
    layers_.push_back(std::move(layer));
    return true;
  }

  std::vector<Layer>& layers_;
  const RunContext& context_;
  std::vector<Path> paths_;
  std::string root_key_, layer_key_;
};

/// What nlohmann says without its number and place: the line says where.
std::string reason(const Json::exception& e, std::string_view rest) {
  for (const std::string_view word : {"NaN", "nan", "Infinity", "inf"}) {
    if (rest.starts_with(word)) return "NaN and Infinity are no numbers of JSON";
  }
  if (dynamic_cast<const Json::out_of_range*>(&e)) return "broken JSON: a number is too large";
  std::string text = e.what();
  const std::size_t dash = text.find(" - ");
  if (dash != std::string::npos) text.erase(0, dash + 3);
  text.resize(std::min<std::size_t>(text.size(), 120));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, ' ');
  return "broken JSON: " + text;
}

/// The word that the byte at `at` belongs to.
std::string_view word_at(std::string_view bytes, std::size_t at) {
  at = std::min(at, bytes.size());
  std::size_t begin = at;
  while (begin > 0 && is_letter(bytes[begin - 1])) --begin;
  return bytes.substr(begin, 20);
}

Drawing read(const Source& source, const RunContext& context) {
  Drawing drawing;
  const std::string_view bytes = source.bytes();
  try {
    const Json root = Json::parse(bytes.begin(), bytes.end(), LayerTaker(drawing.layers, context));
    read_head(JsonPlace(root), drawing);
    JsonPlace(root).required("layers",
                             [](const JsonPlace& list) { list.each([](const auto&, auto) {}); });
  } catch (const Json::parse_error& e) {
    const std::size_t at = std::min(e.byte > 0 ? e.byte - 1 : 0, bytes.size());
    source.fail_at_line(bytes.data() + at, reason(e, word_at(bytes, at)));
  } catch (const Json::exception& e) {
    source.fail(reason(e, ""));
  } catch (const InputError& e) {
    source.fail(e.what());
  }
  return drawing;
}

}  // namespace

Drawing read_drawing(const std::filesystem::path& path, const RunContext& context) {
  return read(Source(path, context), context);
}

Drawing parse_drawing(std::string_view json, const std::string& file, const RunContext& context) {
  return read(Source(file, json, context), context);
}

}  // namespace burin
