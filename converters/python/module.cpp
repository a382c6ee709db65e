#include "module.h"

#include <burin/base/version.h>
#include <burin/converters/load_plugins.h>

PYBIND11_MODULE(_burin, module) {
  using namespace burin::python;
  module.doc() = "The compiled part of the package burin.";
  module.attr("__version__") = burin::version();
  add_errors(module);
  add_run(module);
  add_scene(module);
  add_drawing(module);
  add_draw(module);
  add_book(module);
  add_diff(module);
  add_illustration(module);
  add_styles(module);
  add_plugins(module);
  // Keywords and their manuals tell the options of plug-ins, too.
  burin::load_plugins();
}
