#include "add_parts.h"

#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/converters/cad_reader.h>
#include <burin/converters/implicit_reader.h>
#include <burin/converters/mesh_reader.h>
#include <burin/converters/values.h>
#include <burin/drawing/color.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/repair/repair.h>

#include "arrays.h"
#include "function.h"
#include "look.h"
#include "run.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace burin::python {

std::optional<Box3> box_of(const py::object& bounds) {
  return box_option("bounds", list_text("bounds", bounds));
}

PolygonSoup soup_of(const py::object& vertices, const py::object& triangles) {
  PolygonSoup soup;
  soup.positions = points(vertices, "vertices");
  const py::array given = py::array::ensure(triangles);
  if (!given) {
    PyErr_Clear();
    throw UsageError("argument triangles takes an array of whole numbers (m, 3)");
  }
  const char kind = given.dtype().kind();
  if (given.ndim() != 2 || given.shape(1) != 3 || (kind != 'i' && kind != 'u')) {
    throw UsageError(fmt::format(
        "argument triangles takes an array of whole numbers (m, 3), not {} of shape {}",
        std::string(py::str(given.dtype())), std::string(py::str(given.attr("shape")))));
  }
  using Corners = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;
  const Corners corners = Corners::ensure(given);
  const auto n = static_cast<std::int64_t>(soup.positions.size());
  const std::int64_t* data = corners.data();
  const auto count = static_cast<std::size_t>(corners.size());
  soup.indices.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (data[i] < 0 || data[i] >= n) {
      throw UsageError(
          fmt::format("argument triangles: corner {} of triangle {} is {}; there are {} "
                      "vertices, counted from 0",
                      i % 3, i / 3, data[i], n));
    }
    soup.indices[i] = static_cast<std::uint32_t>(data[i]);
  }
  soup.offsets.resize(count / 3 + 1);
  for (std::size_t i = 0; i < soup.offsets.size(); ++i) soup.offsets[i] = 3 * i;
  return soup;
}

namespace {

Placement affine(const py::object& value) {
  Placement place;
  if (value.is_none()) return place;
  constexpr const char* kWhat = "argument placement takes a 4 x 4 affine matrix";
  const Doubles m = matrix(value, "placement", 4);
  if (m.shape(0) != 4) throw UsageError(fmt::format("{}, not {} rows", kWhat, m.shape(0)));
  const auto at = m.unchecked<2>();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) place.linear[column][row] = at(row, column);
    place.offset[row] = at(row, 3);
  }
  const bool last = at(3, 0) == 0 && at(3, 1) == 0 && at(3, 2) == 0 && at(3, 3) == 1;
  if (!last) {
    throw UsageError(fmt::format("{}; the last row of one is 0, 0, 0, 1", kWhat));
  }
  if (!is_invertible(place)) {
    throw UsageError(fmt::format("{}; this one flattens the part or is not finite", kWhat));
  }
  return place;
}

constexpr std::uint64_t kMostSamples = 1024;

