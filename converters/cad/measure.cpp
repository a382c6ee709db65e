#include "measure.h"

#include <burin/base/affine.h>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>

#include <cmath>

namespace burin {
namespace {

/// Without it OCCT takes a fixed number of samples: on rational splines areas come out up to 2e-3
/// off, volumes 8e-3.
constexpr double kIntegralError = 1e-7;

/// Volume, or area, of the model itself.
double integral(const TopoDS_Shape& shape, bool volume) {
  try {
    GProp_GProps properties;
    if (volume) {
      BRepGProp::VolumeProperties(shape, properties, kIntegralError);
    } else {
      BRepGProp::SurfaceProperties(shape, properties, kIntegralError);
    }
    const double mass = properties.Mass();
    return std::isfinite(mass) ? mass : 0;
  } catch (const Standard_Failure&) {
    return 0;
  }
}

}  // namespace

PartInfo measure(const BrepModel& model, const Placement& placement) {
  const BrepCounts counts = model.counts();
  PartInfo info;
  info.solids = counts.solids;
  info.shells = counts.shells;
  info.faces = counts.faces;
  info.edges = counts.edges;
  info.boundary_edges = counts.free_edges;
  const double volume_scale = std::abs(glm::determinant(placement.linear));
  info.area = is_similar(placement)
                  ? integral(model.shape(), false) * std::pow(volume_scale, 2.0 / 3)
                  : integral(as_splines(model, placement), false);
  if (counts.closed) info.volume = std::abs(integral(model.shape(), true)) * volume_scale;
  info.bounds = model.bounds(placement.linear);
  info.bounds.min += placement.offset;
  info.bounds.max += placement.offset;
  return info;
}

PartInfo measure(const std::vector<BrepBody>& bodies, const Placement& placement) {
  FileInfo all;
  for (const BrepBody& body : bodies) {
    all.parts.push_back(measure(*body.model, after(placement, body.placement)));
  }
  return all.total();
}

}  // namespace burin
