#pragma once
/// DXF of AutoCAD 2000 (AC1015).

#include <burin/converters/write.h>

#include <iosfwd>

namespace burin {

/// A layer a layer of the drawing, with its line weight and line type (ISO 128). Paths of two
/// points are LINE, circles, ellipses and their arcs of constant width CIRCLE, ELLIPSE and ARC,
/// other curves LWPOLYLINE, or SPLINE where asked for; strokes whose
/// width varies are LWPOLYLINE with a width at each vertex. Each carries XDATA of the application
/// BURIN: kind, part, face, edge. Units are millimetres.
void write_dxf(const Drawing& drawing, const WriteOptions& given, std::ostream& out,
               const RunContext& context);

}  // namespace burin
