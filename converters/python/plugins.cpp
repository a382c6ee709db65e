#include <burin/annotate/symbols.h>
#include <burin/base/error.h>
#include <burin/base/plugin_error.h>
#include <burin/converters/read.h>
#include <burin/converters/write.h>
#include <burin/drawing/added_formats.h>
#include <burin/field/catalogue.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/plugin/plugins.h>
#include <burin/plugin/sources.h>
#include <burin/tone/catalogue.h>

#include "add_parts.h"
#include "declared.h"
#include "drawing.h"
#include "fields.h"
#include "function.h"
#include "held.h"
#include "module.h"
#include "run.h"
#include "symbols.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <memory>
#include <ostream>
#include <utility>

namespace burin::python {
namespace {

using Options = std::vector<DeclaredOption>;

/// What a program registers: a function by a name, with its options.
struct Registered {
  std::string_view name, meaning;
  std::shared_ptr<py::object> function;
  Options options;

  /// The function with the values of its options as keywords. With the GIL.
  py::object with(const std::vector<OptionValue>& values) const {
    if (options.empty()) return *function;
    return py::module_::import("functools").attr("partial")(*function, **to_dict(options, values));
  }
};

Registered registered(const std::string& name, const py::object& function,
                      const std::string& meaning, const py::object& options) {
  if (!PyCallable_Check(function.ptr())) {
    throw py::type_error(fmt::format("what is registered as '{}' is no function", name));
  }
  return {kept(checked_name(name)), kept(meaning.empty() ? name : meaning), hold(function),
          declared_options(options)};
}

/// The first line of an exception of Python.
std::string first_line(const std::exception& e) {
  const std::string text = e.what();
  return text.substr(0, text.find('\n'));
}

/// Runs what calls Python; what it throws becomes a PluginError. Ctrl-C and the end of a program
/// stay what they are.
template <class Call>
auto guarded(PluginError::Row row, std::string_view name, const Call& call) {
  const auto as_plugin_error = [&](const std::exception& e) {
    return PluginError(row, std::string(name),
                       fmt::format("'{}' of this program fails: {}", name, first_line(e)));
  };
  try {
    return call();
  } catch (const Cancelled&) {
    throw;
  } catch (const PluginError&) {
    throw;
  } catch (py::error_already_set& e) {
    const py::gil_scoped_acquire gil;
    if (!e.matches(PyExc_Exception)) throw;
    throw as_plugin_error(e);
  } catch (const std::exception& e) {
    throw as_plugin_error(e);
  }
}

/// What fields and tones of Python look at, for as long as they live.
struct PluginScene {
  VisibleSurfaces shown;
  Camera camera;
  ViewProbe probe;
  HatchScene scene;

  PluginScene(const VisibleSurfaces& s, const Camera& c)
      : shown(s),
        camera(c),
        probe(probe_of(shown)),
        scene{shown.surfaces, camera, probe, *s.context} {}
  PluginScene(const PluginScene&) = delete;
  PluginScene& operator=(const PluginScene&) = delete;

