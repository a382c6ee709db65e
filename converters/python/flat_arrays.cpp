#include "flat_arrays.h"

#include <burin/drawing/polygons.h>

#include "arrays.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

constexpr std::array kKinds{
    LineClass::Contour,   LineClass::Boundary,     LineClass::Crease,   LineClass::Smooth,
    LineClass::Seam,      LineClass::Intersection, LineClass::Section,  LineClass::Ridge,
    LineClass::Valley,    LineClass::Suggestive,   LineClass::Isophote, LineClass::Stroke,
    LineClass::Pattern,   LineClass::Trail,        LineClass::Centre,   LineClass::Thread,
    LineClass::ThreadEnd, LineClass::Leader,       LineClass::Frame};

/// A number a path.
struct Columns {
  std::vector<std::int64_t> first{0};
  std::vector<std::int32_t> layer, kind, part, face, edge, family, stroke_kind;
  std::vector<bool> visible, closed;
};

py::array_t<bool> flags(const std::vector<bool>& values) {
  py::array_t<bool> array(static_cast<py::ssize_t>(values.size()));
  std::copy(values.begin(), values.end(), array.mutable_data());
  return array;
}

/// The coordinates of vectors.
template <class Vec>
void append(std::vector<double>& all, const std::vector<Vec>& vectors) {
  if (vectors.empty()) return;
  static_assert(sizeof(Vec) == static_cast<std::size_t>(Vec::length()) * sizeof(double));
  const double* first = &vectors.front().x;
  all.insert(all.end(), first, first + vectors.size() * static_cast<std::size_t>(Vec::length()));
}

template <class T>
py::array column(std::vector<T> values) {
  const auto n = static_cast<py::ssize_t>(values.size());
  return own(std::move(values), {n});
}

}  // namespace

py::dict flat_arrays(const Drawing& drawing) {
  Columns c;
  std::size_t total = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) total += path.points.size();
  }
  std::vector<double> points, points3, width;
  points.reserve(2 * total);
  points3.reserve(3 * total);
  width.reserve(total);
  for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
    for (const Path& path : drawing.layers[i].paths) {
      const std::size_t n = path.points.size();
      append(points, path.points);
      append(points3, path.points3);
      if (path.points3.size() != n) {
        points3.resize(points3.size() + 3 * (n - path.points3.size()),
                       std::numeric_limits<double>::quiet_NaN());
      }
      if (path.width.size() == n) {
        width.insert(width.end(), path.width.begin(), path.width.end());
      } else {
        width.insert(width.end(), n, path.width.empty() ? 0.0 : path.width.front());
      }
      c.first.push_back(c.first.back() + static_cast<std::int64_t>(n));
      c.layer.push_back(static_cast<std::int32_t>(i));
      c.kind.push_back(static_cast<std::int32_t>(path.kind));
      c.part.push_back(path.source.part);
      c.face.push_back(path.source.face);
      c.edge.push_back(path.source.edge);
      c.family.push_back(path.family);
      c.stroke_kind.push_back(path.stroke_kind);
      c.visible.push_back(path.visible);
      c.closed.push_back(path.closed);
    }
  }
  const auto n = static_cast<py::ssize_t>(total);
  py::dict out;
  out["points"] = own(std::move(points), {n, 2});
  out["points3"] = own(std::move(points3), {n, 3});
  out["width"] = own(std::move(width), {n});
  out["first"] = column(std::move(c.first));
  out["layer"] = column(std::move(c.layer));
  out["kind"] = column(std::move(c.kind));
  out["part"] = column(std::move(c.part));
  out["face"] = column(std::move(c.face));
  out["edge"] = column(std::move(c.edge));
  out["family"] = column(std::move(c.family));
  out["stroke_kind"] = column(std::move(c.stroke_kind));
  out["visible"] = flags(c.visible);
  out["closed"] = flags(c.closed);
  py::list kinds, layers;
  for (const LineClass kind : kKinds) kinds.append(to_string(kind));
  for (const Layer& layer : drawing.layers) layers.append(layer.name);
  out["kinds"] = kinds;
  out["layers"] = layers;
  return out;
}

py::list area_dicts(const Drawing& drawing) {
  py::list areas;
  for (const Area& area : drawing.areas) {
    py::list rings;
    for (const std::vector<Vec2>& ring : area.rings) {
      std::vector<double> points;
      append(points, ring);
      rings.append(own(std::move(points), {static_cast<py::ssize_t>(ring.size()), 2}));
    }
    py::dict d;
    d["part"] = area.part;
    d["face"] = area.face;
    d["tone"] = area.tone;
    d["fill"] = area.fill;
    d["opacity"] = area.opacity;
    d["ink"] = area.ink;
    d["tint"] = area.tint;
    d["role"] = area.role;
    py::list polygons;
    for (const RingPolygon& polygon : polygons_of(area.rings)) {
      py::list holes;
      for (const std::size_t hole : polygon.holes) holes.append(rings[hole]);
      polygons.append(py::make_tuple(rings[polygon.shell], holes));
    }
    d["rings"] = rings;
    d["polygons"] = polygons;
    areas.append(d);
  }
  return areas;
}

}  // namespace burin::python
