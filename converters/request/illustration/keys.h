#pragma once
// What the keys of illustration files are: reading and the schema are made from them; internal to
// the module.

#include <burin/options/request.h>

#include <string>
#include <vector>

namespace burin::detail {

/// A key of an illustration that is an option of a drawing: "view.from" is "view".
struct IllustrationKey {
  std::string path;
  std::string option;
};

const std::vector<IllustrationKey>& illustration_keys();

/// The option of a drawing or of reading of that name.
const RequestOption& option_named(const std::string& name);

}  // namespace burin::detail
