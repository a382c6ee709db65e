#include "nearest_triangle.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <boost/iterator/counting_iterator.hpp>

namespace burin::detail {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

Kernel::Point_3 point(Vec3 p) { return {p.x, p.y, p.z}; }

/// A triangle by its number: the mesh is not copied.
struct Primitive {
  using Id = std::uint32_t;
  using Point = Kernel::Point_3;
  using Datum = Kernel::Triangle_3;
  using Shared_data = const TriMesh*;  // NOLINT(readability-identifier-naming): CGAL's name

  Primitive() = default;
  Primitive(const boost::counting_iterator<Id>& number, Shared_data) : number_(*number) {}
  static Shared_data construct_shared_data(const TriMesh* mesh) { return mesh; }

  Id id() const { return number_; }
  Datum datum(Shared_data mesh) const {
    const Triangle& t = mesh->triangles[number_];
    return {point(mesh->positions[t[0]]), point(mesh->positions[t[1]]),
            point(mesh->positions[t[2]])};
  }
  Point reference_point(Shared_data mesh) const {
    return point(mesh->positions[mesh->triangles[number_][0]]);
  }

 private:
  Id number_ = 0;
};

#if CGAL_VERSION_MAJOR >= 6
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

}  // namespace

struct NearestTriangle::Tree {
  Boxes boxes;
};

NearestTriangle::NearestTriangle(const TriMesh& mesh) : tree_(std::make_unique<Tree>()) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  tree_->boxes.insert(boost::counting_iterator<std::uint32_t>(0),
                      boost::counting_iterator<std::uint32_t>(count), &mesh);
  tree_->boxes.build();
  tree_->boxes.accelerate_distance_queries();
}
NearestTriangle::~NearestTriangle() = default;

NearestTriangle::Found NearestTriangle::at(Vec3 p) const {
  const auto [q, triangle] = tree_->boxes.closest_point_and_primitive(point(p));
  return {triangle, {q.x(), q.y(), q.z()}};
}

}  // namespace burin::detail
