/// burin-probe FILE: loads a plug-in, tries it out and says on descriptor 3 what is wrong with it:
/// "burin-probe 1", then "ok" or "fault TEXT". The host starts it, so that what crashes or hangs
/// does so here.

#include "../table_check.h"
#include "../trial.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

constexpr int kReport = 3;

[[noreturn]] void say(const std::string& text) {
  std::string line = "burin-probe 1\n" + text;
  for (std::size_t i = 14; i < line.size(); ++i) {
    if (static_cast<unsigned char>(line[i]) < ' ') line[i] = ' ';
  }
  line += '\n';
  const bool said = ::write(kReport, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  // No destructors of the plug-in: the host does not run them either.
  ::_exit(said ? 0 : 1);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  void* const library = ::dlopen(argv[1], RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) say(std::string("fault it cannot be loaded: ") + ::dlerror());
  using EntryPoint = const burin_plugin_table* (*)(std::uint32_t);
  const auto entry_point = reinterpret_cast<EntryPoint>(::dlsym(library, "burin_plugin"));
  if (entry_point == nullptr) say("fault it has no symbol burin_plugin");
  const burin_plugin_table* const table = entry_point(BURIN_PLUGIN_ABI);
  std::string fault = burin::plugin::fault_of(table);
  if (fault.empty()) fault = burin::plugin::tried(*table);
  say(fault.empty() ? "ok" : "fault " + fault);
}
