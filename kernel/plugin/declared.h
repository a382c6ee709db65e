#pragma once
// Options of plug-ins as options of ours, and their values back.

#include <burin/options/declared.h>
#include <burin/plugin.h>

#include <span>
#include <string>
#include <vector>

namespace burin::plugin {

std::vector<DeclaredOption> declared(const burin_factory& factory);

/// Values as a plug-in takes them; they live as long as this.
class Values {
 public:
  explicit Values(std::vector<OptionValue> values);
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;
  const burin_value* data() const { return values_.data(); }

 private:
  std::vector<OptionValue> held_;  // with the texts
  std::vector<burin_value> values_;
};

}  // namespace burin::plugin
