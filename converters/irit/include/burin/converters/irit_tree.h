#pragma once
/// What an IRIT data file holds, as it stands there.

#include <burin/base/placement.h>
#include <burin/base/run_context.h>
#include <burin/base/text_place.h>
#include <burin/converters/trimmed_faces.h>
#include <burin/forms/charted/nurbs.h>
#include <burin/forms/implicit/volume_function.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace burin {

/// [name value ...]: the words of the value, without quotes, separated by blanks; nested blocks are
/// left out.
struct IritAttribute {
  std::string name;
  std::string value;
};
using IritAttributes = std::vector<IritAttribute>;

/// SURFACE BEZIER or BSPLINE: points divided by their weights, periodic directions with their first
/// points repeated at the end. Points of less than three coordinates get zeros.
struct IritSurface {
  NurbsData data;
  IritAttributes attributes;
  std::int64_t line = 0;
};

/// CURVE BEZIER or BSPLINE; knots as in NurbsData, empty weights where polynomial.
struct IritCurve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<Vec3> points;
  std::vector<double> weights;
  bool periodic = false;
  IritAttributes attributes;
};

/// TRIMSRF, a surface and its trimming loops, or MODEL, several whose loops share their borders;
/// each curve in the parameters of its surface.
struct IritTrimmed {
  std::vector<TrimmedSurface> faces;
  bool model = false;
  IritAttributes attributes;
};

/// TRIVAR BEZIER or BSPLINE of points with one coordinate: a function of space.
struct IritTrivariate {
  TrivariateSpline spline;
  /// Where instances take it.
  Placement placement = {};
  IritAttributes attributes;
  std::int64_t line = 0;
};

struct IritPolygon {
  /// Of a strip any three points that follow each other are a triangle.
  enum class Kind : std::uint8_t { Polygon, Polyline, PointList, Strip };
  Kind kind = Kind::Polygon;
  std::vector<Vec3> points;
  IritAttributes attributes;
};

/// NUMBER, POINT, VECTOR, PLANE, MATRIX (rows one after another; points are rows to its left) or
/// CTLPT.
struct IritNumbers {
  std::string kind;
  std::vector<double> values;
};

/// INSTANCE: the first object of that name, in whatever list, at another place: each point is a row
/// to the left of the matrix (rows one after another).
struct IritInstance {
  std::string of;
  std::array<double, 16> matrix{};
  TextPlace place;
};

/// Something that is not yet read: "MULTIVAR", "SURFACE GREGORY".
struct IritUnread {
  std::string what;
  std::int64_t line = 0;
};

using IritItem = std::variant<IritSurface, IritCurve, IritTrimmed, IritTrivariate, IritPolygon,
                              IritNumbers, IritInstance, std::string, IritUnread>;

/// [OBJECT attributes name ...]: a leaf with items, or a list of objects. No name: empty.
struct IritObject {
  std::string name;
  IritAttributes attributes;
  std::vector<IritItem> items;
  std::vector<IritObject> objects;
  std::int64_t line = 0;

  /// The value of an attribute (names in any case), nullptr where there is none.
  const std::string* attribute(const std::string& wanted) const;
};

/// The file as the list of its objects. Throws InputError as read_irit does.
IritObject read_irit_tree(const std::filesystem::path& path, const RunContext& context);

}  // namespace burin
