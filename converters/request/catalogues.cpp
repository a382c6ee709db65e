#include <burin/base/run_stage.h>
#include <burin/converters/catalogues.h>
#include <burin/converters/request.h>
#include <burin/converters/write.h>

#include <nlohmann/json.hpp>

namespace burin {

std::string catalogues_json() {
  using Json = nlohmann::ordered_json;
  Json all{{"options", Json::array()}, {"style_keys", Json::array()}, {"styles", Json::array()}};
  for (const RequestOption& option : all_options()) {
    all["options"].push_back(Json::parse(request_to_json(option)));
  }
  for (const StyleKey& key : style_keys(builtin_style("technical"))) {
    all["style_keys"].push_back(
        Json::parse(to_json(key, {{"value", key.value}, {"scope", key.scope()}})));
  }
  for (const StyleInfo& style : builtin_styles()) {
    all["styles"].push_back({{"name", style.name}, {"meaning", style.description}});
  }
  for (const StyleInfo& kind : stroke_kinds()) {
    all["stroke_kinds"].push_back({{"name", kind.name}, {"meaning", kind.description}});
  }
  all["formats"] = format_names();
  all["stages"] = run_stage_names();
  return all.dump(1) + "\n";
}

}  // namespace burin
