#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/request.h>
#include <burin/converters/write_book.h>

#include "call.h"
#include "drawing.h"
#include "module.h"
#include "run.h"
#include "scene.h"
#include "text.h"

#include <string>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

/// A step book with the drawings as Python has them.
struct PyBook {
  Book book;
  Style style;
  std::string id_prefix;
  std::vector<DrawingOwner> pages;

  WriteOptions options() const {
    WriteOptions options = write_options(style);
    options.svg.id_prefix = id_prefix;
    return options;
  }
};

py::dict dict_of(const NewPart& part) {
  py::dict d;
  d["item"] = part.item;
  d["name"] = part.name;
  d["quantity"] = part.quantity;
  return d;
}

py::list pages(const PyBook& self) {
  py::list list;
  for (std::size_t i = 0; i < self.pages.size(); ++i) {
    py::dict page;
    page["title"] = self.book.pages[i].title;
    py::list added;
    for (const NewPart& part : self.book.pages[i].added) added.append(dict_of(part));
    page["added"] = added;
    page["scale"] = self.book.pages[i].scale;
    page["drawing"] = self.pages[i];
    list.append(page);
  }
  return list;
}

void save(const PyBook& self, const py::args& paths) {
  std::vector<std::string> names;
  for (const py::handle path : paths) names.push_back(path_text(path));
  if (names.empty()) throw UsageError("no file; name one: save(\"book.pdf\")");
  run(py::none(), nullptr, [&](RunContext& context) {
    std::vector<Output> files = write_book(self.book, names, self.options(), context);
    for (Output& file : files) file.commit();
  });
}

PyBook steps(const py::object& source, std::size_t new_items, const py::kwargs& keywords) {
  if (new_items < 1) throw UsageError("argument new_items takes a whole number from 1");
  Call call(source, keywords);
  if (!call.with.session.is_none()) {
    throw UsageError("argument session is for draw: a step book keeps nothing for the next one");
  }
  DrawPlan& plan = call.plan();
  PyBook book;
  run(call.with.progress, cancel_flag(call.with.cancel), [&](RunContext& context) {
    const ThreadLimit limit(plan.threads);
    Scene scene = call.read(context);
    book.book = draw_book(scene, plan, {new_items}, context);
  });
  book.style = plan.style;
  book.id_prefix = plan.id_prefix;
  for (const BookPage& page : book.book.pages) {
    book.pages.push_back(
        std::make_shared<PyDrawing>(PyDrawing{page.drawing, plan.style, plan.id_prefix}));
  }
  return book;
}

}  // namespace

void add_book(py::module_& module) {
  py::class_<PyBook> book(module, "Book", "How an assembly is put together, a page a step.");
  of_package(book)
      .def_property_readonly(
          "title", [](const PyBook& self) { return self.book.title; }, "What it is called.")
      .def_property_readonly("pages", pages,
                             "A dict a step: \"title\" (the name of a sub-assembly, or empty), "
                             "\"added\" (dicts with \"item\", 0 of a sub-assembly, \"name\" and "
                             "\"quantity\"), \"drawing\".")
      .def_property_readonly(
          "items", [](const PyBook& self) { return to_list(self.book.items); },
          "The parts list, as `Drawing.items`.")
      .def_property_readonly(
          "diagnostics", [](const PyBook& self) { return to_list(self.book.diagnostics); },
          "What was mended, degraded or left out.")
      .def(
          "save", save,
          "Writes NAME.pdf, a page a step; NAME.html, one page; NAME.md, with NAME-step-01.svg and "
          "so on beside it; all of them or none. Throws OutputError, UsageError.");
  module.def("steps", steps, py::arg("source"), py::kw_only(), py::arg("new_items") = 6,
             "Draws how an assembly is put together: the steps of its exploded view backwards. "
             "`new_items`: items that a step adds at the most. Keywords are those of `draw`; those "
             "about one drawing (views, detail, legend, scale ...) have no effect; `diagnostics` "
             "names them. Throws Error.");
}

}  // namespace burin::python
