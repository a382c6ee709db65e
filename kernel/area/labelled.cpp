#include "labelled.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>

namespace burin::detail {
namespace {

/// Triangles that a thread labels in a row.
constexpr std::size_t kGrain = 64;
/// Paper mm^2: in smaller triangles a border is not looked for, and one place decides.
constexpr double kLeastDivided = 0.02;
/// Halvings on the way from one node to the next: a thousandth of it.
constexpr int kHalvings = 10;
/// Triangles may grow in number by this factor through all rounds.
constexpr std::size_t kMostGrowth = 6;

using Corners = std::array<Vec2, 3>;
/// Corners and middles of sides in turn.
using Round = std::array<Vec2, 6>;

Corners corners_of(const SheetMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

Vec2 middle_of(const Corners& c) { return (c[0] + c[1] + c[2]) / 3.0; }

/// The share of the way to the middle at which all of it is `slack` away from the sides.
double inset_of(const Corners& c, double slack) {
  const Vec2 u = c[1] - c[0], v = c[2] - c[0];
  const double longest = std::max({glm::length(u), glm::length(v), glm::distance(c[1], c[2])});
  const double height = (u.x * v.y - u.y * v.x) / longest;
  return height > 0 ? 3 * slack / height : 1;  // the middle is a third of each height away
}

/// Places just inside the triangle: on its sides both neighbours may be seen.
Round around(const Corners& c, double slack) {
  constexpr double kInset = 0.04;
  const double inset = std::clamp(inset_of(c, slack), kInset, 1.0);
  const Vec2 m = middle_of(c);
  Round out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[2 * i] = glm::mix(c[i], m, inset);
    out[2 * i + 1] = glm::mix(0.5 * (c[i] + c[(i + 1) % 3]), m, inset);
  }
  return out;
}

struct Labels {
  AreaLabel middle;
  std::array<AreaLabel, 6> round;

  bool mixed() const {
    return std::ranges::any_of(round, [&](const AreaLabel& l) { return l != middle; });
  }
  /// What most of them are; of equally many the middle's, then the first's.
  AreaLabel most() const {
    AreaLabel best = middle;
    std::ptrdiff_t times = 1 + std::ranges::count(round, middle);
    for (const AreaLabel& label : round) {
      const std::ptrdiff_t n = std::ranges::count(round, label);
      if (n > times) best = label, times = n;
    }
    return best;
  }
};

/// Borders within one triangle, as pieces from end to end.
using Pieces = std::vector<std::array<Vec2, 2>>;

/// Follows them through a grid of smaller triangles.
class TriangleBorder {
 public:
  TriangleBorder(const Corners& corners, const LabelAt& label_at, double slack)
      : corners_(corners),
        middle_(middle_of(corners)),
        inset_(std::clamp(inset_of(corners, slack), kInset, 0.5)),
        label_at_(label_at) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, glm::distance(corners[i], corners[(i + 1) % 3]));
    }
    n_ = std::clamp(static_cast<int>(std::ceil(longest / kStep)), kFewest, kMost);
    for (int j = 0; j <= n_; ++j) {
      for (int i = 0; i + j <= n_; ++i) labels_.push_back(label_at_(place({i, j})));
    }
  }

  Pieces find() {
    for (int j = 0; j < n_; ++j) {
      for (int i = 0; i + j < n_; ++i) {
        add_cell({{{i, j}, {i + 1, j}, {i, j + 1}}});
        if (i + j + 1 < n_) add_cell({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
      }
    }
    return std::move(pieces_);
  }

 private:
  /// Paper mm between nodes; a border of 10 mm radius lies within 0.0125 mm of its pieces.
  static constexpr double kStep = 1;
  static constexpr int kFewest = 3, kMost = 32;
  static constexpr double kInset = 0.02, kBeyond = 1.002;

  struct Node {
    int i, j;
    auto operator<=>(const Node&) const = default;
  };

  Vec2 place(Node at) const {
    const double u = static_cast<double>(at.i) / n_, v = static_cast<double>(at.j) / n_;
    return glm::mix((1 - u - v) * corners_[0] + u * corners_[1] + v * corners_[2], middle_, inset_);
  }

  const AreaLabel& label(Node at) const {
    // Rows of n + 1, n, n - 1 ... nodes.
    return labels_[static_cast<std::size_t>(at.j * (n_ + 1) - at.j * (at.j - 1) / 2 + at.i)];
  }

  bool on_side(Node a, Node b) const {
    return (a.i == 0 && b.i == 0) || (a.j == 0 && b.j == 0) || (a.i + a.j == n_ && b.i + b.j == n_);
  }

  /// Where the label changes from `a` to `b`: the same for both cells beside them.
  Vec2 change(Node a, Node b) {
    if (b < a) std::swap(a, b);
    const auto [it, is_new] = changes_.try_emplace({a, b});
    if (!is_new) return it->second;
    Vec2 from = place(a), to = place(b);
    for (int k = 0; k < kHalvings; ++k) {
      const Vec2 m = 0.5 * (from + to);
      (label_at_(m) == label(a) ? from : to) = m;
    }
    it->second = 0.5 * (from + to);
    if (on_side(a, b)) {  // up to the side, and a little beyond
      const Vec2 out = middle_ + kBeyond / (1 - inset_) * (it->second - middle_);
      pieces_.push_back({it->second, out});
    }
    return it->second;
  }

  void add_cell(const std::array<Node, 3>& nodes) {
    std::vector<Vec2> changes;
    for (std::size_t k = 0; k < 3; ++k) {
      const Node a = nodes[k], b = nodes[(k + 1) % 3];
      if (label(a) != label(b)) changes.push_back(change(a, b));
    }
    if (changes.size() == 2) pieces_.push_back({changes[0], changes[1]});
    if (changes.size() != 3) return;
    const Vec2 meet = (place(nodes[0]) + place(nodes[1]) + place(nodes[2])) / 3.0;
    for (const Vec2& p : changes) pieces_.push_back({meet, p});
  }

  const Corners& corners_;
  Vec2 middle_;
  double inset_;
  const LabelAt& label_at_;
  int n_ = 0;
  std::vector<AreaLabel> labels_;
  std::map<std::pair<Node, Node>, Vec2> changes_;
  Pieces pieces_;
};

}  // namespace

