#pragma once
/// Plug-ins: shared libraries after burin/plugin.h, whose factories become rows of the catalogues.

#include <burin/plugin.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::plugin {

/// A factory of a plug-in, or one that a program added.
struct Offer {
  /// "burin.direction/1".
  std::string id;
  std::string name;
  std::string meaning;
  /// Why it is left out, one sentence; empty: it is not.
  std::string refused = {};
};

struct Plugin {
  /// Empty where it is not known.
  std::string name = {}, version = {};
  /// Of a program: its language, "Python".
  std::string file = {};
  std::vector<Offer> offers = {};
  /// Why nothing of it is used, one sentence; empty: it is.
  std::string refused = {};
};

/// Whether Burin was built to load any (BURIN_PLUGINS).
bool are_loaded();

/// Whether what a factory would bring is taken by something of our own that this module does not
/// know: "writes svg", "reads .stl", "burin.form/1 NAME". To be said before `load_all`.
using Reserved = std::function<bool(std::string_view claim)>;
void reserve(Reserved is_reserved);

/// Folders that are looked through, in this order: those of BURIN_PLUGIN_PATH (absolute paths with
/// ":" between them), the user's ($XDG_DATA_HOME or ~/.local/share, burin/plugins), the system's
/// (burin/plugins beside libburin). Never the folder of an input.
std::vector<std::filesystem::path> search_path();

/// Loads the plug-ins of the search path, once in a program: each .so in its folders, by name. One
/// whose file has not been tried before is tried in a process of its own first (burin-probe, up to
/// 5 s), so that what does not fit, crashes or hangs there is refused and the program goes on.
/// Without such files: three looks at folders. `again`: what was tried is tried again. Never
/// throws.
void load_all(bool again = false);

/// All that `load_all` found, those that were refused too, then what programs added.
std::vector<Plugin> plugins();

/// Whether a file may be loaded: empty, or why not, one sentence. Runs burin-probe.
std::string probe(const std::filesystem::path& file, double timeout = 5);

/// Loads one file that was found good. Its rows join the catalogues, its texts stay for as long as
/// the program. Never throws: see Plugin::refused.
Plugin load(const std::filesystem::path& file);

/// Notes what a program added, for `plugins`.
void note(const std::string& language, const Offer& offer);

/// Notes what a program added and could not use: a package, and why.
void note_refused(const std::string& name, const std::string& why);

/// For tests: what burin-probe reported, as `probe` gives it.
std::string read_report(const std::string& report);

/// Likewise: what was tried before as it is read from a text, written again.
std::string read_tried(const std::string& text);

}  // namespace burin::plugin
