#pragma once
/// Graphs whose links carry values from node to node, and the algebra of the two kinds of values.

#include <burin/surface/tangent_basis.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace burin::field {

/// No node.
constexpr std::uint32_t kNone = 0xffffffffu;
/// Wedges or nodes a range of the parallel loops.
constexpr std::size_t kGrain = 4096;

/// A value at a node is a complex number (a cross, as its direction to the fourth power) or a real
/// one (the sign of a label).
inline Vec2 times(Vec2 a, Vec2 b) { return complex_mul(a, b); }
inline Vec2 conjugate(Vec2 a) { return complex_conj(a); }
inline double size_of(Vec2 a) { return glm::length(a); }
inline double real_of(Vec2 a) { return a.x; }
inline Vec2 unit_of(Vec2) { return {1, 0}; }
inline double times(double a, double b) { return a * b; }
inline double conjugate(double a) { return a; }
inline double size_of(double a) { return std::abs(a); }
inline double real_of(double a) { return a; }
inline double unit_of(double) { return 1; }

/// Row i has the links first[i] .. first[i+1]; `coupling` is w r, where w >= 0 is the link's weight
/// and r carries a value from the neighbour to i (|r| <= 1; less where the link stands for several
/// that disagree).
template <class Scalar>
struct Links {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> neighbour;
  std::vector<Scalar> coupling;
  /// For each node the sum of its links' weights.
  std::vector<double> stiffness;

  std::size_t size() const { return stiffness.size(); }
};

}  // namespace burin::field