namespace {

/// What was found in triangles of the round before, most of which are there again.
class Known {
 public:
  struct Found {
    AreaLabel label;
    bool mixed = false;
  };

  const Found* find(const Corners& corners) const {
    const auto it = found_.find(key(corners));
    return it == found_.end() ? nullptr : &it->second;
  }

  void keep(const SheetMesh& mesh, const std::vector<Found>& found) {
    found_.clear();
    for (std::size_t t = 0; t < found.size(); ++t) {
      found_.emplace(key(corners_of(mesh, t)), found[t]);
    }
  }

 private:
  using Key = std::array<double, 6>;
  struct Hash {
    std::size_t operator()(const Key& key) const {
      std::size_t h = 0;
      for (const double x : key) h = h * 1099511628211U + std::hash<double>()(x);
      return h;
    }
  };

  /// The same for whichever corner is the first.
  static Key key(Corners c) {
    const auto less = [](Vec2 a, Vec2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
    std::rotate(c.begin(), std::min_element(c.begin(), c.end(), less), c.end());
    return {c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y};
  }

  std::unordered_map<Key, Found, Hash> found_;
};

}  // namespace

double area_of(const SheetMesh& mesh, std::size_t t) {
  const Corners c = corners_of(mesh, t);
  const Vec2 u = c[1] - c[0], v = c[2] - c[0];
  return 0.5 * (u.x * v.y - u.y * v.x);
}

LabelledMesh label_triangles(Network& network, const LabelAt& label_at,
                             const PartitionOptions& options, const RunContext& context) {
  LabelledMesh out;
  Known known;
  std::size_t most = 0;
  for (int round = 0;; ++round) {
    std::vector<std::array<std::uint32_t, 2>> ends;
    ends.reserve(network.segments.size());
    for (const Segment& s : network.segments) ends.push_back(s.ends);
    out.mesh = triangulate_sheet(network.points, ends);
    const std::size_t n = out.mesh.triangles.size();
    if (round == 0) most = kMostGrowth * n;
    const bool divides = round < options.rounds && n < most;
    std::vector<Known::Found> found(n);
    std::vector<Pieces> pieces(n);
    parallel_for(
        n, kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t t = begin; t < end; ++t) {
            const Corners corners = corners_of(out.mesh, t);
            if (const Known::Found* before = known.find(corners)) {
              found[t] = *before;
            } else {
              Labels labels{label_at(middle_of(corners)), {}};
              labels.round.fill(labels.middle);
              if (area_of(out.mesh, t) >= kLeastDivided) {
                std::ranges::transform(around(corners, options.slack), labels.round.begin(),
                                       label_at);
              }
              found[t] = {labels.most(), labels.mixed()};
            }
            if (divides && found[t].mixed) {
              pieces[t] = TriangleBorder(corners, label_at, options.slack).find();
            }
          }
        },
        &context);
    out.labels.clear();
    out.mixed = 0;
    out.mixed_area = 0;
    for (std::size_t t = 0; t < n; ++t) {
      out.labels.push_back(found[t].label);
      if (!found[t].mixed) continue;
      ++out.mixed;
      out.mixed_area += area_of(out.mesh, t);
    }
    if (!divides || out.mixed == 0) return out;
    known.keep(out.mesh, found);
    for (const Pieces& of_one : pieces) {
      for (const auto& [a, b] : of_one) {
        const auto first = static_cast<std::uint32_t>(network.points.size());
        network.points.push_back(a);
        network.points.push_back(b);
        network.segments.push_back({{first, first + 1}, -1});
      }
    }
  }
}

}  // namespace burin::detail
