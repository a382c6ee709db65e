#include "explode_option.h"
#include "illustration_keyed.h"

namespace burin::detail {
namespace {

void set_way(const KeyedFile& in, Explode& explode, const Json& value, const std::string& path,
             const std::string& key) {
  const bool list = value.is_array() && value.size() == 3;
  const std::string given = list ? option_text(value) : in.text(value, path);
  in.check(draw_rows(), "explode", {given}, path, key);
  set_explode(explode, key, given);
}

Explode::Step step(const KeyedFile& in, const Json& value, const std::string& path) {
  in.check_object(value, path, kStepKeys);
  for (const char* key : {"move", "along", "by"}) {
    if (!value.contains(key)) {
      in.fail(path,
              fmt::format("a step has \"move\", \"along\" and \"by\"; \"{}\" is missing", key));
    }
  }
  Explode::Step step;
  step.place = in.place(path);
  step.move = in.text_list(value["move"], path + "/move");
  if (step.move.empty()) in.fail(path + "/move", "\"move\" names no parts");
  const Vec3 along = in.vector(value["along"], path + "/along");
  const double length = glm::length(along);
  if (!(length > 0 && length < 1e300)) {
    in.fail(path + "/along", "\"along\" takes a direction but 0,0,0");
  }
  step.along = along / length;
  step.by = in.number(value["by"], path + "/by");
  if (!(step.by > 0 && step.by <= 1e12)) {
    in.fail(path + "/by", fmt::format("\"by\" takes mm over 0, not {}: a step moves parts, and "
                                      "\"along\" gives the direction",
                                      value["by"].dump()));
  }
  if (value.contains("trail")) step.trail = in.flag(value["trail"], path + "/trail");
  return step;
}

std::vector<Explode::Step> given_steps(const KeyedFile& in, const Json& value,
                                       const std::string& path) {
  for (const char* other : {"along", "base", "fit"}) {
    if (value.contains(other)) {
      in.fail(fmt::format("{}/{}", path, other),
              fmt::format("\"{}\" is for steps that are found; here \"steps\" are given", other));
    }
  }
  const Json& steps = value["steps"];
  in.check_array(steps, path + "/steps");
  if (steps.empty()) in.fail(path + "/steps", "\"steps\" has none; without it they are found");
  std::vector<Explode::Step> given;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    given.push_back(step(in, steps[i], fmt::format("{}/steps/{}", path, i)));
  }
  return given;
}

}  // namespace

/// As the option has it, or what it is made of.
void take_explode(const KeyedFile& in, const Json& value, const std::string& path,
                  IllustrationFile& out) {
  Explode& explode = out.request.explode;
  explode = {.wanted = true, .place = in.place(path)};
  out.request.explode.json = value.dump();
  if (!value.is_object()) return set_way(in, explode, value, path, "explode");
  in.check_object(value, path, kExplodeKeys);
  if (value.contains("steps")) explode.steps = given_steps(in, value, path);
  if (value.contains("along")) {
    set_way(in, explode, value["along"], path + "/along", "along");
  }
  if (value.contains("base")) {
    explode.base = in.text(value["base"], path + "/base");
    explode.place = in.place(path + "/base");
  }
  if (value.contains("fit")) {
    explode.fit = in.within(value["fit"], path + "/fit", 0, 1e6, "mm from 0");
  }
  if (value.contains("factor")) {
    explode.factor = in.within(value["factor"], path + "/factor", 0, 10, "0 to 10");
  }
}

}  // namespace burin::detail
