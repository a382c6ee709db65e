#pragma once
/// Items of objects under a homogeneous matrix.

#include <burin/converters/irit_tree.h>

#include <array>

namespace burin::irit {

/// 16 numbers, rows one after another; points (x, y, z, 1) are rows to its left.
using Matrix = std::array<double, 16>;

/// Moves the control points, exactly: a matrix in perspective changes their weights. What has no
/// points in space (numbers, texts) stays as it is; trivariates, which are functions of their
/// parameters, are placed, and become unread under a matrix in perspective. Throws GeometryError
/// where a point, or a weight, is no longer positive and finite.
void transform(IritItem& item, const Matrix& matrix);

}  // namespace burin::irit
