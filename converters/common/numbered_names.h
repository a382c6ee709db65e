#pragma once
// Names by which parts differ; for converters alone.

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// Gives " #2", " #3" ... to names that an assembly had before.
class NumberedNames {
 public:
  std::string name(const std::vector<std::string>& assembly, const std::string& wanted) {
    const int n = ++seen_[{assembly, wanted}];
    return n > 1 ? fmt::format("{} #{}", wanted, n) : wanted;
  }

 private:
  std::map<std::pair<std::vector<std::string>, std::string>, int> seen_;
};

}  // namespace burin
