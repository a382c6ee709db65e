#include "charts/wild_pcurve.h"
#include "contain.h"
#include "model_parts.h"
#include "occt_vec.h"
#include "triangles/mesher.h"

#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Precision.hxx>
#include <ShapeFix_Edge.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace burin {
namespace {

TopoDS_Face forward(const TopoDS_Face& f) { return TopoDS::Face(f.Oriented(TopAbs_FORWARD)); }

/// Whether the curve is that of the edge; what throws is not.
bool is_sound(const EdgeInFace& use, double size) {
  bool sound = has_sound_poles(use.curve);
  const std::string failure = contained([&] {
    if (sound && !use.surface.IsNull()) sound = !leaves_edge(use, size);
  });
  return sound && failure.empty();
}

void forget_curve(const TopoDS_Edge& use, const TopoDS_Face& face) {
  BRep_Builder().UpdateEdge(use, Handle(Geom2d_Curve)(), face, BRep_Tool::Tolerance(use));
}

/// A face as its edges see it: turned forward, and the surface where it is.
struct Front {
  TopoDS_Face face;
  Handle(Geom_Surface) surface;
};

EdgeInFace curve_in(const TopoDS_Edge& use, const Front& front, const ModelEdge& edge) {
  EdgeInFace found{{}, 0, 0, front.surface, edge.curve, edge.first, edge.last};
  found.curve = BRep_Tool::CurveOnSurface(use, front.face, found.first, found.last);
  return found;
}

/// The curve of an edge in a face, made anew from the edge in space where it is missing or led
/// astray.
EdgeInFace mended_curve(const TopoDS_Edge& use, const Front& front, const ModelEdge& edge,
                        double size) {
  EdgeInFace given = curve_in(use, front, edge);
  // Without a surface OCCT would follow a null pointer.
  if (front.surface.IsNull()) return given;
  if (!given.curve.IsNull() && is_sound(given, size)) return given;
  const bool seam = BRep_Tool::IsClosed(use, front.face);
  if (!given.curve.IsNull()) forget_curve(use, front.face);
  ShapeFix_Edge().FixAddPCurve(use, front.face, seam, 0.0);
  return curve_in(use, front, edge);
}

std::int32_t number(const TopTools_IndexedMapOfShape& map, const TopoDS_Shape& s) {
  return s.IsNull() ? -1 : map.FindIndex(s) - 1;
}

ModelEdge make_edge(const TopoDS_Edge& shape, const TopTools_IndexedMapOfShape& vertices) {
  ModelEdge e;
  e.edge = TopoDS::Edge(shape.Oriented(TopAbs_FORWARD));
  e.degenerate = BRep_Tool::Degenerated(e.edge);
  contained([&] {
    if (!e.degenerate && !BRep_Tool::IsGeometric(e.edge)) return;
    if (!e.degenerate) BRepLib::BuildCurve3d(e.edge);
    if (!e.degenerate && !BRep_Tool::SameParameter(e.edge)) {
      BRepLib::SameParameter(e.edge, Precision::Confusion());
    }
    BRep_Tool::Range(e.edge, e.first, e.last);
    double first = 0, last = 0;
    if (!e.degenerate) e.curve = BRep_Tool::Curve(e.edge, first, last);
  });
  e.vertex = {number(vertices, TopExp::FirstVertex(e.edge)),
              number(vertices, TopExp::LastVertex(e.edge))};
  return e;
}

/// The box in (u,v) of a face, from samples of its coedges: enough to end infinite directions.
ParameterBox used_box(const ModelParts& parts, std::size_t first, std::size_t end) {
  Box2 box;
  for (std::size_t c = first; c < end; ++c) {
    const ModelCoedge& co = parts.coedges[c];
    const ModelEdge& e = parts.edges[static_cast<std::size_t>(co.edge)];
    if (!co.curve.known()) continue;
    const int steps = co.curve.straight() ? 1 : 8;
    for (int i = 0; i <= steps; ++i) box.add(co.curve.at(e.first + (e.last - e.first) * i / steps));
  }
  const auto finite = [](Vec2 p) { return std::abs(p.x) + std::abs(p.y) < 1e100; };
  if (box.empty() || !finite(box.min) || !finite(box.max)) return {Vec2(-1), Vec2(1)};
  return {box.min, box.max};
}

/// Whether a chart can be evaluated where the face begins and in the middle of its coedges.
bool works(const ModelParts& parts, const Chart& chart, std::size_t first_coedge) {
  const auto finite = [&](Vec2 uv) {
    const SurfaceDerivatives d = chart.derivatives(uv);
    const Vec3 sum = d.p + d.u + d.v;
    return std::isfinite(sum.x + sum.y + sum.z);
  };
  try {
    if (!finite(chart.domain().center())) return false;
    for (std::size_t c = first_coedge; c < parts.coedges.size(); ++c) {
      const ModelCoedge& co = parts.coedges[c];
      const ModelEdge& e = parts.edges[static_cast<std::size_t>(co.edge)];
      if (co.curve.known() && !finite(co.curve.at(0.5 * (e.first + e.last)))) return false;
    }
  } catch (const std::exception&) {
    return false;
  } catch (const Standard_Failure&) {
    return false;
  }
  return true;
}

/// Whether the poles of a spline are numbers; of any other surface true.
bool has_numbers(Handle(Geom_Surface) surface) {
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) {
    surface = trimmed->BasisSurface();
  }
  const TColgp_Array2OfPnt* poles = nullptr;
  if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(surface)) {
    poles = &spline->Poles();
  } else if (const auto bezier = Handle(Geom_BezierSurface)::DownCast(surface)) {
    poles = &bezier->Poles();
  }
  for (int i = 1; poles && i <= poles->NbRows(); ++i) {
    for (int k = 1; k <= poles->NbColumns(); ++k) {
      const gp_Pnt& p = (*poles)(i, k);
      if (!std::isfinite(p.X() + p.Y() + p.Z())) return false;
    }
  }
  return true;
}