/// The function as a cubic spline through `n` samples along the longest side of its domain and the
/// same step along the others.
std::shared_ptr<const ImplicitFunction> sampled(const ImplicitFunction& function,
                                                const Box3& domain, int n,
                                                const RunContext& context) {
  constexpr double kLeast = 8;  // a cubic spline's border takes as much
  VolumeGrid grid;
  grid.origin = domain.min;
  const Vec3 size = domain.size();
  const double step = std::max({size.x, size.y, size.z}) / std::max(n - 1, 1);
  for (int k = 0; k < 3; ++k) {
    const double count = std::max(kLeast, std::ceil(size[k] / step - 1e-9) + 1);  // of samples
    grid.size[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(count);
    grid.steps[k] = Vec3(0);
    grid.steps[k][k] = size[k] / (count - 1);
  }
  const auto [nx, ny, nz] = grid.size;
  // A plane at a time: few calls, and cancel is heard.
  std::vector<Vec3> at(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  std::vector<double> values(at.size());
  grid.samples.reserve(at.size() * static_cast<std::size_t>(nz));
  for (std::int32_t k = 0; k < nz; ++k) {
    context.check();
    for (std::int32_t j = 0; j < ny; ++j) {
      for (std::int32_t i = 0; i < nx; ++i) {
        at[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
           static_cast<std::size_t>(i)] = grid.origin + grid.steps * Vec3(i, j, k);
      }
    }
    function.values(at, values);
    for (const double v : values) grid.samples.push_back(static_cast<float>(v));
  }
  const auto any = [&](auto&& test) {
    return std::any_of(grid.samples.begin(), grid.samples.end(), test);
  };
  if (!any([](float v) { return std::isfinite(v); })) {
    throw GeometryError("the function gives no finite number in its bounds");
  }
  if (!any([](float v) { return v < 0; })) {
    throw GeometryError(
        "the function is nowhere negative in its bounds; widen them, or use more samples");
  }
  if (!any([](float v) { return v >= 0; })) {
    throw GeometryError("the function is negative everywhere in its bounds; widen them");
  }
  return make_volume_function(std::move(grid),
                              {.level = 0, .inside_above = false, .degree = 3, .interpolate = true},
                              context);
}

Part implicit(std::shared_ptr<const ImplicitFunction> function, const std::optional<Box3>& domain) {
  Part part;
  run(py::none(), nullptr, [&](RunContext& context) {
    part.form = std::make_shared<ImplicitForm>(std::move(function), domain, context);
  });
  return part;
}

}  // namespace

PyBrep read_brep(const py::object& brep) {
  if (!py::isinstance<py::str>(brep) && !py::isinstance<py::bytes>(brep)) {
    throw py::type_error("argument brep takes str or bytes, as OCCT writes a shape");
  }
  const auto text = brep.cast<std::string>();
  PyBrep read;
  run(py::none(), nullptr,
      [&](RunContext& context) { read.shape = read_brep_text(text, context); });
  return read;
}

namespace {

PaintedFaces painted(const BrepShape& shape, const std::string& color,
                     std::vector<std::string> face_colors) {
  if (face_colors.empty()) return {color, {}};
  std::vector<double> areas;
  run(py::none(), nullptr, [&](RunContext&) { areas = shape.face_areas(); });
  if (areas.size() != face_colors.size()) {
    throw UsageError(
        fmt::format("argument face_colors takes one colour for each of {} faces, not {}",
                    areas.size(), face_colors.size()));
  }
  for (std::string& one : face_colors) {
    if (one.empty()) one = color;
    const std::optional<Rgba> known = hex_color(one);
    if (!one.empty() && !known) {
      throw UsageError(
          fmt::format("argument face_colors takes colours #rrggbb or #rrggbbaa, not '{}'", one));
    }
    if (known) one = color_text(look_of(*known));
  }
  return painted_faces(face_colors, areas);
}

}  // namespace

Part brep_part(const py::object& brep, const py::object& placement, const std::string& color,
               std::vector<std::string> face_colors) {
  const Placement place = affine(placement);
  const auto shape =
      py::isinstance<PyBrep>(brep) ? brep.cast<PyBrep>().shape : read_brep(brep).shape;
  Part part;
  part.form = shape->form(place);
  PaintedFaces paint = painted(*shape, color, std::move(face_colors));
  const Appearance look = look_of(paint.color);
  part.color = look.color;
  part.opacity = look.opacity;
  part.face_colors = std::move(paint.faces);
  return part;
}

bool is_valid(const PyBrep& brep) {
  bool valid = false;
  run(py::none(), nullptr, [&](RunContext&) { valid = brep.shape->valid(); });
  return valid;
}

namespace {

// u and v of the vertices become those of the corners.
void add_texture(const py::object& texture, PolygonSoup& soup) {
  if (texture.is_none()) return;
  const Doubles uv = matrix(texture, "texture", 2);
  const auto rows = static_cast<std::size_t>(uv.shape(0));
  if (rows != soup.positions.size()) {
    throw UsageError(fmt::format("argument texture takes u and v of each of {} vertices, not {}",
                                 soup.positions.size(), rows));
  }
  const auto at = uv.unchecked<2>();
  for (const std::uint32_t v : soup.indices) {
    soup.texture.emplace_back(static_cast<float>(at(v, 0)), static_cast<float>(at(v, 1)));
  }
}

}  // namespace

Part mesh_part(const py::object& vertices, const py::object& triangles, const py::object& texture,
               const std::string& name, Diagnostics& diagnostics) {
  PolygonSoup soup = soup_of(vertices, triangles);
  add_texture(texture, soup);
  soup.name = name;
  Part part;
  run(py::none(), nullptr, [&](RunContext& context) {
    auto uv = texture_of(soup, context);
    TriMesh mesh = repair(std::move(soup), {}, diagnostics, context);
    part.form = std::make_shared<MeshForm>(std::move(mesh), std::move(uv));
  });
  return part;
}

Part function_part(const PythonFunctions& functions, const py::object& bounds,
                   const py::object& samples) {
  const std::optional<Box3> domain = box_of(bounds);
  if (!domain) throw UsageError("argument bounds takes a box x0,y0,z0,x1,y1,z1");
  const auto n = static_cast<int>(
      whole_option("samples", number_text("samples", samples), 0, kMostSamples, "0 to 1024"));
  const auto exact = make_python_function(functions, *domain);
  Part part;
  run(py::none(), nullptr, [&](RunContext& context) {
    const auto function = n == 0 ? exact : sampled(*exact, *domain, n, context);
    part.form = std::make_shared<ImplicitForm>(function, domain, context);
  });
  return part;
}

Part implicit_part(const std::string& text, const py::object& bounds) {
  const Expression expression = parse_implicit(text, "text");
  return implicit(make_function(expression), box_of(bounds));
}

}  // namespace burin::python
