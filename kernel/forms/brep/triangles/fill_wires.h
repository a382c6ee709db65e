#pragma once
/// Triangles between the wires of a face, however they run.

#include "model_parts.h"

namespace burin {

/// The inside of the wires of a face by the even-odd rule in (u,v), cut into bands at every vertex
/// and every crossing of two sides, and the bands into triangles that fit one another; as many more
/// as keep them within about `tolerance` of the surface, up to a bound. Takes wires that cross or
/// touch themselves or one another, and where a seam is used once its other side is added. Turned
/// like the forward face. Empty where the wires enclose nothing or have more than 2,000 sides.
/// Cost: the square of the number of sides, 10 ns each.
LooseTriangles fill_wires(const ModelParts& parts, std::int32_t face, double tolerance);

}  // namespace burin
