#pragma once
/// What a user chooses of DXF.

#include <burin/drawing/format_options.h>

#include <string_view>
#include <vector>

namespace burin {

struct DxfOptions {
  static constexpr std::string_view kRow = "dxf";
  static std::vector<OptionRow<DxfOptions>> rows() {
    return {options::flag("arcs", &DxfOptions::arcs,
                          "circles, ellipses and their arcs as CIRCLE, ARC and ELLIPSE; else "
                          "polylines"),
            options::flag("splines", &DxfOptions::splines,
                          "other smooth curves as SPLINE, not as LWPOLYLINE; OpenSCAD reads no "
                          "SPLINE"),
            options::word("order", &DxfOptions::order, line_order_words(), line_order_meaning())};
  }

  /// Lines of constant width as ARC, CIRCLE and ELLIPSE where they are such.
  bool arcs = true;
  /// Other smooth curves of constant width as SPLINE instead of LWPOLYLINE.
  bool splines = false;
  LineOrder order = LineOrder::Drawing;
};

}  // namespace burin
