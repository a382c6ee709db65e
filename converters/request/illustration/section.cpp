#include "key_row.h"
#include "section_option.h"

namespace burin::detail {
namespace {

constexpr std::size_t kMostPlanes = 64;

/// As the option has it.
Section section_of_text(const KeyedFile& in, const Json& value, const std::string& path) {
  const std::string given = in.text(value, path);
  in.check(draw_rows(), "section", {given}, path, "section");
  return section_option("section", given);
}

const std::vector<KeyRow<SectionPlane>>& plane_rows() {
  static const std::vector<KeyRow<SectionPlane>> rows = {
      {.name = "normal",
       .schema = vector_of("towards what is taken away"),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path,
              SectionPlane& plane) {
             plane.axis = in.vector(value, path);
             if (plane.axis == Vec3(0)) in.fail(path, "\"normal\" takes a direction but 0,0,0");
             plane.axis = glm::normalize(plane.axis);
             plane.side = 1;
           },
       .missing = "a plane has \"{}\", towards what goes"},
      {.name = "offset",
       .schema = {{"type", "number"}},
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  SectionPlane& plane) { plane.offset = in.number(value, path); }},
  };
  return rows;
}

SectionPlane plane(const KeyedFile& in, const Json& value, const std::string& path) {
  if (value.is_object()) return read_object(plane_rows(), in, value, path);
  const Section section = section_of_text(in, value, path);
  if (section.planes.size() != 1) in.fail(path, "takes one plane: x, y, z, or X,Y,Z; =MM");
  return section.planes.front();
}

std::vector<SectionPlane> planes(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_array(value, path);
  if (value.empty() || value.size() > kMostPlanes) in.fail(path, "takes a list of 1 to 64 planes");
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

const std::vector<KeyRow<Section::Around>>& around_rows() {
  constexpr const char* kMissing = "\"around\" has \"{}\"";
  static const std::vector<KeyRow<Section::Around>> rows = {
      {.name = "center",
       .schema = vector_of("model mm"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Section::Around& around) { around.center = in.vector(value, path); },
       .missing = kMissing},
      {.name = "radius",
       .schema = {{"type", "number"}, {"minimum", 1e-9}, {"maximum", 1e12}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path,
              Section::Around& around) {
             around.radius = in.within(value, path, 1e-9, 1e12, "mm over 0");
           },
       .missing = kMissing},
  };
  return rows;
}

Json text_schema() {
  return text(
      "x, y, z with a sign for the side that goes, or X,Y,Z; =OFFSET in mm; quarter; x,y for what "
      "lies beyond both; y=2,x=10,y=6 for steps");
}

Json planes_schema(const char* what, std::size_t least) {
  Json planes = list_of(
      {{"anyOf",
        {text("x, y, z with a sign, or X,Y,Z; =OFFSET in mm"), object_schema(plane_rows())}}});
  planes["description"] = what;
  planes["minItems"] = least;
  planes["maxItems"] = kMostPlanes;
  return planes;
}

Json described(Json schema, const char* what) {
  schema["description"] = what;
  return schema;
}

Json corners_schema() {
  Json box = described(list_of(vector_of("a corner, model mm")), "what is inside goes");
  box["minItems"] = 2;
  box["maxItems"] = 2;
  return box;
}

/// true, or the letter.
void read_own_view(const KeyedFile& in, const Json& value, const std::string& path,
                   Section& section) {
  if (value.is_boolean()) {
    section.own_view = value.get<bool>();
    return;
  }
  section.letter = in.text(value, path);
  if (section.letter.empty()) in.fail(path, "takes a letter, true or false");
  section.own_view = true;
}

/// What goes, of which a section has one, what stays whole, and whether it has a view of its own.
const std::vector<KeyRow<Section>>& section_rows_of_file() {
  static const std::vector<KeyRow<Section>> rows = {
      {.name = "plane",
       .schema = {{"anyOf", {text_schema(), object_schema(plane_rows())}}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, Section& section) {
             if (value.is_object()) {
               section.planes = {plane(in, value, path)};
             } else {
               section = section_of_text(in, value, path);
             }
           }},
      {.name = "planes",
       .schema = planes_schema("what lies beyond all of them goes", 1),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Section& section) { section.planes = planes(in, value, path); }},
      {.name = "steps",
       .schema = planes_schema("a cut, where it ends, the next cut, and so on", 3),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, Section& section) {
             section.planes = planes(in, value, path);
             section.steps = true;
             const std::string wrong = wrong_steps(section.planes);
             if (!wrong.empty()) in.fail(path, wrong);
           }},
      {.name = "box",
       .schema = corners_schema(),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Section& section) { section = box(in, value, path); }},
      {.name = "around",
       .schema = described(object_schema(around_rows()),
                           "what lies before this place and around it goes"),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, Section& section) {
             section.around = read_object(around_rows(), in, value, path);
           }},
      {.name = "exclude",
       .schema = described(one_or_list_of(text("a selector of parts that stay whole")),
                           "without it: those that drawings leave whole by custom"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  Section& section) { section.exclude = in.text_list(value, path); }},
      {.name = "view",
       .schema = {{"anyOf",
                   {{{"type", "boolean"}},
                    text("the letter of a view of its own: \"A\" for A-A; true: the next one")}}},
       .read = read_own_view},
  };
  return rows;
}

/// Whether a row says what goes.
bool is_kind(const std::string& name) { return name != "exclude" && name != "view"; }

/// The rows of what goes.
std::vector<std::string> kinds_of(const Json& section) {
  std::vector<std::string> kinds;
  for (const KeyRow<Section>& row : section_rows_of_file()) {
    if (is_kind(row.name) && section.contains(row.name)) kinds.push_back(row.name);
  }
  return kinds;
}

/// As the option has it, or what goes and what stays whole.
Section section(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) return section_of_text(in, value, path);
  check_members(section_rows_of_file(), in, value, path);
  if (kinds_of(value).size() != 1) {
    in.fail(path, "a section has one of \"plane\", \"planes\", \"steps\", \"box\" and \"around\"");
  }
  Section section;
  read_members(section_rows_of_file(), in, value, path, section);
  const bool shown_once = section.steps || section.planes.size() == 1;
  if (section.own_view && !shown_once) {
    in.fail(path, "a \"view\" of its own is cut by one plane or in steps");
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
    out.request.sections.push_back(section(in, list[i], at));
    out.request.sections.back().place = in.place(at);
  }
}

Json section_schema() {
  Json section = object_schema(section_rows_of_file());
  std::vector<std::string> kinds = names_of(section_rows_of_file());
  std::erase_if(kinds, [](const std::string& name) { return !is_kind(name); });
  section["oneOf"] = either(kinds);
  return one_or_list_of({{"anyOf", {text_schema(), section}}});
}

}  // namespace burin::detail