/// Adds the use of an edge by the face that comes next.
void add_coedge(ModelParts& parts, ModelFace& f, const Front& front, const TopoDS_Edge& use,
                std::int32_t edge) {
  ModelCoedge c;
  c.use = use;
  c.edge = edge;
  c.face = static_cast<std::int32_t>(parts.faces.size());
  c.reversed = use.Orientation() == TopAbs_REVERSED;
  c.internal = use.Orientation() == TopAbs_INTERNAL || use.Orientation() == TopAbs_EXTERNAL;
  ModelEdge& e = parts.edges[static_cast<std::size_t>(edge)];
  contained([&] {
    const EdgeInFace found = mended_curve(use, front, e, parts.size);
    c.curve = Pcurve(found.curve, found.first, found.last, e.first, e.last);
    if (c.curve.known() && !front.surface.IsNull()) f.meshable &= !leaves_surface(found);
  });
  e.coedges.push_back(static_cast<std::int32_t>(parts.coedges.size()));
  parts.coedges.push_back(std::move(c));
}

void add_face(ModelParts& parts, const TopoDS_Face& face, const TopoDS_Face& original,
              const TopTools_IndexedMapOfShape& edges, const ChartMaker& make_chart) {
  ModelFace f;
  f.face = face;
  f.first_coedge = static_cast<std::int32_t>(parts.coedges.size());
  f.reversed = face.Orientation() == TopAbs_REVERSED;
  const Handle(Geom_Surface) surface =
      contained_or(Handle(Geom_Surface)(), [&] { return BRep_Tool::Surface(face); });
  const Front front{forward(face), surface};
  for (TopExp_Explorer it(front.face, TopAbs_EDGE); it.More(); it.Next()) {
    add_coedge(parts, f, front, TopoDS::Edge(it.Current()), number(edges, it.Current()));
  }
  f.meshable = f.meshable && !surface.IsNull() && has_numbers(surface);
  if (!surface.IsNull()) {
    f.chart = contained_or(std::shared_ptr<const Chart>(), [&] {
      return make_chart(
          surface, used_box(parts, static_cast<std::size_t>(f.first_coedge), parts.coedges.size()));
    });
  }
  if (f.chart && !works(parts, *f.chart, static_cast<std::size_t>(f.first_coedge))) f.chart.reset();
  if (!f.chart) f.given = triangles_on(original, static_cast<std::int32_t>(parts.faces.size()));
  parts.faces.push_back(std::move(f));
}

/// The diagonal of a box about vertices and the middles of edges; infinite or no number where one
/// of them is.
double size_of(const ModelParts& parts) {
  Box3 box;
  for (const Vec3& p : parts.vertices) box.add(p);
  for (const ModelEdge& e : parts.edges) {
    contained([&] {
      if (!e.curve.IsNull()) box.add(to_vec(e.curve->Value(0.5 * (e.first + e.last))));
    });
  }
  return box.empty() ? 0 : box.diagonal();
}

void collect_bodies(ModelParts& parts, const TopTools_IndexedMapOfShape& faces) {
  const auto add = [&](const TopoDS_Shape& body) {
    auto& list = parts.bodies.emplace_back();
    for (TopExp_Explorer f(body, TopAbs_FACE); f.More(); f.Next()) {
      list.push_back(number(faces, f.Current()));
    }
  };
  for (TopExp_Explorer s(parts.shape, TopAbs_SOLID); s.More(); s.Next()) add(s.Current());
  for (TopExp_Explorer s(parts.shape, TopAbs_SHELL, TopAbs_SOLID); s.More(); s.Next()) {
    add(s.Current());
  }
}

}  // namespace

void collect_parts(ModelParts& parts, const TopoDS_Shape& original, const ChartMaker& make_chart) {
  TopTools_IndexedMapOfShape faces, edges, vertices, originals;
  TopExp::MapShapes(original, TopAbs_FACE, originals);
  TopExp::MapShapes(parts.shape, TopAbs_FACE, faces);
  TopExp::MapShapes(parts.shape, TopAbs_EDGE, edges);
  TopExp::MapShapes(parts.shape, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i) {
    parts.vertices.push_back(to_vec(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)))));
  }
  for (int i = 1; i <= edges.Extent(); ++i) {
    parts.edges.push_back(make_edge(TopoDS::Edge(edges(i)), vertices));
  }
  parts.size = size_of(parts);
  for (int i = 1; i <= faces.Extent(); ++i) {
    add_face(parts, TopoDS::Face(faces(i)), TopoDS::Face(originals(i)), edges, make_chart);
  }
  collect_bodies(parts, faces);
}

}  // namespace burin
