#include "evaluate.h"

#include <burin/base/error.h>

#include "../at_node.h"
#include "hull3.h"
#include "minkowski.h"
#include "places.h"
#include "primitives.h"
#include "shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <unordered_map>

namespace burin::csg {
namespace {

// Cuts within cuts: deeper ones are worked out on their own.
constexpr std::uint32_t kDeepest = 200;
// Nodes that take long enough to tell how many they are.
constexpr std::uint32_t kManyNodes = 10'000;
// Nodes between two looks at the run.
constexpr std::uint32_t kPoll = 256;

struct Result {
  ShapeId shape = kNothing;
  std::shared_ptr<const Region> region;
};

class Evaluator {
 public:
  Evaluator(Evaluation& e, const std::function<void(double)>& share)
      : e_(e), share_(share), dimension_(dimensions(e.tree)), result_(e.tree.nodes.size()) {}

  std::vector<Solid> run(std::span<const std::uint32_t> nodes) {
    find_wanted(nodes);
    const auto count = static_cast<std::uint32_t>(result_.size());
    if (count >= kManyNodes) e_.doing = fmt::format("making the solids of {} nodes", count);
    for (std::uint32_t n = count; n-- > 0;) {
      if (!wanted_[n]) continue;
      if (n % kPoll == 0) report(0.5 * (1 - static_cast<double>(n) / count));
      result_[n] = once(n);
    }
    std::vector<Solid> out;
    std::unordered_map<ShapeId, std::size_t> done;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const ShapeId shape = result_[nodes[k]].shape;
      if (const auto [at, fresh] = done.try_emplace(shape, k); !fresh) {
        out.push_back(out[at->second]);
        continue;
      }
      const double width = 0.5 / static_cast<double>(nodes.size()),
                   from = 0.5 + width * static_cast<double>(k);
      out.push_back(shapes_.solid(shape, e_.run, [&](double s) {
        e_.doing = shapes_.doing;
        report(from + s * width);
      }));
    }
    e_.cuts = shapes_.cuts;
    report_mixed();
    say_flat(nodes);
    return out;
  }

 private:
  void report(double share) {
    e_.run.check();
    reported_ = share;
    share_(share);
  }
  /// What is flat beside solids is seen in OpenSCAD's preview, and nowhere else.
  void say_flat(std::span<const std::uint32_t> nodes) {
    const auto solid = [&](std::uint32_t n) { return dimension_[n] == Dimension::Solid; };
    const auto flat = [&](std::uint32_t n) {
      return result_[n].region && !result_[n].region->empty();
    };
    const auto count = std::ranges::count_if(nodes, flat);
    if (count == 0 || std::ranges::none_of(nodes, solid)) return;
    e_.diagnostics.add(Severity::Warning, "openscad.mixed_dimensions", count,
                       "2-D objects beside solids are left out; extrude them, e.g. with "
                       "linear_extrude(1)");
  }

  /// Before a node that may take long.
  void begin(std::uint32_t n, std::string_view with) {
    e_.doing = fmt::format("{}(){}", name_of(e_.tree.nodes[n].module), with);
    report(reported_);
  }

  /// What lies below the nodes asked for, but not below `%`.
  void find_wanted(std::span<const std::uint32_t> nodes) {
    const auto& tree = e_.tree.nodes;
    wanted_.assign(tree.size(), 0);
    for (const std::uint32_t root : nodes) {
      wanted_[root] = 1;
      for (std::uint32_t n = root + 1; n < tree[root].end;) {
        if (tree[n].background) {
          n = tree[n].end;
        } else {
          wanted_[n++] = 1;
        }
      }
    }
  }

  /// Two nodes of one text have one result: children of one text are known by their first one.
  Result once(std::uint32_t n) {
    const Node& node = e_.tree.nodes[n];
    const std::string& source = e_.tree.source;
    std::string key;
    std::size_t from = node.begin;
    for_each_child(e_.tree, n, [&](std::uint32_t c) {
      const Node& child = e_.tree.nodes[c];
      key.append(source, from, child.begin - from);
      key += fmt::format("\x01{}\x01", child.background && !wanted_[c] ? kNothing : first_[c]);
      from = child.finish;
    });
    key.append(source, from, node.finish - from);
    const auto [at, fresh] = seen_.try_emplace(std::move(key), n);
    if (first_.empty()) first_.assign(e_.tree.nodes.size(), kNothing);
    first_[n] = at->second;
    return fresh ? work_out(n) : result_[at->second];
  }

