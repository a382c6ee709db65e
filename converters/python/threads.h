#pragma once
// Threads of parts as Python has them; internal to the module.

#include <burin/surface/thread.h>

#include <pybind11/pybind11.h>

#include <vector>

namespace burin::python {

/// Mappings with "size", "at", "along", "length" and "internal". Throws UsageError.
std::vector<Thread> threads_of(const pybind11::sequence& given);
pybind11::list list_of(const std::vector<Thread>& threads);

}  // namespace burin::python
