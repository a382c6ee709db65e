#include <burin/base/affine.h>
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

/// Rows of four numbers that act on columns; the last one of four may be left out.
Placement matrix(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_array(value, path);
  constexpr const char* kWhat = "\"matrix\" takes three rows of four numbers, or four";
  if (value.size() != 3 && value.size() != 4) in.fail(path, kWhat);
  Placement place;
  for (std::size_t row = 0; row < value.size(); ++row) {
    const std::string at = fmt::format("{}/{}", path, row);
    in.check_array(value[row], at);
    if (value[row].size() != 4) in.fail(at, kWhat);
    for (std::size_t k = 0; k < 4; ++k) {
      const double number = in.number(value[row][k], fmt::format("{}/{}", at, k));
      const auto r = static_cast<int>(row), c = static_cast<int>(k);
      if (row == 3) {
        if (number != (k == 3 ? 1 : 0)) in.fail(at, "the last row of \"matrix\" is 0, 0, 0, 1");
      } else if (k == 3) {
        place.offset[r] = number;
      } else {
        place.linear[c][r] = number;
      }
    }
  }
  if (!is_invertible(place)) in.fail(path, "\"matrix\" flattens the part to nothing");
  return place;
}

/// One factor, or one along each axis, of which negative ones mirror.
Vec3 scale_of(const KeyedFile& in, const Json& value, const std::string& path) {
  constexpr double kMost = 1e9;
  constexpr const char* kWhat =
      "\"scale\" takes 1e-9 to 1e9, or three such factors along x, y and z; negative ones mirror";
  const bool each = value.is_array();
  const Vec3 scale = each ? in.vector(value, path) : Vec3(in.number(value, path));
  for (int k = 0; k < 3; ++k) {
    const double size = each ? std::abs(scale[k]) : scale[k];
    if (!(size >= 1 / kMost && size <= kMost)) in.fail(path, kWhat);
  }
  return scale;
}

Placement placement(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_object(value, path, kPlaceKeys);
  if (value.contains("matrix")) {
    if (value.size() > 1) in.fail(path, "\"matrix\" takes no other keys beside it");
    return matrix(in, value["matrix"], path + "/matrix");
  }
  Placement place;
  if (value.contains("rotate")) {
    place.linear = rotation(in.vector(value["rotate"], path + "/rotate"));
  }
  if (value.contains("scale")) {
    const Vec3 scale = scale_of(in, value["scale"], path + "/scale");
    for (int k = 0; k < 3; ++k) place.linear[k] *= scale[k];
    if (!is_invertible(place)) {
      in.fail(path + "/scale", "the factors of \"scale\" are so far apart that the part is flat");
    }
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
                IllustrationFile& out) {
  in.check_array(value, path);
  if (value.size() > kMostInputs) in.fail(path, "more than 100,000 parts");
  out.inputs.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.inputs.push_back(input(in, value[i], fmt::format("{}/{}", path, i)));
  }
}

}  // namespace burin::detail
