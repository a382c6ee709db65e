#include "break_option.h"
#include "key_row.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// A break whose ends are read one after the other.
struct BreakEnds {
  std::optional<Vec3> axis;
  double from = 0, to = 0;
};

KeyRow<BreakEnds> end_row(const char* name, const char* meaning, double BreakEnds::*end) {
  return {.name = name,
          .schema = {{"description", meaning}, {"type", "number"}},
          .read = [end](const KeyedFile& in, const Json& value, const std::string& path,
                        BreakEnds& ends) { ends.*end = in.number(value, path); },
          .missing = "a break has \"{}\", in model mm along its axis"};
}

const std::vector<KeyRow<BreakEnds>>& break_rows() {
  static const std::vector<KeyRow<BreakEnds>> rows = {
      {.name = "axis",
       .schema = {{"anyOf", {text("x, y or z"), vector_of("a direction")}}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, BreakEnds& ends) {
             if (value.is_string()) {
               try {
                 ends.axis = break_axis("axis", value.get<std::string>());
               } catch (const UsageError&) {
                 in.fail(path, "\"axis\" takes x, y, z or [x, y, z]");
               }
               return;
             }
             const Vec3 axis = in.vector(value, path);
             if (axis == Vec3(0)) in.fail(path, "\"axis\" takes a direction but 0,0,0");
             ends.axis = glm::normalize(axis);
           },
       .missing = "a break has an \"{}\": \"x\", \"y\", \"z\" or [x, y, z]"},
      end_row("from", "where it begins, model mm along the axis", &BreakEnds::from),
      end_row("to", "where it ends", &BreakEnds::to),
  };
  return rows;
}

Break read_break(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) {
    const std::string given = in.text(value, path);
    in.check(draw_rows(), "break_view", {given}, path, "breaks");
    return break_option("breaks", given);
  }
  const BreakEnds ends = read_object(break_rows(), in, value, path);
  if (!(ends.from < ends.to)) in.fail(path, "\"from\" is below \"to\"");
  return {.axis = ends.axis, .stretch = std::pair(ends.from, ends.to)};
}

}  // namespace

void take_breaks(const KeyedFile& in, const Json& value, const std::string& path,
                 IllustrationFile& out) {
  const Json list = value.is_array() ? value : Json::array({value});
  out.request.breaks.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = value.is_array() ? fmt::format("{}/{}", path, i) : path;
    out.request.breaks.push_back(read_break(in, list[i], at));
    out.request.breaks.back().place = in.place(at);
  }
}

Json breaks_schema() {
  const Json short_form = text(
      "auto, an axis x, y, z or X,Y,Z, or AXIS:FROM..TO in mm: what of long parts is left out");
  return one_or_list_of({{"anyOf", {short_form, object_schema(break_rows())}}});
}

}  // namespace burin::detail
