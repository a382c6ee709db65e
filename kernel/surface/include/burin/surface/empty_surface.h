#pragma once
/// Nothing, as a surface.

#include <burin/surface/surface.h>

#include <memory>

namespace burin {

/// A surface without a point; what stands for parts that are left out.
std::shared_ptr<const Surface> empty_surface();

}  // namespace burin
