#pragma once
#include <burin/converters/irit_tree.h>

#include "source.h"

namespace burin::irit {

IritObject parse_tree(const Source& source);

}  // namespace burin::irit
