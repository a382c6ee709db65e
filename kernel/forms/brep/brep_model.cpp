#include <burin/base/error.h>
#include <burin/forms/brep/occt/brep_model.h>

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace burin {

struct BrepModel::Impl {
  TopoDS_Shape shape;
};

BrepModel::BrepModel(const TopoDS_Shape& shape) : impl_(std::make_unique<Impl>()) {
  impl_->shape = shape;
}
BrepModel::~BrepModel() = default;
const TopoDS_Shape& BrepModel::shape() const { return impl_->shape; }
BrepCounts BrepModel::counts() const { return {}; }
std::size_t BrepModel::face_count() const { return 0; }
const Chart& BrepModel::chart(std::int32_t) const { throw GeometryError("no chart yet"); }
bool BrepModel::reversed(std::int32_t) const { return false; }
Vec2 BrepModel::on_coedge(std::int32_t, double) const { return Vec2(0); }
Box3 BrepModel::bounds(const Mat3&) const { return {}; }
double BrepModel::size() const { return 0; }
std::shared_ptr<const ChartMesh> BrepModel::tessellate(double, RunContext&, Diagnostics*) const {
  throw GeometryError("no triangles yet");
}

std::shared_ptr<const BrepModel> make_brep_model(const TopoDS_Shape& shape) {
  return std::make_shared<BrepModel>(shape);
}

}  // namespace burin
