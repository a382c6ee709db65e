#pragma once
// Whether the tables of a plug-in are what plugin.h says; for the host and for burin-probe.

#include <burin/plugin.h>

#include <string>
#include <string_view>

namespace burin::plugin {

/// What a plug-in may have at the most: factories, options of one, words of an option, bytes of a
/// text.
inline constexpr std::size_t kMostFactories = 64, kMostOptions = 64, kMostWords = 64,
                             kLongestText = 1000;

/// Whether this host knows the interface.
bool is_known(std::string_view id);

/// Names of plug-ins and factories, and those of options.
bool is_name(const char* text);
bool is_option_name(const char* text);

/// What is wrong with a table, one sentence; empty where nothing is. Factories of interfaces that
/// the host does not know are looked at no further than their id and name.
std::string fault_of(const burin_plugin_table* table);

}  // namespace burin::plugin
