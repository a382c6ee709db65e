#include "surface_nets.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burin {
namespace {

constexpr int kSide = Grid::kSide;
constexpr int kCellsOfBlock = kSide * kSide * kSide;
constexpr std::uint8_t kNone = 255;

// Edge of a cell: along `axis`, at place (b, c) of the two axes that follow.
int edge_index(int axis, int b, int c) { return 4 * axis + b + 2 * c; }

int corner_bit(int axis, int a, int b, int c) {
  return (a << axis) | (b << ((axis + 1) % 3)) | (c << ((axis + 2) % 3));
}

// For each of the 256 sign patterns of a cell (bit = inside): the sheets that its crossed edges
// belong to. On faces with two inside corners on a diagonal the surface parts these corners; that
// rule looks the same from both sides.
struct CellCase {
  std::uint8_t sheet[12];
  std::uint8_t sheets = 0;
  std::uint8_t ambiguous = 0;  // bit 2 * axis + side
};

void join(std::uint8_t (&sheet)[12], int a, int b) {
  const std::uint8_t low = std::min(sheet[a], sheet[b]), high = std::max(sheet[a], sheet[b]);
  for (std::uint8_t& s : sheet) {
    if (s == high) s = low;
  }
}

CellCase make_case(int signs) {
  CellCase result;
  const auto inside = [&](int corner) { return (signs >> corner) & 1; };
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) {
      const int low = corner_bit(axis, 0, k & 1, k >> 1), high = corner_bit(axis, 1, k & 1, k >> 1);
      const int e = edge_index(axis, k & 1, k >> 1);
      result.sheet[e] = inside(low) != inside(high) ? static_cast<std::uint8_t>(e) : kNone;
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      // The face's four edges: along u at v = 0, 1; along v at u = 0, 1. Of an edge along u the
      // axes that follow are (v, axis), of one along v (axis, u).
      const int along_u[2] = {edge_index(u, 0, side), edge_index(u, 1, side)};
      const int along_v[2] = {edge_index(v, side, 0), edge_index(v, side, 1)};
      int crossed[4], n = 0;
      for (const int e : {along_u[0], along_u[1], along_v[0], along_v[1]}) {
        if (result.sheet[e] != kNone) crossed[n++] = e;
      }
      if (n == 2) join(result.sheet, crossed[0], crossed[1]);
      if (n < 4) continue;
      result.ambiguous |= static_cast<std::uint8_t>(1 << (2 * axis + side));
      for (int cu = 0; cu < 2; ++cu) {
        for (int cv = 0; cv < 2; ++cv) {
          const int corner = (side << axis) | (cu << u) | (cv << v);
          if (inside(corner)) join(result.sheet, along_u[cv], along_v[cu]);
        }
      }
    }
  }
  // Numbered from 0 in order of the edges.
  std::uint8_t names[12];
  std::fill(std::begin(names), std::end(names), kNone);
  for (std::uint8_t& s : result.sheet) {
    if (s == kNone) continue;
    if (names[s] == kNone) names[s] = result.sheets++;
    s = names[s];
  }
  return result;
}

const std::array<CellCase, 256>& cases() {
  static const std::array<CellCase, 256> table = [] {
    std::array<CellCase, 256> t;
    for (int i = 0; i < 256; ++i) t[static_cast<std::size_t>(i)] = make_case(i);
    return t;
  }();
  return table;
}

Cell local(int index) { return {index % kSide, index / kSide % kSide, index / (kSide * kSide)}; }
int local_index(Cell c) { return (c.z * kSide + c.y) * kSide + c.x; }

Cell axis_cell(int axis) {
  Cell c(0);
  c[axis] = 1;
  return c;
}

struct BlockCells {
  std::array<std::uint8_t, kCellsOfBlock> signs;    // 0 and 255: no surface
  std::array<std::uint32_t, kCellsOfBlock> vertex;  // of the cell's first sheet
  std::uint32_t count = 0;
};