  std::vector<std::uint32_t> children(std::uint32_t n) const {
    std::vector<std::uint32_t> out;
    for_each_child(e_.tree, n, [&](std::uint32_t c) {
      if (!e_.tree.nodes[c].background) out.push_back(c);
    });
    return out;
  }
  /// The solids below, in order; an empty group counts as nothing, and so does what is flat.
  std::vector<ShapeId> solids(std::uint32_t n) {
    std::vector<ShapeId> out;
    for (const std::uint32_t c : children(n)) {
      out.push_back(dimension_[c] == Dimension::Flat ? kNothing : result_[c].shape);
      if (result_[c].region && !result_[c].region->empty()) {
        csg::report(e_, c, "openscad.mixed_dimensions", "a 2-D object among solids is left out");
      }
    }
    return out;
  }
  std::vector<Region> regions(std::uint32_t n) {
    std::vector<Region> out;
    for (const std::uint32_t c : children(n)) {
      if (dimension_[c] == Dimension::Solid) {
        csg::report(e_, c, "openscad.mixed_dimensions", "a solid among 2-D objects is left out");
        continue;
      }
      out.push_back(result_[c].region ? *result_[c].region : Region{});
    }
    return out;
  }

  Result flat(std::uint32_t n) {
    const Node& node = e_.tree.nodes[n];
    Region region;
    if (node.module == Module::Projection) {
      const Solid solid = shapes_.solid(shapes_.united(solids(n)), e_.run, [](double) {});
      region = solid.empty() ? Region{} : projected(e_, n, solid);
    } else if (node.module == Module::Square || node.module == Module::Circle ||
               node.module == Module::Polygon || node.module == Module::Text ||
               node.module == Module::Import) {
      region = leaf_region(e_, n);
    } else {
      region = combine_regions(e_, n, regions(n));
    }
    return {kNothing, std::make_shared<Region>(std::move(region))};
  }

  Result work_out(std::uint32_t n) {
    if (dimension_[n] == Dimension::Flat) return flat(n);
    Result out{solid_shape(n), nullptr};
    if (shapes_.depth(out.shape) >= kDeepest)
      out.shape = leaf(shapes_.solid(out.shape, e_.run, [](double) {}), n);
    return out;
  }

  ShapeId solid_shape(std::uint32_t n) {
    const Node& node = e_.tree.nodes[n];
    switch (node.module) {
      case Module::Cube:
      case Module::Sphere:
      case Module::Cylinder:
        return shapes_.leaf(primitive(e_, n));
      case Module::Polyhedron:
        return leaf(primitive(e_, n), n);
      case Module::Import:
        return imported(n);
      case Module::Surface:
        return leaf(file_solid(e_, n), n);
      case Module::LinearExtrude:
      case Module::RotateExtrude:
        return extrusion(n);
      case Module::Difference:
        return shapes_.difference(solids(n));
      case Module::Intersection:
        return shapes_.intersection(solids(n));
      case Module::Hull:
        return hull(n);
      case Module::Minkowski:
        return minkowski(n);
      case Module::Resize:
        return resized(n);
      case Module::Multmatrix:
        return turned(n);
      default:
        return shapes_.united(solids(n));
    }
  }

  /// From a file or a list of points: it may be open, or cut itself.
  ShapeId leaf(Solid solid, std::uint32_t n) { return shapes_.leaf(std::move(solid), n); }

  /// Objects of a file may lie in each other.
  ShapeId imported(std::uint32_t n) {
    std::vector<ShapeId> objects;
    for (Solid& object : file_solids(e_, n)) objects.push_back(leaf(std::move(object), n));
    return shapes_.united(std::move(objects));
  }

  void report_mixed() {
    auto& list = shapes_.left_out;
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    for (const std::uint32_t n : list) {
      csg::report(e_, n, "openscad.open_solid",
                  fmt::format("{}() is not closed: no solid to cut or unite; it is left out",
                              name_of(e_.tree.nodes[n].module)));
    }
  }

