#include <burin/converters/values.h>

#include "detail_option.h"
#include "illustration_keyed.h"

#include <utility>

namespace burin::detail {
namespace {

DetailView read_detail(const KeyedFile& in, const Json& value, const std::string& path) {
  DetailView detail;
  if (!value.is_object()) {
    const std::string given = in.text(value, path);
    in.check(draw_rows(), "detail", {given}, path, "details");
    return detail_option("details", given);
  }
  in.check_object(value, path, kDetailKeys);
  if (value.contains("select") == value.contains("at")) {
    in.fail(path, "a detail has \"select\", or \"at\" and \"radius\"");
  }
  if (value.contains("select")) {
    detail.select = in.text_list(value["select"], path + "/select");
    if (detail.select.empty()) in.fail(path + "/select", "\"select\" names no parts");
  } else {
    detail.at = in.vector(value["at"], path + "/at");
    if (!value.contains("radius")) in.fail(path, "a detail at a point has \"radius\", in model mm");
  }
  if (value.contains("radius")) {
    detail.radius = in.within(value["radius"], path + "/radius", 1e-9, kLarge, "mm over 0");
  }
  if (value.contains("scale")) {
    const std::string given = option_text(value["scale"]);
    in.check(draw_rows(), "scale", {given}, path + "/scale", "scale");
    detail.scale = scale_option("scale", given, 1 / kLarge, kLarge);
  }
  if (value.contains("letter")) detail.letter = in.text(value["letter"], path + "/letter");
  return detail;
}

WithEntry<DetailView> detail_of(const KeyedFile& in, const Json& value, const std::string& path) {
  DetailView detail = read_detail(in, value, path);
  detail.place = in.place(path);
  return {std::move(detail), value.dump()};
}

}  // namespace

void take_details(const KeyedFile& in, const Json& value, const std::string& path,
                  IllustrationFile& out) {
  in.check_array(value, path);
  out.request.details.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.request.details.push_back(detail_of(in, value[i], fmt::format("{}/{}", path, i)));
  }
}

}  // namespace burin::detail
