#include "illustration_keyed.h"

namespace burin::detail {
namespace {

/// As the option has it.
CutText plane_of_text(const KeyedFile& in, const Json& value, const std::string& path) {
  const std::string given = in.text(value, path);
  in.check(draw_rows(), "section", {given}, path, "section");
  return cut_option("section", given);
}

CutText plane(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) return plane_of_text(in, value, path);
  in.check_object(value, path, kPlaneKeys);
  if (!value.contains("normal")) in.fail(path, "a plane has \"normal\", towards what goes");
  CutText plane;
  plane.axis = in.vector(value["normal"], path + "/normal");
  if (plane.axis == Vec3(0)) in.fail(path + "/normal", "\"normal\" takes a direction but 0,0,0");
  plane.axis = glm::normalize(plane.axis);
  plane.side = 1;
  if (value.contains("offset")) plane.offset = in.number(value["offset"], path + "/offset");
  return plane;
}

/// As the option has it, or a plane and what stays whole.
Section section(const KeyedFile& in, const Json& value, const std::string& path) {
  Section section;
  section.place = in.place(path);
  if (!value.is_object()) {
    section.plane = plane_of_text(in, value, path);
    return section;
  }
  in.check_object(value, path, kSectionKeys);
  if (!value.contains("plane")) in.fail(path, "a section has \"plane\"");
  section.plane = plane(in, value["plane"], path + "/plane");
  if (value.contains("exclude")) {
    section.exclude = in.text_list(value["exclude"], path + "/exclude");
  }
  return section;
}

}  // namespace

void take_sections(const KeyedFile& in, const Json& value, const std::string& path,
                   Illustration& out) {
  const Json list = value.is_array() ? value : Json::array({value});
  out.request.sections.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    out.request.sections.push_back(
        section(in, list[i], value.is_array() ? fmt::format("{}/{}", path, i) : path));
  }
}

}  // namespace burin::detail
