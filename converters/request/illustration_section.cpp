#include "illustration_keyed.h"
#include "section_option.h"

namespace burin::detail {
namespace {

/// As the option has it.
Section section_of_text(const KeyedFile& in, const Json& value, const std::string& path) {
  const std::string given = in.text(value, path);
  in.check(draw_rows(), "section", {given}, path, "section");
  return section_option("section", given);
}

SectionPlane plane(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) {
    const Section section = section_of_text(in, value, path);
    if (section.planes.size() != 1) in.fail(path, "takes one plane: x, y, z, or X,Y,Z; =MM");
    return section.planes.front();
  }
  in.check_object(value, path, kPlaneKeys);
  if (!value.contains("normal")) in.fail(path, "a plane has \"normal\", towards what goes");
  SectionPlane plane;
  plane.axis = in.vector(value["normal"], path + "/normal");
  if (plane.axis == Vec3(0)) in.fail(path + "/normal", "\"normal\" takes a direction but 0,0,0");
  plane.axis = glm::normalize(plane.axis);
  plane.side = 1;
  if (value.contains("offset")) plane.offset = in.number(value["offset"], path + "/offset");
  return plane;
}

std::vector<SectionPlane> planes(const KeyedFile& in, const Json& value, const std::string& path) {
  constexpr std::size_t kMost = 64;
  in.check_array(value, path);
  if (value.empty() || value.size() > kMost) in.fail(path, "takes a list of 1 to 64 planes");
  std::vector<SectionPlane> out;
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.push_back(plane(in, value[i], fmt::format("{}/{}", path, i)));
  }
  return out;
}

Section box(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_array() || value.size() != 2) {
    in.fail(path, "\"box\" takes two corners, [[x, y, z], [x, y, z]]");
  }
  const Vec3 low = in.vector(value[0], path + "/0"), high = in.vector(value[1], path + "/1");
  for (int k = 0; k < 3; ++k) {
    if (!(low[k] < high[k])) in.fail(path, "each coordinate of the first corner is the smaller");
  }
  return section_of_box({low, high});
}

Section around(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_object(value, path, kAroundKeys);
  for (const std::string& key : kAroundKeys) {
    if (!value.contains(key)) in.fail(path, fmt::format("\"around\" has \"{}\"", key));
  }
  Section section;
  section.around = {in.vector(value["center"], path + "/center"),
                    in.within(value["radius"], path + "/radius", 1e-9, 1e12, "mm over 0")};
  return section;
}

/// What an object takes away.
Section taken(const KeyedFile& in, const Json& value, const std::string& path) {
  std::vector<std::string> kinds;
  for (const std::string& key : kSectionKeys) {
    if (key != "exclude" && value.contains(key)) kinds.push_back(key);
  }
  if (kinds.size() != 1) {
    in.fail(path, "a section has one of \"plane\", \"planes\", \"steps\", \"box\" and \"around\"");
  }
  const std::string& kind = kinds.front();
  const std::string at = path + "/" + kind;
  const Json& given = value[kind];
  if (kind == "box") return box(in, given, at);
  if (kind == "around") return around(in, given, at);
  if (kind == "plane" && !given.is_object()) return section_of_text(in, given, at);
  Section section;
  section.planes = kind == "plane" ? std::vector{plane(in, given, at)} : planes(in, given, at);
  section.steps = kind == "steps";
  const std::string wrong = section.steps ? wrong_steps(section.planes) : "";
  if (!wrong.empty()) in.fail(at, wrong);
  return section;
}

/// As the option has it, or what goes and what stays whole.
Section section(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) return section_of_text(in, value, path);
  in.check_object(value, path, kSectionKeys);
  Section section = taken(in, value, path);
  if (value.contains("exclude")) {
    section.exclude = in.text_list(value["exclude"], path + "/exclude");
  }
  return section;
}

}  // namespace

void take_sections(const KeyedFile& in, const Json& value, const std::string& path,
                   IllustrationFile& out) {
  const Json list = value.is_array() ? value : Json::array({value});
  out.request.sections.clear();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string at = value.is_array() ? fmt::format("{}/{}", path, i) : path;
    out.request.sections.push_back({section(in, list[i], at), list[i].dump()});
    out.request.sections.back().place = in.place(at);
  }
}

}  // namespace burin::detail
