#include <burin/converters/file_info.h>

namespace burin {
namespace {

void add(std::optional<std::int64_t>& sum, const std::optional<std::int64_t>& n) {
  if (n) sum = sum.value_or(0) + *n;
}

}  // namespace

PartInfo FileInfo::total() const {
  PartInfo sum;
  for (const PartInfo& p : parts) {
    add(sum.vertices, p.vertices);
    add(sum.triangles, p.triangles);
    add(sum.solids, p.solids);
    add(sum.shells, p.shells);
    sum.faces += p.faces;
    add(sum.edges, p.edges);
    add(sum.components, p.components);
    sum.boundary_edges += p.boundary_edges;
    add(sum.self_intersections, p.self_intersections);
    sum.area += p.area;
    sum.volume += p.volume;
    sum.bounds.add(p.bounds);
  }
  return sum;
}

}  // namespace burin
