#include "pmi.h"

#include <burin/converters/file_info.h>

#include "arrays.h"

#include <string>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

/// (n, 3) a line, where the part stands.
py::list to_list(const std::vector<PmiLine>& lines, const Placement& place) {
  py::list list;
  for (const PmiLine& line : lines) {
    std::vector<double> numbers;
    const auto add = [&](const Vec3& point) {
      const Vec3 p = place.point(point);
      numbers.insert(numbers.end(), {p.x, p.y, p.z});
    };
    for (const Vec3& point : line.points) add(point);
    if (line.closed) add(line.points.front());
    const auto count = static_cast<py::ssize_t>(numbers.size() / 3);
    list.append(own(std::move(numbers), {count, 3}));
  }
  return list;
}

}  // namespace

py::list pmi_of(const Scene& scene) {
  const py::object loads = py::module_::import("json").attr("loads");
  py::list list;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    const PlacedPmi& placed = scene.parts[i].pmi;
    if (!placed) continue;
    const py::object items = loads(to_json(*placed.pmi))["items"];
    for (std::size_t k = 0; k < placed.pmi->items.size(); ++k) {
      const PmiItem& item = placed.pmi->items[k];
      py::dict d = items[py::int_(k)];
      d["part"] = i;
      d["lines"] = to_list(item.lines, placed.placement);
      d["filled"] = to_list(item.filled, placed.placement);
      list.append(d);
    }
  }
  return list;
}

}  // namespace burin::python
