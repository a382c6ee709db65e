#include "added.h"

#include <algorithm>
#include <mutex>

namespace burin::plugin {
namespace {

struct Added {
  std::mutex mutex;
  std::vector<Plugin> all;
};

Added& noted() {
  static Added one;
  return one;
}

}  // namespace

std::vector<Plugin> added() {
  const std::lock_guard lock(noted().mutex);
  return noted().all;
}

void note(const std::string& language, const Offer& offer) {
  const std::lock_guard lock(noted().mutex);
  std::vector<Plugin>& all = noted().all;
  auto mine = std::ranges::find(all, language, &Plugin::file);
  if (mine == all.end()) mine = all.insert(mine, Plugin{.file = language});
  std::erase_if(mine->offers,
                [&](const Offer& o) { return o.id == offer.id && o.name == offer.name; });
  mine->offers.push_back(offer);
}

void note_refused(const std::string& name, const std::string& why) {
  const std::lock_guard lock(noted().mutex);
  noted().all.push_back({.file = name, .refused = why});
}

}  // namespace burin::plugin
