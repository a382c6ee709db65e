#include "wishes.h"

#include "text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace burin::detail {
namespace {

using Json = nlohmann::ordered_json;

class Settings {
 public:
  Settings(const TreeParts& all, const std::vector<bool>& made, Diagnostics& diagnostics)
      : all_(all), made_(made), diagnostics_(diagnostics) {
    json_["burin"] = "illustration";
    json_["version"] = 1;
  }

  std::string run() {
    for (std::size_t i = 0; i < all_.parts.size(); ++i) {
      const TreePart& part = all_.parts[i];
      if (made_[i] && (part.background || part.highlight)) ghost(part);
    }
    for (const PartCall& call : all_.calls) say(call);
    if (!all_.views.empty()) view(all_.views.back());
    for (const auto& [what, count] : told_) {
      diagnostics_.add(Severity::Warning, "openscad.mark", count, what);
    }
    return json_.size() > 2 ? json_.dump() : std::string();
  }

 private:
  void tell(const std::string& what) { ++told_[what]; }

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
    tell(fmt::format("burin.scad asks for {}, which this Burin does not know",
                     in_quotes(call.mark.what)));
  }

  void ghost(const TreePart& part) {
    Json look = {{"select", path_of(part)}, {"hatched", false}};
    // What only shows where something is, or was taken away, is no item.
    if (part.background) look["transparent"] = true, look["listed"] = false;
    json_["looks"].push_back(look);
  }

  void ink(const PartCall& call, const std::vector<std::string>& names) {
    const Json& style = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (!style.is_string()) return tell("ink() takes a style, as in ink(\"engraving\") lid();");
    for (const std::string& name : names) {
      json_["looks"].push_back({{"select", name}, {"style", style}});
    }
  }

  void explode(const PartCall& call, const std::vector<std::string>& names) {
    const Json& by = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    const bool numbers = by.is_array() && by.size() == 3 &&
                         std::ranges::all_of(by, [](const Json& v) { return v.is_number(); });
    std::array<double, 3> way{};
    for (std::size_t i = 0; numbers && i < 3; ++i) {
      // A direction: turned as the parts are, not moved.
      for (std::size_t k = 0; k < 3; ++k) way[i] += call.at.row[i][k] * by[k].get<double>();
    }
    const double length = std::hypot(way[0], way[1], way[2]);
    if (!(length > 0))
      return tell("explode() takes lengths in mm, as in explode([0, 0, 30]) lid();");
    json_["explode"]["steps"].push_back(
        {{"move", names}, {"along", {way[0], way[1], way[2]}}, {"by", length}});
  }

  void callout(const PartCall& call, const std::vector<std::string>& names) {
    json_["callouts"] = true;
    const Json& number = call.mark.arguments.empty() ? Json() : call.mark.arguments[0];
    if (number.is_null()) return;
    if (!number.is_number() || number != std::floor(number.get<double>())) {
      return tell("callout() takes a whole number or nothing, as in callout(3) lid();");
    }
    // A loop says it of each of its things.
    Json& item = json_["items"][fmt::format("{:.0f}", number.get<double>())];
    if (item.is_null()) item = {{"select", names.front()}};
  }

  void view(const Mark& mark) {
    const auto given = [&](std::size_t i) {
      return i < mark.arguments.size() && !mark.arguments[i].is_null();
    };
    if (given(0)) json_["view"]["from"] = mark.arguments[0];
    if (given(1)) json_["view"]["up"] = mark.arguments[1];
  }

  const TreeParts& all_;
  const std::vector<bool>& made_;
  Diagnostics& diagnostics_;
  /// What is wrong, and how many times.
  std::map<std::string, std::int64_t> told_;
  Json json_;
};

}  // namespace

std::string settings_of(const TreeParts& parts, const std::vector<bool>& made,
                        Diagnostics& diagnostics) {
  return Settings(parts, made, diagnostics).run();
}

}  // namespace burin::detail
