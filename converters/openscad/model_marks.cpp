#include "model_marks.h"

#include "text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace burin::detail {
namespace {

using Json = nlohmann::ordered_json;

/// A value as options take it.
std::string option_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& element : value) text += (text.empty() ? "" : ",") + option_text(element);
  return text;
}

class Gatherer {
 public:
  Gatherer(const TreeParts& all, const std::vector<bool>& made, Diagnostics& diagnostics)
      : all_(all), made_(made), diagnostics_(diagnostics) {}

  ModelMarks run() {
    for (std::size_t i = 0; i < all_.parts.size(); ++i) {
      const TreePart& part = all_.parts[i];
      if (made_[i] && (part.background || part.highlight)) ghost(part);
    }
    for (const PartCall& call : all_.calls) say(call);
    if (!all_.views.empty()) view(all_.views.back());
    for (const auto& [what, count] : reported_) {
      diagnostics_.add(Severity::Warning, "openscad.mark", count, what);
    }
    return std::move(marks_);
  }

 private:
  void report(const std::string& what) { ++reported_[what]; }

  static std::string path_of(const TreePart& part) {
    return "/" + (part.assembly.empty() ? part.name : part.assembly + "/" + part.name);
  }

  void say(const PartCall& call) {
    std::vector<std::string> names;
    for (const std::size_t p : call.parts) {
      if (made_[p]) names.push_back(path_of(all_.parts[p]));
    }
    if (names.empty()) return;
    if (call.mark.what == "ink") return ink(call, names);
    if (call.mark.what == "explode") return explode(call, names);
    if (call.mark.what == "callout") return callout(call, names);
    if (call.mark.what == "thread") return thread(call, names);
    if (call.mark.what == "note") return note(call, names);
    if (call.mark.what == "arrow") return arrow(call, names);
    report(fmt::format("burin.scad asks for {}, which this Burin does not know",
                       in_quotes(call.mark.what)));
  }

  void ghost(const TreePart& part) {
    // What only shows where something is, or was taken away, is no item.
    marks_.looks.push_back({.part = path_of(part),
                            .hatched = false,
                            .transparent = part.background,
                            .listed = !part.background});
  }

  void ink(const PartCall& call, const std::vector<std::string>& names) {
    const Json& style = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (!style.is_string()) return report("ink() takes a style, as in ink(\"engraving\") lid();");
    for (const std::string& name : names) {
      marks_.looks.push_back({.part = name, .style = style.get<std::string>()});
    }
  }

  /// The direction that a call has first, turned as the parts are, not moved; 0: none.
  static Vec3 way_of(const PartCall& call) {
    const Json& by = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    const bool numbers = by.is_array() && by.size() == 3 &&
                         std::ranges::all_of(by, [](const Json& v) { return v.is_number(); });
    Vec3 way(0);
    for (int i = 0; numbers && i < 3; ++i) {
      const auto& row = call.at.row[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < 3; ++k) way[i] += row[k] * by[k].get<double>();
    }
    return std::isfinite(std::hypot(way.x, way.y, way.z)) ? way : Vec3(0);
  }

  void arrow(const PartCall& call, const std::vector<std::string>& names) {
    const Vec3 way = way_of(call);
    if (way == Vec3(0)) {
      return report("arrow() takes a direction, as in arrow([0, 0, -1]) screw();");
    }
    for (const std::string& name : names) marks_.arrows.push_back({name, way});
  }

  void explode(const PartCall& call, const std::vector<std::string>& names) {
    const Vec3 way = way_of(call);
    if (way == Vec3(0)) {
      return report("explode() takes lengths in mm, as in explode([0, 0, 30]) lid();");
    }
    marks_.steps.push_back({names, way});
  }

  void callout(const PartCall& call, const std::vector<std::string>& names) {
    marks_.callouts = true;
    const Json& number = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (number.is_null()) return;
    if (!number.is_number() || number != std::floor(number.get<double>())) {
      return report("callout() takes a whole number or nothing, as in callout(3) lid();");
    }
    marks_.items.emplace_back(number.get<double>(), names.front());
  }

  void thread(const PartCall& call, const std::vector<std::string>& names) {
    const Json& arguments = call.mark.arguments;
    const Json size = arguments.empty() ? Json() : arguments[0];
    const Json length = arguments.size() > 1 ? arguments[1] : Json();
    const bool long_enough = length.is_null() || (length.is_number() && length > 0);
    if (!size.is_string() || !long_enough) {
      return report(
          "thread() takes a size and, in mm, a length, as in thread(\"M6\", length = 18) screw();");
    }
    for (const std::string& name : names) {
      marks_.threads.push_back({.part = name, .size = size.get<std::string>()});
      if (length.is_number()) marks_.threads.back().length = length.get<double>();
    }
  }

  void note(const PartCall& call, const std::vector<std::string>& names) {
    const Json& text = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (!text.is_string() || text.get<std::string>().empty()) {
      return report("note() takes words, as in note(\"oil before use\") lid();");
    }
    marks_.notes.push_back({names.front(), text.get<std::string>()});
  }

  void view(const Mark& mark) {
    const auto given = [&](std::size_t i) {
      return i < mark.arguments.size() && !mark.arguments[i].is_null();
    };
    if (given(0)) marks_.view = option_text(mark.arguments[0]);
    if (given(1)) marks_.up = option_text(mark.arguments[1]);
  }

  const TreeParts& all_;
  const std::vector<bool>& made_;
  Diagnostics& diagnostics_;
  /// What is wrong, and how many times.
  std::map<std::string, std::int64_t> reported_;
  ModelMarks marks_;
};

}  // namespace

ModelMarks marks_of(const TreeParts& parts, const std::vector<bool>& made,
                    Diagnostics& diagnostics) {
  return Gatherer(parts, made, diagnostics).run();
}

}  // namespace burin::detail