  /// A matrix that is none takes what it moves out of the picture.
  ShapeId turned(std::uint32_t n) {
    const ShapeId shape = shapes_.united(solids(n));
    const Node& node = e_.tree.nodes[n];
    for (const Argument& a : node.arguments) {
      for (const Value& row : a.value.list) {
        for (const Value& v : row.list) {
          if (v.kind != Value::Kind::Number || std::isfinite(v.number)) continue;
          csg::report(
              e_, n, "openscad.not_finite",
              "a transformation with numbers that are infinite or none; what it moves is left out");
          return kNothing;
        }
      }
    }
    return shapes_.moved(shape, matrix_of(e_.tree, n));
  }

  ShapeId extrusion(std::uint32_t n) {
    const std::vector<Region> below = regions(n);
    const Region region = combine_regions(e_, n, below);
    // What an extrusion of old reads from a file is none of its children.
    const bool from_file = !e_.tree.nodes[n].text("file").empty();
    return region.empty() && !from_file ? kNothing : shapes_.leaf(extruded(e_, n, region));
  }

  ShapeId hull(std::uint32_t n) {
    std::vector<Vec3> points;
    for (const ShapeId s : solids(n)) {
      const std::vector<Vec3> more = shapes_.points(s, e_.run);
      points.insert(points.end(), more.begin(), more.end());
    }
    return shapes_.leaf(convex_hull(points));
  }

  ShapeId minkowski(std::uint32_t n) {
    std::vector<ShapeId> parts = solids(n);
    std::erase(parts, kNothing);
    if (parts.size() < 2) return parts.empty() ? kNothing : parts[0];
    // Those that come to nothing do not count; what is left of one is that one.
    ShapeId whole = kNothing;
    Solid sum;
    for (const ShapeId part : parts) {
      Solid other = summand(part, n);
      if (other.empty()) continue;
      if (whole == kNothing) {
        whole = part;
        sum = std::move(other);
        continue;
      }
      if (sum.empty()) sum = shapes_.solid(whole, e_.run, [](double) {});
      begin(n, fmt::format(", {} by {} triangles", sum.triangles.size(), other.triangles.size()));
      std::vector<ShapeId> pieces;
      for (Solid& piece : minkowski_pieces(sum, other, e_.run)) {
        pieces.push_back(shapes_.leaf(std::move(piece)));
      }
      whole = shapes_.united(std::move(pieces));
      sum = {};
    }
    return whole;
  }
  Solid summand(ShapeId shape, std::uint32_t n) {
    Solid out = shapes_.solid(
        shape, e_.run, [](double) {}, true);
    if (closed(out)) return out;
    csg::report(e_, n, "openscad.open_solid",
                "minkowski() of a solid that is not closed; it is left out");
    return {};
  }

  /// OpenSCAD's rule: sizes of 0 stay as they are, or follow the largest one asked for.
  ShapeId resized(std::uint32_t n) {
    const ShapeId shape = shapes_.united(solids(n));
    const Node& node = e_.tree.nodes[n];
    std::vector<double> size = node.numbers("newsize"), follow = node.numbers("auto");
    size.resize(3, 0);
    follow.resize(3, 0);
    Box3 box;
    for (const Vec3& p : shapes_.points(shape, e_.run)) box.add(p);
    if (box.empty()) return kNothing;
    Matrix m;
    const auto now = [&](std::size_t i) { return box.size()[static_cast<int>(i)]; };
    const std::size_t most =
        static_cast<std::size_t>(std::ranges::max_element(size.begin(), size.end()) - size.begin());
    const double common = size[most] > 0 ? size[most] / now(most) : 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if (size[i] > 0)
        m.row[i][i] = size[i] / now(i);
      else if (follow[i] != 0)
        m.row[i][i] = common;
    }
    return shapes_.moved(shape, m);
  }

  Evaluation& e_;
  const std::function<void(double)>& share_;
  double reported_ = 0;
  std::vector<Dimension> dimension_;
  std::vector<Result> result_;
  std::vector<char> wanted_;
  std::vector<std::uint32_t> first_;
  std::unordered_map<std::string, std::uint32_t> seen_;
  Shapes shapes_;
};

}  // namespace

std::vector<Solid> evaluate(Evaluation& e, std::span<const std::uint32_t> nodes,
                            const std::function<void(double)>& share) {
  return Evaluator(e, share).run(nodes);
}

}  // namespace burin::csg
