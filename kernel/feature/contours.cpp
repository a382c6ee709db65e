#include "contours.h"

#include "noise.h"
#include "zero_lines.h"

#include <utility>

namespace burin {

namespace {

// The contour of a cut proxy is made of samples of the exact line, near enough to one another; on
// any other there is a surface to follow between the edges of the mesh.
bool follows_surface(const ProxyMesh& proxy) { return proxy.on_contour.empty(); }

/// Normals to the open side of the picture: outward where the front side is the nearer one, inward
/// under a fold. A point between both states follows the one that can be seen.
void open_normals(Curve3& curve, const std::vector<std::uint8_t>& folded) {
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool after = i < folded.size() ? folded[i] != 0 : folded.back() != 0;
    const bool before = i > 0 ? folded[i - 1] != 0 : (curve.closed ? folded.back() != 0 : after);
    if (before && after) curve.normals[i] = -curve.normals[i];
  }
}

/// The points from `begin` to `end` (segments; over the end of a closed curve) as a curve of its
/// own.
Curve3 piece(const Curve3& curve, std::size_t begin, std::size_t end) {
  Curve3 out;
  out.kind = curve.kind;
  out.source = curve.source;
  out.occluding = curve.occluding;
  const std::size_t n = curve.points.size();
  for (std::size_t i = begin; i <= end; ++i) {
    out.points.push_back(curve.points[i % n]);
    out.normals.push_back(curve.normals[i % n]);
    if (i < end) out.faces.push_back(curve.faces[i % n]);
  }
  out.self_hidden.assign(out.faces.size(), 0);
  return out;
}

/// Cuts at the cusps: an open sheet shows both its sides, so nothing of it hides itself for
/// certain, but the open side changes there.
void add_pieces(const Curve3& curve, const std::vector<std::uint8_t>& folded,
                std::vector<Curve3>& out) {
  const std::size_t m = folded.size();
  std::size_t start = 0;
  if (curve.closed) {
    while (start < m && folded[start] == folded[(start + m - 1) % m]) ++start;
  }
  if (start == m) {  // one state all round
    out.push_back(curve);
    if (folded[0]) open_normals(out.back(), folded);
    return;
  }
  for (std::size_t i = start, end = start + m; i < end;) {
    std::size_t j = i + 1;
    while (j < end && folded[j % m] == folded[i % m]) ++j;
    out.push_back(piece(curve, i, j));
    if (folded[i % m]) open_normals(out.back(), std::vector<std::uint8_t>(j - i, 1));
    i = j;
  }
}

}  // namespace

Contours trace_contours(const Facing& facing, std::int32_t part, const RunContext& context) {
  const ProxyMesh& proxy = facing.proxy();
  Contours out;
  trace_zeros(facing, follows_surface(proxy), context, [&](ZeroLine&& line) {
    Curve3 curve = line.take_curve(facing, LineClass::Contour, part);
    curve.occluding = true;
    if (curve.closed && is_noise(facing, curve)) {
      ++out.noise;
      return;
    }
    auto folded = folded_under(curve.points, curve.normals, curve.closed, facing.camera());
    if (follows_surface(proxy)) follow_surface(facing, line.chords, curve, folded);
    if (proxy.closed(line.first_face)) {
      curve.self_hidden = std::move(folded);
      open_normals(curve, curve.self_hidden);
      out.curves.push_back(std::move(curve));
    } else {
      add_pieces(curve, folded, out.curves);
    }
  });
  return out;
}

}  // namespace burin
