#pragma once
// Symbols that functions of Python draw; internal to the module.

#include <burin/annotate/label.h>

#include <pybind11/pybind11.h>

namespace burin::python {

/// What such a function gives: "size", and "lines", "fills", "texts", "shoulder", "underlined".
/// With the GIL. Throws as pybind11 where something is none.
Label label_of(const pybind11::dict& given);

}  // namespace burin::python
