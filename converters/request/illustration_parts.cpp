#include <burin/converters/read.h>

#include "illustration_keyed.h"

namespace burin::detail {
namespace {

constexpr std::size_t kMostInputs = 100'000;

/// Of an option that may be given several times: each of a list, NAME=VALUE of an object.
std::vector<std::string> texts(const RequestOption& option, const Json& value) {
  if (!option.many) return {option_text(value)};
  std::vector<std::string> given;
  if (value.is_object()) {
    for (const auto& [name, v] : value.items()) given.push_back(name + "=" + v.dump());
  } else if (value.is_array()) {
    for (const Json& v : value) given.push_back(option_text(v));
  } else {
    given.push_back(option_text(value));
  }
  return given;
}

Placement placement(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_object(value, path, kPlaceKeys);
  Placement place;
  if (value.contains("rotate")) {
    place.linear = rotation(in.vector(value["rotate"], path + "/rotate"));
  }
  if (value.contains("scale")) {
    const double scale = in.number(value["scale"], path + "/scale");
    if (!(scale >= 1e-9 && scale <= 1e9)) in.fail(path + "/scale", "\"scale\" takes 1e-9 to 1e9");
    place.linear *= scale;
  }
  if (value.contains("translate")) {
    place.offset = in.vector(value["translate"], path + "/translate");
  }
  return place;
}

IllustrationInput input(const KeyedFile& in, const Json& value, const std::string& path) {
  std::vector<std::string> known = kInputKeys;
  for (const auto& row : read_option_rows()) known.push_back(row.name());
  in.check_object(value, path, known);
  IllustrationInput one;
  one.source = in.source();
  one.line = in.line(path);
  if (value.contains("file") == value.contains("function")) {
    in.fail(path, "a part has either \"file\" or \"function\"");
  }
  if (value.contains("file")) {
    one.file = in.found_path(in.text(value["file"], path + "/file"));
  } else {
    one.function = in.text(value["function"], path + "/function");
  }
  if (value.contains("name")) one.name = in.text(value["name"], path + "/name");
  if (value.contains("place")) one.place = placement(in, value["place"], path + "/place");
  for (const auto& row : read_option_rows()) {
    const std::string& name = row.name();
    if (!value.contains(name)) continue;
    const std::vector<std::string> given = texts(row.about, value[name]);
    in.check(read_option_rows(), name, given, path + "/" + name, name);
    if (!given.empty()) one.read[name] = given;
  }
  return one;
}

}  // namespace

void take_parts(const KeyedFile& in, const Json& value, const std::string& path,
                Illustration& out) {
  in.check_array(value, path);
  if (value.size() > kMostInputs) in.fail(path, "more than 100,000 parts");
  out.inputs.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.inputs.push_back(input(in, value[i], fmt::format("{}/{}", path, i)));
  }
}

}  // namespace burin::detail
