#include "plugins.h"

#include <burin/base/error.h>
#include <burin/plugin/plugins.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace burin::cli {
namespace {

using plugin::Offer;
using plugin::Plugin;

std::string to_json(const std::vector<Plugin>& plugins) {
  using Json = nlohmann::ordered_json;
  Json all{{"path", Json::array()}, {"plugins", Json::array()}};
  for (const auto& folder : plugin::search_path()) all["path"].push_back(folder.string());
  for (const Plugin& p : plugins) {
    Json one{{"name", p.name}, {"version", p.version}, {"file", p.file}, {"refused", p.refused}};
    one["offers"] = Json::array();
    for (const Offer& o : p.offers) {
      one["offers"].push_back(
          {{"id", o.id}, {"name", o.name}, {"meaning", o.meaning}, {"refused", o.refused}});
    }
    all["plugins"].push_back(std::move(one));
  }
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_text(const std::vector<Plugin>& plugins) {
  std::string text;
  for (const Plugin& p : plugins) {
    if (!p.refused.empty()) {
      text += fmt::format("{}: refused: {}\n", p.file, p.refused);
      continue;
    }
    text += fmt::format("{} {} ({})\n", p.name, p.version, p.file);
    for (const Offer& o : p.offers) {
      text += fmt::format("  {:<20} {:<16} {}\n", o.id, o.name,
                          o.refused.empty() ? o.meaning : "refused: " + o.refused);
    }
  }
  if (!text.empty()) return text;
  text =
      "no plug-ins; these folders are looked through for *.so (see the page plugins.md of the "
      "manual):\n";
  for (const auto& folder : plugin::search_path()) text += fmt::format("  {}\n", folder.string());
  return text;
}

}  // namespace

std::string run_plugins(const PluginsArguments& arguments) {
  if (!plugin::are_loaded()) throw UsageError("plug-ins need Burin with BURIN_PLUGINS");
  const std::vector<Plugin> plugins = plugin::plugins();
  return arguments.json ? to_json(plugins) : to_text(plugins);
}

}  // namespace burin::cli
