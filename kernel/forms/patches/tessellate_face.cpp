// The triangles of one face.

#include "tessellate.h"

#include <algorithm>

namespace burin::detail {
namespace {

struct Node {
  std::uint32_t vertex = 0;
  Vec2 uv{0};
  int collapsed = -1;  // the direction that has no length at a pole
};

struct BorderSegment {
  std::int32_t edge = -1, coedge = -1;
  double t0 = 0, t1 = 0;
};

class FaceTriangles {
 public:
  FaceTriangles(RawMesh& raw, const PatchComplex& complex, std::int32_t face, const FaceGrid& grid)
      : mesh_(raw.mesh),
        pole_(raw.pole),
        complex_(complex),
        face_(face),
        reversed_(complex.atlas->reversed(face)),
        grid_(grid),
        columns_(grid.lines[0].size() - 2),
        rows_(grid.lines[1].size() - 2) {}

  void add_inside();
  void add_strip(int side, const std::vector<SideNode>& nodes);

 private:
  const Node& inner(std::size_t i, std::size_t j) const { return inner_[i * rows_ + j]; }
  std::vector<Node> inner_chain(int side) const;
  double square(const Node& a, const Node& b) const {
    const Vec3 d = mesh_.positions[a.vertex] - mesh_.positions[b.vertex];
    return glm::dot(d, d);
  }
  /// Counter-clockwise in (u,v); `first` lies on the border where `border` is given.
  void add(Node a, Node b, Node c, const BorderSegment* border = nullptr);

  ChartMesh& mesh_;
  std::vector<std::uint8_t>& pole_;
  const PatchComplex& complex_;
  std::int32_t face_;
  bool reversed_;
  const FaceGrid& grid_;
  std::size_t columns_, rows_;
  std::vector<Node> inner_;
};

void FaceTriangles::add(Node a, Node b, Node c, const BorderSegment* border) {
  std::array<Node, 3> n{a, b, c};
  // A pole has no place along the direction that collapses: the middle of what is opposite.
  for (std::size_t k = 0; k < 3; ++k) {
    const int i = n[k].collapsed;
    if (i >= 0) n[k].uv[i] = 0.5 * (n[(k + 1) % 3].uv[i] + n[(k + 2) % 3].uv[i]);
  }
  std::size_t on_border = 0;
  if (reversed_) {
    std::swap(n[0], n[1]);  // the border side stays first: b to a
  }
  mesh_.triangles.push_back({n[0].vertex, n[1].vertex, n[2].vertex});
  mesh_.face.push_back(face_);
  for (std::size_t k = 0; k < 3; ++k) {
    mesh_.uv.push_back(n[k].uv);
    pole_.push_back(static_cast<std::uint8_t>(n[k].collapsed + 1));
    if (!border || k != on_border) {
      mesh_.border.push_back(-1);
      continue;
    }
    mesh_.border.push_back(static_cast<std::int32_t>(mesh_.borders.size()));
    const double t0 = reversed_ ? border->t1 : border->t0, t1 = reversed_ ? border->t0 : border->t1;
    mesh_.borders.push_back({border->edge, border->coedge, t0, t1});
  }
}

void FaceTriangles::add_inside() {
  const Chart& chart = complex_.atlas->chart(face_);
  for (std::size_t i = 0; i < columns_; ++i) {
    for (std::size_t j = 0; j < rows_; ++j) {
      const Vec2 uv(grid_.lines[0][i + 1], grid_.lines[1][j + 1]);
      inner_.push_back({static_cast<std::uint32_t>(mesh_.positions.size()), uv});
      mesh_.positions.push_back(chart.position(uv));
    }
  }
  for (std::size_t i = 0; i + 1 < columns_; ++i) {
    for (std::size_t j = 0; j + 1 < rows_; ++j) {
      const Node &a = inner(i, j), &b = inner(i + 1, j), &c = inner(i + 1, j + 1),
                 &d = inner(i, j + 1);
      // 1e-9: where both diagonals are alike rounding must not choose.
      if (square(a, c) <= square(b, d) * (1 + 1e-9)) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  }
}

std::vector<Node> FaceTriangles::inner_chain(int side) const {
  std::vector<Node> chain;
  const bool along_u = side_direction(side) == 0;
  const std::size_t n = along_u ? columns_ : rows_;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = side_descends(side) ? n - 1 - k : k;
    if (along_u) {
      chain.push_back(inner(at, side == 0 ? 0 : rows_ - 1));
    } else {
      chain.push_back(inner(side == 3 ? 0 : columns_ - 1, at));
    }
  }
  return chain;
}

// Between two chains, always on with the one that is behind.
void FaceTriangles::add_strip(int side, const std::vector<SideNode>& nodes) {
  const ParameterBox box = complex_.atlas->chart(face_).domain();
  const int direction = side_direction(side);
  const std::int32_t coedge =
      complex_.coedge[static_cast<std::size_t>(face_)][static_cast<std::size_t>(side)];
  std::vector<Node> outer;
  for (const SideNode& n : nodes) {
    outer.push_back({n.vertex, side_uv(box, side, n.side_t), coedge < 0 ? direction : -1});
  }
  // The tips of a side may lie on a pole of the sides beside it.
  const auto& coedges = complex_.coedge[static_cast<std::size_t>(face_)];
  const auto pole = [&](int s) { return coedges[static_cast<std::size_t>(s % 4)] < 0; };
  if (coedge >= 0 && pole(side + 3)) outer.front().collapsed = 1 - direction;
  if (coedge >= 0 && pole(side + 1)) outer.back().collapsed = 1 - direction;
  const std::vector<Node> chain = inner_chain(side);
  const double sign = side_descends(side) ? -1 : 1;
  const auto place = [&](const Node& n) { return sign * n.uv[direction]; };
  std::size_t i = 0, k = 0;
  while (i + 1 < outer.size() || k + 1 < chain.size()) {
    bool on_outer = k + 1 >= chain.size();
    if (!on_outer && i + 1 < outer.size()) {
      const double a = place(outer[i]) + place(outer[i + 1]);
      const double b = place(chain[k]) + place(chain[k + 1]);
      const double slack = 1e-9 * box.size()[direction];
      on_outer = a < b - slack ||
                 (a <= b + slack &&
                  square(outer[i + 1], chain[k]) <= square(outer[i], chain[k + 1]) * (1 + 1e-9));
    }
    if (on_outer) {
      const BorderSegment segment{complex_.atlas->uses()[static_cast<std::size_t>(coedge)].edge,
                                  coedge, nodes[i].edge_t, nodes[i + 1].edge_t};
      add(outer[i], outer[i + 1], chain[k], &segment);
      ++i;
    } else {
      add(outer[i], chain[k + 1], chain[k]);
      ++k;
    }
  }
}

}  // namespace

void add_face(RawMesh& raw, const PatchComplex& complex, std::int32_t face, const FaceGrid& grid,
              const std::array<std::vector<SideNode>, 4>& sides) {
  FaceTriangles triangles(raw, complex, face, grid);
  triangles.add_inside();
  for (int s = 0; s < 4; ++s) triangles.add_strip(s, sides[static_cast<std::size_t>(s)]);
}

}  // namespace burin::detail
