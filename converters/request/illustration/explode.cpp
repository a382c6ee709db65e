#include "explode_option.h"
#include "key_row.h"

#include <cstdlib>

namespace burin::detail {
namespace {

/// To twelve digits: without the noise of sums, and nothing moves on any sheet.
double rounded(double value) { return std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr); }

const std::vector<KeyRow<ExplodeStep>>& step_rows() {
  constexpr const char* kMissing = "a step has \"move\", \"along\" and \"by\"; \"{}\" is missing";
  static const std::vector<KeyRow<ExplodeStep>> rows = {
      {.name = "move",
       .schema = one_or_list_of(text("what moves: a part or an assembly, as in looks")),
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, ExplodeStep& step) {
             step.move = in.text_list(value, path);
             if (step.move.empty()) in.fail(path, "\"move\" names no parts");
           },
       .write = [](const ExplodeStep& step) { return Json(step.move); },
       .missing = kMissing},
      {.name = "along",
       .schema = vector_of("the way, in model axes"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ExplodeStep& step) { step.along = way_of(in, value, path); },
       .write =
           [](const ExplodeStep& step) {
             Json along = Json::array();
             for (int k = 0; k < 3; ++k) along.push_back(rounded(step.along[k]) + 0.0);
             return along;
           },
       .missing = kMissing},
      {.name = "by",
       .schema = {{"description", "model mm"},
                  {"type", "number"},
                  {"exclusiveMinimum", 0},
                  {"maximum", 1e12}},
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ExplodeStep& step) { step.by = distance_of(in, value, path); },
       .write = [](const ExplodeStep& step) { return Json(rounded(step.by)); },
       .missing = kMissing},
      {.name = "trail",
       .schema = flag("false: no trail line is drawn"),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ExplodeStep& step) { step.trail = in.flag(value, path); },
       .write = [](const ExplodeStep& step) { return Json(step.trail); }},
  };
  return rows;
}

Json ways() {
  const Json way = text("auto, none, x, y or z, one with a sign, or X,Y,Z");
  return {{"anyOf", {way, vector_of("one way alone")}}};
}

void set_way(const KeyedFile& in, Explode& explode, const Json& value, const std::string& path,
             const std::string& key) {
  const bool list = value.is_array() && value.size() == 3;
  const std::string given = list ? option_text(value) : in.text(value, path);
  in.check(draw_rows(), "explode", {given}, path, key);
  set_explode(explode, key, given);
}

void set_steps(const KeyedFile& in, const Json& value, const std::string& path, Explode& explode) {
  in.check_array(value, path);
  if (value.empty()) in.fail(path, "\"steps\" has none; without it they are found");
  for (std::size_t i = 0; i < value.size(); ++i) {
    const std::string at = fmt::format("{}/{}", path, i);
    explode.steps.push_back(
        read_object(step_rows(), in, value[i], at, ExplodeStep{.place = in.place(at)}));
  }
}

const std::vector<KeyRow<Explode>>& explode_rows() {
  static const std::vector<KeyRow<Explode>> rows = [] {
    Json steps = list_of(object_schema(step_rows()));
    steps["minItems"] = 1;
    return std::vector<KeyRow<Explode>>{
        {.name = "steps",
         .schema = std::move(steps),
         .read = set_steps,
         .write =
             [](const Explode& explode) {
               Json list = Json::array();
               for (const ExplodeStep& step : explode.steps) {
                 list.push_back(write_object(step_rows(), step));
               }
               return list;
             }},
        {.name = "along",
         .schema = ways(),
         .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                    Explode& explode) { set_way(in, explode, value, path, "along"); }},
        {.name = "base",
         .schema = text("the part that stays where steps are found"),
         .read =
             [](const KeyedFile& in, const Json& value, const std::string& path, Explode& explode) {
               explode.base = in.text(value, path);
               explode.place = in.place(path);
             }},
        {.name = "fit",
         .schema = {{"description", "model mm that parts may lie in each other"},
                    {"type", "number"},
                    {"minimum", 0},
                    {"maximum", 1e6}},
         .read =
             [](const KeyedFile& in, const Json& value, const std::string& path, Explode& explode) {
               explode.fit = in.within(value, path, 0, 1e6, "mm from 0");
             }},
        {.name = "factor",
         .schema = {{"type", "number"}, {"minimum", 0}, {"maximum", 10}},
         .read =
             [](const KeyedFile& in, const Json& value, const std::string& path, Explode& explode) {
               explode.factor = in.within(value, path, 0, 10, "0 to 10");
             }},
    };
  }();
  return rows;
}

}  // namespace

Vec3 way_of(const KeyedFile& in, const Json& value, const std::string& path) {
  const Vec3 along = in.vector(value, path);
  const double length = glm::length(along);
  if (!(length > 0 && length < 1e300)) in.fail(path, "\"along\" takes a direction but 0,0,0");
  return along / length;
}

double distance_of(const KeyedFile& in, const Json& value, const std::string& path) {
  const double by = in.number(value, path);
  if (!(by > 0 && by <= 1e12)) {
    in.fail(path, fmt::format("\"by\" takes mm over 0, not {}: a step moves parts, and \"along\" "
                              "gives the direction",
                              value.dump()));
  }
  return by;
}

/// As the option has it, or what it is made of.
void take_explode(const KeyedFile& in, const Json& value, const std::string& path,
                  IllustrationFile& out) {
  Explode& explode = out.request.explode;
  explode = {.wanted = true, .place = in.place(path)};
  if (!value.is_object()) return set_way(in, explode, value, path, "explode");
  check_members(explode_rows(), in, value, path);
  for (const char* other : {"along", "base", "fit"}) {
    if (!value.contains("steps") || !value.contains(other)) continue;
    in.fail(fmt::format("{}/{}", path, other),
            fmt::format("\"{}\" is for steps that are found; here \"steps\" are given", other));
  }
  read_members(explode_rows(), in, value, path, explode);
}

Json explode_schema() {
  Json object = object_schema(explode_rows());
  for (const char* found : {"along", "base", "fit"}) {
    object["dependentSchemas"]["steps"]["properties"][found] = false;
  }
  return {{"anyOf", {ways(), std::move(object)}}};
}

Json write_explode(const Explode& explode) { return write_object(explode_rows(), explode); }

}  // namespace burin::detail
