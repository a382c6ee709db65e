#pragma once
/// Spline patches with trimming curves in their parameters, made into exact faces.

#include <burin/base/run_context.h>
#include <burin/base/text_place.h>
#include <burin/converters/cad_reader.h>
#include <burin/forms/charted/nurbs.h>

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// A B-spline curve in the parameters (u, v) of a surface; knots, points and weights as in
/// NurbsData.
struct TrimCurve {
  int degree = 0;
  std::vector<double> knots;
  std::vector<Vec2> points;
  std::vector<double> weights;
};

/// Curves that follow each other head to tail, the last back to the first.
struct TrimLoop {
  std::vector<TrimCurve> curves;
  TextPlace place;
};

/// What of the surface lies within an odd number of loops; all of it where there is none.
struct TrimmedSurface {
  NurbsData surface;
  std::vector<TrimLoop> loops;
  TextPlace place;
};

/// How far apart, as a share of the domain, ends of trimming curves may lie that are one corner,
/// and how far curves may run out of the domain: text files print six digits.
inline constexpr double kTrimGap = 1e-4;

/// The faces of all surfaces as one shape, those whose borders fit within `weld`, a share of the
/// size, sewn together. Loops may turn either way and lie in each other as deep as they like; each
/// outer one makes a face. Surfaces and trimming curves stay exact; borders in space lie within
/// 1e-7 of the size. Throws InputError with `file` and the place for loops that do not close, leave
/// the domain, enclose nothing or cross each other, and for surfaces that OCCT cannot hold (degrees
/// over 25, knots that tear the surface).
std::shared_ptr<const BrepShape> make_trimmed_faces(const std::vector<TrimmedSurface>& surfaces,
                                                    double weld, const std::string& file,
                                                    const RunContext& context);

}  // namespace burin
