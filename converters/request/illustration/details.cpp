#include <burin/base/ascii.h>
#include <burin/converters/values.h>

#include "detail_option.h"
#include "key_row.h"

#include <utility>

namespace burin::detail {
namespace {

const std::vector<KeyRow<DetailView>>& detail_rows() {
  static const std::vector<KeyRow<DetailView>> rows = {
      {.name = "select",
       .schema = one_or_list_of(text("what is drawn larger: a part or an assembly, as in looks")),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DetailView& detail) {
             detail.select = in.text_list(value, path);
             if (detail.select.empty()) in.fail(path, "\"select\" names no parts");
           }},
      {.name = "at",
       .schema = vector_of("instead: the point in its middle, model mm"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  DetailView& detail) { detail.at = in.vector(value, path); }},
      {.name = "radius",
       .schema = {{"description", "model mm"},
                  {"type", "number"},
                  {"minimum", 1e-9},
                  {"maximum", kLarge}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DetailView& detail) {
             detail.radius = in.within(value, path, 1e-9, kLarge, "mm over 0");
           }},
      {.name = "scale",
       .schema = value_of_option("scale"),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, DetailView& detail) {
             const std::string given = option_text(value);
             in.check(draw_rows(), "scale", {given}, path, "scale");
             if (!equal_but_for_case(given, kIsoScale)) {  // which it has without one
               detail.scale = scale_option("scale", given, 1 / kLarge, kLarge);
             }
           }},
      text_row("letter", "its letter (default: the next of A, B, C ...)", &DetailView::letter),
  };
  return rows;
}

DetailView read_detail(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) {
    const std::string given = in.text(value, path);
    in.check(draw_rows(), "detail", {given}, path, "details");
    return detail_option("details", given);
  }
  check_members(detail_rows(), in, value, path);
  if (value.contains("select") == value.contains("at")) {
    in.fail(path, "a detail has \"select\", or \"at\" and \"radius\"");
  }
  DetailView detail;
  read_members(detail_rows(), in, value, path, detail);
  if (value.contains("at") && !value.contains("radius")) {
    in.fail(path, "a detail at a point has \"radius\", in model mm");
  }
  return detail;
}

}  // namespace

void take_details(const KeyedFile& in, const Json& value, const std::string& path,
                  IllustrationFile& out) {
  in.check_array(value, path);
  out.request.details.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string at = fmt::format("{}/{}", path, i);
    out.request.details.push_back(read_detail(in, value[i], at));
    out.request.details.back().place = in.place(at);
  }
}

Json details_schema() {
  const Json short_form = text("a part or an assembly, or X,Y,Z,R in mm; =A:B behind it");
  Json object = object_schema(detail_rows());
  object["oneOf"] = either({"select", "at"});
  object["dependentRequired"]["at"] = Json::array({"radius"});
  return list_of({{"anyOf", {short_form, std::move(object)}}});
}

}  // namespace burin::detail