  static ViewProbe probe_of(const VisibleSurfaces& shown) {
    return [shown](Vec2 paper) -> std::optional<ViewHit> {
      const auto place = shown.at(paper);
      if (!place) return std::nullopt;
      const Surface& surface = *shown.surfaces[static_cast<std::size_t>(place->part)];
      return ViewHit{place->part, place->point,
                     surface.proxy().position(place->point.face, place->point.bary), true};
    };
  }
};

std::shared_ptr<PluginScene> plugin_scene_of(PluginError::Row row, std::string_view name,
                                             const VisibleSurfaces& shown, const Camera& camera) {
  if (!shown.at || shown.context == nullptr) {
    throw PluginError(row, std::string(name),
                      fmt::format("'{}' of this program is for drawings", name));
  }
  return std::make_shared<PluginScene>(shown, camera);
}

Field field_of(const Registered& b, const field::FieldRequest& r) {
  constexpr auto kRow = PluginError::Row::Direction;
  const auto plugin_scene = plugin_scene_of(kRow, b.name, r.shown, r.camera);
  return guarded(kRow, b.name, [&] {
    std::function<Field(const HatchScene&)> make;
    in_python(
        [&] { make = python_field(b.with(values_of(r.options.declared, b.name, b.options))); });
    const Field field = make(plugin_scene->scene);
    return Field{std::string(b.name), [plugin_scene, field, name = b.name](const FieldQuery& q) {
                   return guarded(kRow, name, [&] { return field.cross(q); });
                 }};
  });
}

Tone tone_of(const Registered& b, const tone::LawRequest& r) {
  constexpr auto kRow = PluginError::Row::Law;
  const auto plugin_scene = plugin_scene_of(kRow, b.name, r.shown, r.camera);
  return guarded(kRow, b.name, [&]() -> Tone {
    std::function<Tone(const HatchScene&)> make;
    in_python(
        [&] { make = python_tone(b.with(values_of(r.options.declared, b.name, b.options))); });
    return [plugin_scene, tone = make(plugin_scene->scene), name = b.name](Vec3 position,
                                                                           Vec3 normal) {
      return guarded(kRow, name, [&] { return tone(position, normal); });
    };
  });
}

/// What `register` says of a name that is not free, and what lists say of the rest.
void note(const char* id, const Registered& b, const std::function<void()>& add) {
  add();
  plugin::note("Python", {id, std::string(b.name), std::string(b.meaning)});
}

void register_direction(const std::string& name, const py::object& function,
                        const std::string& meaning, const py::object& options) {
  const Registered b = registered(name, function, meaning, options);
  note(BURIN_DIRECTION_1, b, [&] {
    field::add({.name = b.name,
                .meaning = b.meaning,
                .missing = "the function gives it no direction there",
                .make = [b](const field::FieldRequest& r) { return field_of(b, r); },
                .options = b.options});
  });
}

void register_law(const std::string& name, const py::object& function, const std::string& meaning,
                  const py::object& options) {
  const Registered b = registered(name, function, meaning, options);
  note(BURIN_LAW_1, b, [&] {
    tone::add({.name = b.name,
               .meaning = b.meaning,
               .make = [b](const tone::LawRequest& r) { return tone_of(b, r); },
               .options = b.options});
  });
}

/// Of what a form's function gives: (values, bounds) or (values, bounds, gradients).
std::shared_ptr<const Form> form_of(const Registered& b, const std::vector<OptionValue>& values,
                                    const RunContext& context) {
  return guarded(PluginError::Row::Form, b.name, [&]() -> std::shared_ptr<const Form> {
    std::shared_ptr<const ImplicitFunction> function;
    in_python([&] {
      const py::object given = b.with(values)();
      if (!py::isinstance<py::tuple>(given) || py::len(given) < 2 || py::len(given) > 3) {
        throw py::type_error("a form gives (values, bounds) or (values, bounds, gradients)");
      }
      const auto parts = given.cast<py::tuple>();
      const auto box = box_of(parts[1]);
      if (!box) throw py::type_error("the bounds of a form are x0, y0, z0, x1, y1, z1");
      function = make_python_function(
          {parts[0], parts.size() == 3 ? parts[2].cast<py::object>() : py::none(), py::none()},
          *box);
    });
    return std::make_shared<ImplicitForm>(clip(function, function->bounds()), std::nullopt,
                                          context);
  });
}

void register_form(const std::string& name, const py::object& function, const std::string& meaning,
                   const py::object& options) {
  const Registered b = registered(name, function, meaning, options);
  note(BURIN_FORM_1, b, [&] {
    plugin::add(
        plugin::FormKind{.name = b.name,
                         .meaning = b.meaning,
                         .make = [b](const std::vector<OptionValue>& values,
                                     RunContext& context) { return form_of(b, values, context); },
                         .options = b.options});
  });
}

/// Parts (name, vertices, triangles) of the list that a reader gives.
plugin::ReadMeshes meshes_of(const py::object& given) {
  plugin::ReadMeshes read;
  for (const py::handle part : given) {
    const auto t = part.cast<py::tuple>();
    if (t.size() != 3) throw py::type_error("a part is (name, vertices, triangles)");
    PolygonSoup soup = soup_of(t[1], t[2]);
    soup.name = t[0].cast<std::string>();
    read.objects.push_back(std::move(soup));
  }
  return read;
}

void register_reader(const std::string& name, const std::vector<std::string>& suffixes,
                     const py::object& function, const std::string& meaning,
                     const py::object& options) {
  const Registered b = registered(name, function, meaning, options);
  for (const std::string& suffix : suffixes) {
    if (suffix.size() > 1 && suffix[0] == '.' && !is_own_suffix(suffix)) continue;
    throw UsageError(
        fmt::format("'{}' is no suffix such as .tiny, or one that Burin reads itself", suffix));
  }
  const auto read = [b](const std::filesystem::path& path, std::string_view bytes,
                        const std::vector<OptionValue>& values, RunContext& /*context*/) {
    try {
      return guarded(PluginError::Row::Reader, b.name, [&] {
        plugin::ReadMeshes meshes;
        in_python(
            [&] { meshes = meshes_of(b.with(values)(py::bytes(bytes.data(), bytes.size()))); });
        return meshes;
      });
    } catch (const PluginError& e) {
      throw InputError(e.what(), path.string());
    }
  };
  note(BURIN_READER_1, b, [&] {
    plugin::add(plugin::ReaderKind{.name = b.name,
                                   .meaning = b.meaning,
                                   .suffixes = suffixes,
                                   .read = read,
                                   .options = b.options});
  });
}

void write_by(const Registered& b, const Drawing& drawing, const std::vector<OptionValue>& values,
              std::ostream& out) {
  try {
    guarded(PluginError::Row::Writer, b.name, [&] {
      std::string bytes;
      in_python([&] {
        auto owner = std::make_shared<PyDrawing>();
        owner->drawing = drawing;
        owner->style = builtin_style("technical");
        const py::object given = b.with(values)(owner);
        if (!py::isinstance<py::bytes>(given) && !py::isinstance<py::str>(given)) {
          throw py::type_error("a writer gives bytes or text");
        }
        bytes = given.cast<std::string>();
      });
      if (bytes.empty()) throw Error("it writes nothing");
      out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    });
  } catch (const PluginError& e) {
    throw OutputError(e.what());
  }
}

void register_writer(const std::string& suffix, const py::object& function,
                     const std::string& meaning, const py::object& options) {
  const Registered b = registered(suffix, function, meaning, options);
  if (is_own_format(suffix)) throw UsageError(fmt::format("Burin writes .{} itself", suffix));
  note(BURIN_WRITER_1, b, [&] {
    burin::add(AddedFormat{
        .name = b.name,
        .meaning = b.meaning,
        .write = [b](const Drawing& d, const std::vector<OptionValue>& values, std::ostream& out,
                     const RunContext& /*context*/) { write_by(b, d, values, out); },
        .options = b.options});
  });
}

void register_symbol(const std::string& name, const py::object& function,
                     const std::string& meaning, const py::object& options) {
  const Registered b = registered(name, function, meaning, options);
  const auto draw = [b](const SymbolRequest& r) {
    return guarded(PluginError::Row::Symbol, b.name, [&] {
      Label label;
      in_python([&] {
        const py::object given =
            b.with(values_of(r.values, b.name, b.options))(r.text, r.pens.height, r.pens.line);
        label = label_of(given.cast<py::dict>());
      });
      return label;
    });
  };
  note(BURIN_SYMBOL_1, b, [&] {
    burin::add(
        SymbolKind{.name = b.name, .meaning = b.meaning, .draw = draw, .options = b.options});
  });
}

py::list plugins() {
  py::list out;
  for (const plugin::Plugin& p : plugin::plugins()) {
    py::list offers;
    for (const plugin::Offer& o : p.offers) {
      py::dict offer;
      offer["id"] = o.id;
      offer["name"] = o.name;
      offer["meaning"] = o.meaning;
      offer["refused"] = o.refused;
      offers.append(offer);
    }
    py::dict one;
    one["name"] = p.name;
    one["version"] = p.version;
    one["file"] = p.file;
    one["refused"] = p.refused;
    one["offers"] = offers;
    out.append(one);
  }
  return out;
}

}  // namespace

void add_plugins(py::module_& module) {
  const auto add = [&](const char* name, auto function, const char* manual) {
    module.def(name, function, py::arg("name"), py::arg("function"), py::arg("meaning") = "",
               py::arg("options") = py::none(), manual);
  };
  add("register_direction", register_direction,
      "Makes a function a value of hatch.field: as `field` of `draw`, with its options as "
      "keywords.");
  add("register_law", register_law,
      "Makes a function a value of tone.law: as `tone` of `draw`, with its options as keywords.");
  add("register_form", register_form,
      "Makes a function the input \"form:NAME\": it is called with its options and gives (values, "
      "bounds) or (values, bounds, gradients), as `Scene.add_function` takes them.");
  add("register_symbol", register_symbol,
      "Makes a function a \"symbol\" of notes: it gets the text, the height of letters and the "
      "width of lines in mm of paper, and its options as keywords, and gives a mapping: \"size\" "
      "(width, height), \"lines\" [(points, width)], \"fills\" [(rings, colour or \"\")], "
      "\"texts\" "
      "[(x, y, height, text)], \"shoulder\" (where the leader meets it, above its lower edge), "
      "\"underlined\".");
  module.def(
      "register_reader", register_reader, py::arg("name"), py::arg("suffixes"), py::arg("function"),
      py::arg("meaning") = "", py::arg("options") = py::none(),
      "Has a function read files of these suffixes ([\".tiny\"]): it gets the bytes, and its "
      "options as keywords, and gives a list of parts (name, vertices (n, 3), triangles (m, "
      "3)).");
  module.def("register_writer", register_writer, py::arg("suffix"), py::arg("function"),
             py::arg("meaning") = "", py::arg("options") = py::none(),
             "Has a function write files of this suffix (\"txt\"): it gets the Drawing, and its "
             "options as keywords, and gives bytes or text.");
  module.def("plugins", plugins,
             "All plug-ins: \"name\", \"version\", \"file\", \"offers\" (\"id\", \"name\", "
             "\"meaning\", \"refused\"), \"refused\" (why, or empty).");
  module.def(
      "_refuse_plugin",
      [](const std::string& name, const std::string& why) { plugin::note_refused(name, why); },
      py::arg("name"), py::arg("why"));
}

}  // namespace burin::python
