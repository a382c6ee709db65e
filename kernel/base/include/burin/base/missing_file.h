#pragma once
/// An input file that does not exist: a type of its own, as programs may want to handle it apart.

#include <burin/base/error.h>

namespace burin {

/// There is no file of that name.
class MissingFile : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace burin
