#include <burin/base/affine.h>
#include <burin/converters/read.h>

#include "key_row.h"

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

Json matrix_schema() {
  const Json row = {
      {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 4}, {"maxItems", 4}};
  return {{"description",
           "in place of the others: rows of an affine matrix that acts on columns; it may stretch, "
           "shear and mirror"},
          {"type", "array"},
          {"items", row},
          {"minItems", 3},
          {"maxItems", 4}};
}

/// In the order in which they are read: turned, then scaled along the part's own axes.
const std::vector<KeyRow<Placement>>& place_rows() {
  static const std::vector<KeyRow<Placement>> rows = {
      {.name = "translate",
       .schema = vector_of("model mm"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Placement& place) { place.offset = in.vector(value, path); }},
      {.name = "rotate",
       .schema = vector_of("degrees about x, then y, then z; before it is moved"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Placement& place) { place.linear = rotation(in.vector(value, path)); }},
      {.name = "scale",
       .schema = {{"description",
                   "one factor, or three along the part's own x, y and z, before it is turned; "
                   "negative ones mirror"},
                  {"anyOf",
                   {{{"type", "number"}, {"minimum", 1e-9}, {"maximum", 1e9}},
                    vector_of("x, y, z")}}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, Placement& place) {
             const Vec3 scale = scale_of(in, value, path);
             for (int k = 0; k < 3; ++k) place.linear[k] *= scale[k];
             if (!is_invertible(place)) {
               in.fail(path, "the factors of \"scale\" are so far apart that the part is flat");
             }
           }},
      {.name = "matrix",
       .schema = matrix_schema(),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Placement& place) { place = matrix(in, value, path); }},
  };
  return rows;
}

Json place_schema() {
  Json place = object_schema(place_rows());
  place["dependentSchemas"]["matrix"] = {{"maxProperties", 1}};
  return place;
}

Placement placement(const KeyedFile& in, const Json& value, const std::string& path) {
  check_members(place_rows(), in, value, path);
  if (value.contains("matrix") && value.size() > 1) {
    in.fail(path, "\"matrix\" takes no other keys beside it");
  }
  Placement place;
  read_members(place_rows(), in, value, path, place);
  return place;
}

/// An option about reading.
KeyRow<IllustrationInput> reading_row(const RequestRow<ReadOptions>& row) {
  Json schema = value_of_option(row.name());
  if (row.about.many) schema["type"] = {"string", "array", "object"};
  return {.name = row.name(),
          .schema = schema,
          .read =
              [about = row.about, schema](const KeyedFile& in, const Json& value,
                                          const std::string& path, IllustrationInput& input) {
                const std::string& name = about.option.name;
                in.check_type(value, path, schema);
                const std::vector<std::string> given = texts(about, value);
                in.check(read_option_rows(), name, given, path, name);
                if (!given.empty()) input.read[name] = given;
              },
          .write =
              [about = row.about](const IllustrationInput& input) {
                const auto& given = given_texts(input.read, about.option.name);
                if (given.empty()) return Json();
                return about.many ? Json(given) : written_value(about, given.back());
              }};
}

std::vector<KeyRow<IllustrationInput>> input_rows() {
  using Input = IllustrationInput;
  std::vector<KeyRow<Input>> rows = {
      text_row("file", "a model file, seen from the folder of this one", &Input::file),
      text_row("function", "instead of a file: the text of an implicit function", &Input::function),
      text_row("name", "what the part is called, or the assembly that its parts make",
               &Input::name),
      {.name = "place",
       .schema = place_schema(),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Input& input) { input.place = placement(in, value, path); }},
  };
  rows.front().read = [](const KeyedFile& in, const Json& value, const std::string& path,
                         Input& input) { input.file = in.found_path(in.text(value, path)); };
  for (const auto& row : read_option_rows()) rows.push_back(reading_row(row));
  return rows;
}

IllustrationInput input(const std::vector<KeyRow<IllustrationInput>>& rows, const KeyedFile& in,
                        const Json& value, const std::string& path) {
  check_members(rows, in, value, path);
  if (value.contains("file") == value.contains("function")) {
    in.fail(path, "a part has either \"file\" or \"function\"");
  }
  IllustrationInput one;
  one.source = in.source();
  one.line = in.line(path);
  read_members(rows, in, value, path, one);
  return one;
}

}  // namespace

void take_parts(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  in.check_array(value, path);
  if (value.size() > kMostInputs) in.fail(path, "more than 100,000 parts");
  out.inputs.clear();
  const std::vector<KeyRow<IllustrationInput>> rows = input_rows();
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.inputs.push_back(input(rows, in, value[i], fmt::format("{}/{}", path, i)));
  }
}

Json parts_schema() {
  Json part = object_schema(input_rows());
  part["oneOf"] = either({"file", "function"});
  Json list = list_of(std::move(part));
  list["maxItems"] = kMostInputs;
  return list;
}

Json write_parts(const std::vector<IllustrationInput>& inputs) {
  const std::vector<KeyRow<IllustrationInput>> rows = input_rows();
  Json list = Json::array();
  for (const IllustrationInput& one : inputs) list.push_back(write_object(rows, one));
  return list;
}

}  // namespace burin::detail