// A vertex put in where a polygon edge would belong to four polygons: on a face between two cells
// through which one sheet of each passes twice.
struct Extra {
  std::uint64_t face = 0, edge = 0;
  std::uint32_t vertex = 0;
  auto order() const { return std::pair(face, edge); }
};

std::uint64_t key(Cell c, int axis) {
  const auto part = [](int v) { return static_cast<std::uint64_t>(v + 1) & 0xfffff; };
  return ((part(c.x) | (part(c.y) << 20) | (part(c.z) << 40)) << 2) |
         static_cast<std::uint64_t>(axis);
}

class NetMaker {
 public:
  NetMaker(const Grid& grid, const RunContext& context)
      : grid_(grid), context_(context), cells_(grid.blocks().size()) {}

  Nets make() {
    find_signs();
    number_vertices();
    place_vertices();
    find_extras();
    make_polygons();
    return std::move(nets_);
  }

 private:
  void find_signs() {
    parallel_for(
        cells_.size(), 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t b = begin; b < end; ++b) find_signs(b);
        },
        &context_);
  }
  void find_signs(std::size_t b) {
    const Grid::Block& block = grid_.blocks()[b];
    BlockCells& out = cells_[b];
    for (int i = 0; i < kCellsOfBlock; ++i) {
      const Cell c = local(i);
      int signs = 0;
      for (int k = 0; k < 8; ++k) {
        signs |= (block.at(c + Cell(k & 1, (k >> 1) & 1, k >> 2)) < 0 ? 1 : 0) << k;
      }
      out.signs[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(signs);
      out.count += cases()[static_cast<std::size_t>(signs)].sheets;
    }
  }

  void number_vertices() {
    std::uint32_t next = 0;
    for (BlockCells& b : cells_) {
      for (std::size_t i = 0; i < kCellsOfBlock; ++i) {
        b.vertex[i] = next;
        next += cases()[b.signs[i]].sheets;
      }
    }
    nets_.vertices.resize(next, Vec3(0));
    nets_.first_extra = next;
    nets_.sources.resize(next);
  }

  void place_vertices() {
    parallel_for(
        cells_.size(), 64,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t b = begin; b < end; ++b) {
            for (int i = 0; i < kCellsOfBlock; ++i) {
              if (cells_[b].count > 0) place_vertices(b, i);
            }
          }
        },
        &context_);
  }
  void place_vertices(std::size_t b, int i) {
    const Grid::Block& block = grid_.blocks()[b];
    const CellCase& c = cases()[cells_[b].signs[static_cast<std::size_t>(i)]];
    if (c.sheets == 0) return;
    const std::uint32_t first = cells_[b].vertex[static_cast<std::size_t>(i)];
    int count[12] = {};
    for (int axis = 0; axis < 3; ++axis) {
      for (int k = 0; k < 4; ++k) {
        const std::uint8_t sheet = c.sheet[edge_index(axis, k & 1, k >> 1)];
        if (sheet == kNone) continue;
        const std::uint32_t v = first + sheet;
        const CrossedEdge e = crossed(block, local(i), axis, k & 1, k >> 1);
        nets_.vertices[v] += e.at;
        ++count[sheet];
      }
    }
    for (std::uint8_t s = 0; s < c.sheets; ++s) {
      nets_.vertices[first + s] /= count[s];
      nets_.sources[first + s] = {block.first + local(i),
                                  cells_[b].signs[static_cast<std::size_t>(i)], s};
    }
  }

  struct CrossedEdge {
    Vec3 at;
  };
  CrossedEdge crossed(const Grid::Block& block, Cell cell, int axis, int b, int c) const {
    Cell low = cell;
    low[(axis + 1) % 3] += b;
    low[(axis + 2) % 3] += c;
    const Cell high = low + axis_cell(axis);
    const double u = block.at(low), v = block.at(high);
    const Vec3 p = grid_.layout().corner(block.first + low),
               q = grid_.layout().corner(block.first + high);
    const double share = u / (u - v);
    // Values without measure (infinite, NaN) say no more than their sign.
    const Vec3 at = p + (share > 0.01 && share < 0.99 ? share
                         : share <= 0.01              ? 0.01
                         : share >= 0.99              ? 0.99
                                                      : 0.5) *
                            (q - p);
    return {at};
  }

  // The signs and the first vertex of any cell of the grid; false where no block holds it.
  bool find(Cell cell, std::size_t near, std::uint8_t& signs, std::uint32_t& vertex) const {
    std::size_t b = near;
    Cell inner = cell - grid_.blocks()[near].first;
    for (int a = 0; a < 3; ++a) {
      if (inner[a] >= 0 && inner[a] < kSide) continue;
      const std::int32_t other = grid_.block_of(cell);
      if (other < 0) return false;
      b = static_cast<std::size_t>(other);
      inner = cell - grid_.blocks()[b].first;
      break;
    }
    const auto i = static_cast<std::size_t>(local_index(inner));
    signs = cells_[b].signs[i];
    vertex = cells_[b].vertex[i];
    return true;
  }

  void find_extras() {
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      for (int i = 0; i < kCellsOfBlock; ++i) {
        const CellCase& c = cases()[cells_[b].signs[static_cast<std::size_t>(i)]];
        for (int axis = 0; axis < 3; ++axis) {
          if (c.ambiguous & (1 << (2 * axis + 1))) find_extras(b, i, axis, c);
        }
      }
    }
    std::ranges::sort(extras_, {}, &Extra::order);
  }
  void find_extras(std::size_t b, int i, int axis, const CellCase& c) {
    const Cell cell = grid_.blocks()[b].first + local(i);
    std::uint8_t signs = 0;
    std::uint32_t vertex = 0;
    if (!find(cell + axis_cell(axis), b, signs, vertex)) return;
    const CellCase& other = cases()[signs];
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const int mine[4] = {edge_index(u, 0, 1), edge_index(u, 1, 1), edge_index(v, 1, 0),
                         edge_index(v, 1, 1)};
    const int theirs[4] = {edge_index(u, 0, 0), edge_index(u, 1, 0), edge_index(v, 0, 0),
                           edge_index(v, 0, 1)};
    for (int k = 1; k < 4; ++k) {
      if (c.sheet[mine[k]] != c.sheet[mine[0]]) return;
      if (other.sheet[theirs[k]] != other.sheet[theirs[0]]) return;
    }
    const auto inside = [&](int cu, int cv) {
      return (cells_[b].signs[static_cast<std::size_t>(i)] >>
              ((1 << axis) | (cu << u) | (cv << v))) &
             1;
    };
    for (int cu = 0; cu < 2; ++cu) {
      for (int cv = 0; cv < 2; ++cv) {
        if (!inside(cu, cv)) continue;
        // The pair around this inside corner: the edge along u at cv and the one along v at cu.
        const CrossedEdge e = crossed(grid_.blocks()[b], local(i), u, cv, 1);
        const CrossedEdge f = crossed(grid_.blocks()[b], local(i), v, 1, cu);
        const auto fresh = static_cast<std::uint32_t>(nets_.vertices.size());
        nets_.vertices.push_back(0.5 * (e.at + f.at));
        nets_.sources.push_back(
            {cell, cells_[b].signs[static_cast<std::size_t>(i)], c.sheet[mine[0]]});
        Cell low_u = cell + axis_cell(axis), low_v = low_u;
        low_u[v] += cv;
        low_v[u] += cu;
        extras_.push_back({key(cell, axis), key(low_u, u), fresh});
        extras_.push_back({key(cell, axis), key(low_v, v), fresh});
      }
    }
  }

  void make_polygons() {
    struct Part {
      std::vector<std::uint32_t> corners, sizes;
    };
    constexpr std::size_t kGrain = 64;
    std::vector<Part> parts((cells_.size() + kGrain - 1) / kGrain);
    parallel_for(
        cells_.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          Part& part = parts[begin / kGrain];
          for (std::size_t b = begin; b < end; ++b) {
            for (int i = 0; i < kCellsOfBlock; ++i) {
              const std::uint8_t signs = cells_[b].signs[static_cast<std::size_t>(i)];
              if (signs == 0 || signs == 255) continue;
              for (int axis = 0; axis < 3; ++axis) {
                const bool low = signs & 1, high = (signs >> (1 << axis)) & 1;
                if (low != high) polygon(b, i, axis, low, part.corners, part.sizes);
              }
            }
          }
        },
        &context_);
    nets_.first_corner.push_back(0);
    for (const Part& part : parts) {
      nets_.corners.insert(nets_.corners.end(), part.corners.begin(), part.corners.end());
      for (const std::uint32_t n : part.sizes) {
        nets_.first_corner.push_back(nets_.first_corner.back() + n);
      }
    }
  }
  // Around the edge of cell i that begins at its lowest corner.
  void polygon(std::size_t b, int i, int axis, bool outwards, std::vector<std::uint32_t>& corners,
               std::vector<std::uint32_t>& sizes) const {
    constexpr int kBack[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Cell cell = grid_.blocks()[b].first + local(i);
    const Cell u = axis_cell((axis + 1) % 3), v = axis_cell((axis + 2) % 3);
    std::uint32_t ring[8];
    std::size_t n = 0;
    for (int k = 0; k < 4; ++k) {
      const Cell at = cell - kBack[k][0] * u - kBack[k][1] * v;
      std::uint8_t signs = 0;
      std::uint32_t vertex = 0;
      if (!find(at, b, signs, vertex)) return;  // the border of the grid, which is outside
      const CellCase& c = cases()[signs];
      ring[n++] = vertex + c.sheet[edge_index(axis, kBack[k][0], kBack[k][1])];
      if (extras_.empty() || c.ambiguous == 0) continue;
      // The face to the next cell of the ring, named by the cell on its lower side.
      const int next = (k + 1) % 4;
      const Cell beyond = cell - kBack[next][0] * u - kBack[next][1] * v;
      const int across = k % 2 == 0 ? (axis + 1) % 3 : (axis + 2) % 3;
      const Extra wanted{key(glm::min(at, beyond), across), key(cell, axis), 0};
      const auto it = std::ranges::lower_bound(extras_, wanted.order(), {}, &Extra::order);
      if (it != extras_.end() && it->order() == wanted.order()) ring[n++] = it->vertex;
    }
    if (!outwards) std::reverse(ring, ring + n);
    corners.insert(corners.end(), ring, ring + n);
    sizes.push_back(static_cast<std::uint32_t>(n));
  }

  const Grid& grid_;
  const RunContext& context_;
  std::vector<BlockCells> cells_;
  std::vector<Extra> extras_;
  Nets nets_;
};

}  // namespace

std::vector<std::array<Vec3, 2>> crossed_edges(const GridLayout& layout,
                                               const Nets::Source& source) {
  std::vector<std::array<Vec3, 2>> edges;
  const CellCase& c = cases()[source.signs];
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 4; ++k) {
      if (c.sheet[edge_index(axis, k & 1, k >> 1)] != source.sheet) continue;
      Cell low = source.cell;
      low[(axis + 1) % 3] += k & 1;
      low[(axis + 2) % 3] += k >> 1;
      const Vec3 p = layout.corner(low), q = layout.corner(low + axis_cell(axis));
      const bool inside = (source.signs >> corner_bit(axis, 0, k & 1, k >> 1)) & 1;
      edges.push_back(inside ? std::array{p, q} : std::array{q, p});
    }
  }
  return edges;
}

Nets make_nets(const Grid& grid, const RunContext& context) {
  return NetMaker(grid, context).make();
}

}  // namespace burin
