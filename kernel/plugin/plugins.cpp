#include <burin/base/error.h>
#include <burin/base/platform.h>
#include <burin/plugin/plugins.h>

#include "added.h"
#include "probe.h"
#include "rows.h"
#include "search.h"
#include "table_check.h"
#include "tried_before.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <sstream>
#include <string_view>
#include <utility>

namespace burin::plugin {
namespace {

/// What is loaded in this program.
struct Loaded {
  std::mutex mutex;
  bool looked = false;
  std::vector<Plugin> found;
  /// By what a factory claims, the file that offers it.
  std::map<std::string, std::string> taken;
};

Loaded& loaded() {
  static Loaded all;
  return all;
}

bool is_writer(std::string_view id) { return id == BURIN_WRITER_1 || id == BURIN_WRITER_2; }

/// Whether a table has a newer interface of the same thing.
bool has_newer(const burin_plugin_table& table, const burin_factory& f) {
  if (std::string_view(f.id) != BURIN_WRITER_1) return false;
  for (std::size_t i = 0; i < table.factory_count; ++i) {
    const burin_factory& other = table.factories[i];
    if (std::string_view(other.id) == BURIN_WRITER_2 &&
        std::string_view(suffix_of(other)) == suffix_of(f)) {
      return true;
    }
  }
  return false;
}

/// Adds a factory to its catalogue. Throws UsageError where its name is taken.
void join(const Source& source) {
  const std::string_view id = source.factory->id;
  if (id == BURIN_DIRECTION_1) add_direction(source);
  if (id == BURIN_LAW_1) add_law(source);
  if (id == BURIN_STROKE_KIND_1) add_marks(source);
  if (id == BURIN_FORM_1) add_form(source);
  if (id == BURIN_READER_1) add_reader(source);
  if (is_writer(id)) add_writer(source);
  if (id == BURIN_SYMBOL_1) add_symbol(source);
}

/// What no other file may offer beside a factory: "form gyroids", "suffix .tiny". Directions and
/// stroke kinds share the keys of styles.
std::vector<std::string> claims(const burin_factory& f) {
  const std::string id = f.id;
  if (id == BURIN_DIRECTION_1 || id == BURIN_STROKE_KIND_1) return {std::string("hatch ") + f.name};
  std::vector<std::string> out{id + " " + f.name};
  if (is_writer(id)) out.push_back(std::string("writes ") + suffix_of(f));
  if (id == BURIN_READER_1) {
    std::istringstream words(static_cast<const burin_reader_1*>(f.functions)->suffixes);
    for (std::string word; words >> word;) out.push_back("reads " + word);
  }
  return out;
}

/// Names of Burin's own that only front ends know.
std::vector<Reserved>& reserved() {
  static std::vector<Reserved> all;
  return all;
}

/// Why a factory cannot have what it claims; empty: it can.
std::string claimed(const burin_factory& f, const std::string& file, const Loaded& all) {
  for (const std::string& claim : claims(f)) {
    const auto taken = all.taken.find(claim);
    if (taken != all.taken.end() && taken->second != file) {
      return fmt::format("the name is taken by {}", taken->second);
    }
    for (const Reserved& is_reserved : reserved()) {
      if (is_reserved(claim)) return "the name is taken by Burin's own";
    }
  }
  return {};
}

Offer offered(const burin_plugin_table& table, const burin_factory& factory,
              const std::string& file, Loaded& all) {
  Offer offer{factory.id, factory.name, ""};
  if (!is_known(offer.id)) {
    offer.refused = "this version of Burin does not know the interface";
    return offer;
  }
  offer.meaning = factory.meaning;
  offer.refused = claimed(factory, file, all);
  if (!offer.refused.empty()) return offer;
  try {
    if (!has_newer(table, factory)) join({&factory, file});
    for (const std::string& claim : claims(factory)) all.taken[claim] = file;
  } catch (const std::exception& e) {
    offer.refused = e.what();
  }
  return offer;
}

const burin_plugin_table* table_of(const std::filesystem::path& file, std::string& fault) {
  std::string why;
  void* const library = platform::open_library(file, why);
  if (library == nullptr) {
    fault = fmt::format("it cannot be loaded: {}", why);
    return nullptr;
  }
  using EntryPoint = const burin_plugin_table* (*)(std::uint32_t);
  const auto entry_point =
      reinterpret_cast<EntryPoint>(platform::symbol_in(library, "burin_plugin"));
  if (entry_point == nullptr) {
    fault = "it has no symbol burin_plugin";
    return nullptr;
  }
  const burin_plugin_table* const table = entry_point(BURIN_PLUGIN_ABI);
  fault = fault_of(table);
  return fault.empty() ? table : nullptr;
}

Plugin loaded_from(const std::filesystem::path& file, Loaded& all) {
  Plugin plugin{.file = file.string()};
  const burin_plugin_table* const table = table_of(file, plugin.refused);
  if (table == nullptr) return plugin;
  plugin.name = table->name;
  plugin.version = table->version;
  for (std::size_t i = 0; i < table->factory_count; ++i) {
    plugin.offers.push_back(offered(*table, table->factories[i], plugin.file, all));
  }
  return plugin;
}

/// One file: tried, unless it was before, and loaded.
Plugin take(const std::filesystem::path& file, bool again, Loaded& all, TriedBefore& tried,
            bool& changed) {
  const std::string identity = identity_of(file), by = identity_of(probe_program());
  auto fault = again ? std::nullopt : tried.find(file, identity, by);
  if (!fault) {
    fault = probe(file);
    tried.set(file, identity, by, *fault);
    changed = true;
  }
  if (fault->empty()) return loaded_from(file, all);
  return {.file = file.string(), .refused = *fault};
}

void look(bool again, Loaded& all) {
  std::vector<Plugin>& found = all.found;
  std::vector<std::filesystem::path> relative;
  const std::vector<std::filesystem::path> files = candidates(relative);
  for (const std::filesystem::path& folder : relative) {
    found.push_back(
        {.file = folder.string(), .refused = "BURIN_PLUGIN_PATH takes absolute paths of folders"});
  }
  if (files.empty()) return;
  TriedBefore tried = TriedBefore::load();
  bool changed = false;
  for (const std::filesystem::path& file : files) {
    try {
      found.push_back(take(file, again, all, tried, changed));
    } catch (const std::exception& e) {
      found.push_back({.file = file.string(), .refused = e.what()});
    }
  }
  if (changed) tried.save();
}

}  // namespace

Plugin load(const std::filesystem::path& file) {
  Loaded& all = loaded();
  const std::lock_guard lock(all.mutex);
  return loaded_from(file, all);
}

bool are_loaded() { return true; }

void reserve(Reserved is_reserved) { reserved().push_back(std::move(is_reserved)); }

void load_all(bool again) {
  Loaded& all = loaded();
  const std::lock_guard lock(all.mutex);
  if (all.looked && !again) return;
  all.looked = true;
  all.found.clear();
  try {
    look(again, all);
  } catch (const std::exception& e) {
    all.found.push_back({.file = "plug-ins", .refused = e.what()});
  }
}

std::vector<Plugin> plugins() {
  const std::vector<Plugin> own = added();
  Loaded& all = loaded();
  const std::lock_guard lock(all.mutex);
  std::vector<Plugin> out = all.found;
  out.insert(out.end(), own.begin(), own.end());
  return out;
}

}  // namespace burin::plugin
