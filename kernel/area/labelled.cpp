#include "labelled.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace burin::detail {
namespace {

/// Triangles that a thread labels in a row.
constexpr std::size_t kGrain = 64;
/// Paper mm^2: in smaller triangles a border is not looked for, and one place decides.
constexpr double kLeastDivided = 0.02;
/// Paper mm: in a triangle whose sides are all shorter, and which looks like those beyond its sides
/// without a line, one place decides.
constexpr double kShort = 1;
/// Paper mm: in a triangle of less height three places decide, along its longest side.
constexpr double kThin = 0.4;
/// Thin triangles side by side that a label goes through.
constexpr int kMostThin = 8;
/// Halvings on the way from one node to the next: a thousandth of it.
constexpr int kHalvings = 10;
/// Triangles may grow in number by this factor through all rounds.
constexpr std::size_t kMostGrowth = 6;

using Corners = std::array<Vec2, 3>;
/// Corners and middles of sides in turn.
using Round = std::array<Vec2, 6>;

Corners corners_of(const PlanarMesh& mesh, std::size_t t) {
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

/// From which corner it goes to the next one.
std::size_t longest_side(const Corners& c) {
  const std::array lengths{glm::distance(c[0], c[1]), glm::distance(c[1], c[2]),
                           glm::distance(c[2], c[0])};
  return static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
}

double longest_of(const Corners& c) {
  const std::size_t i = longest_side(c);
  return glm::distance(c[i], c[(i + 1) % 3]);
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

/// What is seen in a triangle.
struct Found {
  AreaLabel middle, label;
  bool mixed = false;
};

/// Adds the places around the middle. The label is that of most; of equally many the middle's, then
/// the first's. Does not write the middle's, which other threads read.
void add_round(Found& found, std::span<const AreaLabel> round) {
  const AreaLabel& middle = found.middle;
  found.label = middle;
  std::ptrdiff_t times = 1 + std::ranges::count(round, middle);
  for (const AreaLabel& label : round) {
    found.mixed = found.mixed || label != middle;
    const std::ptrdiff_t n = std::ranges::count(round, label);
    if (n > times) found.label = label, times = n;
  }
}

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
    n_ = std::clamp(static_cast<int>(std::ceil(longest_of(corners) / kStep)), kFewest, kMost);
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

/// Labels the triangles of a network, round by round.
class Labeller {
 public:
  Labeller(const LabelAt& label_at, const PartitionOptions& options, const RunContext& context)
      : label_at_(label_at), options_(options), context_(context) {}

  LabelledMesh run(Network& network) {
    std::vector<std::array<std::uint32_t, 2>> ends;
    ends.reserve(network.segments.size());
    for (const Segment& s : network.segments) ends.push_back(s.ends);
    triangulation_.add(network.points, ends);
    look();
    const std::size_t most = kMostGrowth * found_.size();
    for (int round = 0; round < options_.rounds && found_.size() < most; ++round) {
      if (!divide(network)) break;
      look();
    }
    LabelledMesh out;
    out.labels = settled();
    for (std::size_t t = 0; t < found_.size(); ++t) {
      if (!found_[t].mixed) continue;
      ++out.mixed;
      out.mixed_area += area_of(mesh_, t);
    }
    out.mesh = std::move(mesh_);
    return out;
  }

 private:
  template <class Each>
  void for_each_new(const Each& each) {
    parallel_for(
        mesh_.triangles.size(), kGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t t = begin; t < end; ++t) {
            if (mesh_.before[t] < 0) each(t);
          }
        },
        &context_);
  }

  /// Looks into the triangles that are new.
  void look() {
    mesh_ = triangulation_.mesh();
    std::vector<Found> found(mesh_.triangles.size());
    for (std::size_t t = 0; t < found.size(); ++t) {
      if (const std::int32_t before = mesh_.before[t]; before >= 0) {
        found[t] = found_[static_cast<std::size_t>(before)];
      }
    }
    found_ = std::move(found);
    for_each_new([&](std::size_t t) {
      const AreaLabel middle = label_at_(middle_of(corners_of(mesh_, t)));
      found_[t] = {middle, middle, false};
    });
    for_each_new([&](std::size_t t) { look_round(t); });
  }

  void look_round(std::size_t t) {
    if (area_of(mesh_, t) < kLeastDivided) return;
    const Corners corners = corners_of(mesh_, t);
    const std::size_t side = longest_side(corners);
    const double longest = glm::distance(corners[side], corners[(side + 1) % 3]);
    if (longest < kShort && as_beside(t)) return;
    const Round places = around(corners, options_.slack);
    std::array<AreaLabel, 6> labels;
    if (2 * area_of(mesh_, t) < kThin * longest) {
      labels[0] = label_at_(places[2 * side]);
      labels[1] = label_at_(places[2 * ((side + 1) % 3)]);
      add_round(found_[t], std::span(labels).first(2));
      return;
    }
    std::ranges::transform(places, labels.begin(), label_at_);
    add_round(found_[t], labels);
  }

  /// Whether the middles of the triangles beyond sides without a line are like its own.
  bool as_beside(std::size_t t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t beyond = mesh_.beyond[t][i];
      if (beyond < 0 || mesh_.constrained[t][i]) continue;
      if (found_[static_cast<std::size_t>(beyond)].middle != found_[t].middle) return false;
    }
    return true;
  }

  /// The labels. Of a triangle so thin that even its middle is near its sides one place says
  /// little: it takes the label of those beyond its sides without a line, if these are wider and
  /// agree.
  std::vector<AreaLabel> settled() const {
    std::vector<AreaLabel> labels;
    std::vector<std::size_t> open;
    std::vector<bool> sure(found_.size(), true);
    for (std::size_t t = 0; t < found_.size(); ++t) {
      labels.push_back(found_[t].label);
      sure[t] = inset_of(corners_of(mesh_, t), options_.slack) < 1;
      if (!sure[t]) open.push_back(t);
    }
    // Of thin ones side by side the outer ones first.
    for (int round = 0; round < kMostThin && !open.empty(); ++round) {
      std::vector<std::pair<std::size_t, AreaLabel>> taken;
      for (const std::size_t t : open) {
        if (const auto label = agreed_beside(t, labels, sure)) taken.emplace_back(t, *label);
      }
      if (taken.empty()) break;
      for (const auto& [t, label] : taken) labels[t] = label, sure[t] = true;
      std::erase_if(open, [&](std::size_t t) { return sure[t]; });
    }
    return labels;
  }

  std::optional<AreaLabel> agreed_beside(std::size_t t, const std::vector<AreaLabel>& labels,
                                         const std::vector<bool>& sure) const {
    std::optional<AreaLabel> label;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t beyond = mesh_.beyond[t][i];
      if (beyond < 0 || mesh_.constrained[t][i]) continue;
      const auto other = static_cast<std::size_t>(beyond);
      if (!sure[other]) continue;
      if (label.value_or(labels[other]) != labels[other]) return std::nullopt;
      label = labels[other];
    }
    return label;
  }

  /// Adds the borders within mixed triangles to the network; whether there are any.
  bool divide(Network& network) {
    std::vector<std::size_t> mixed;
    for (std::size_t t = 0; t < found_.size(); ++t) {
      if (found_[t].mixed) mixed.push_back(t);
    }
    std::vector<Pieces> pieces(mixed.size());
    parallel_for(
        mixed.size(), 1,
        [&](std::size_t i, std::size_t) {
          pieces[i] = TriangleBorder(corners_of(mesh_, mixed[i]), label_at_, options_.slack).find();
        },
        &context_);
    std::vector<Vec2> points;
    std::vector<std::array<std::uint32_t, 2>> ends;
    const auto first = static_cast<std::uint32_t>(network.points.size());
    for (const Pieces& of_one : pieces) {
      for (const auto& [a, b] : of_one) {
        const auto at = static_cast<std::uint32_t>(points.size());
        points.push_back(a);
        points.push_back(b);
        ends.push_back({at, at + 1});
        network.segments.push_back({{first + at, first + at + 1}, -1});
      }
    }
    network.points.insert(network.points.end(), points.begin(), points.end());
    triangulation_.add(points, ends);
    return !points.empty();
  }

  const LabelAt& label_at_;
  const PartitionOptions& options_;
  const RunContext& context_;
  GrowingTriangulation triangulation_;
  PlanarMesh mesh_;
  std::vector<Found> found_;
};

}  // namespace

double area_of(const PlanarMesh& mesh, std::size_t t) {
  const Corners c = corners_of(mesh, t);
  const Vec2 u = c[1] - c[0], v = c[2] - c[0];
  return 0.5 * (u.x * v.y - u.y * v.x);
}

LabelledMesh label_triangles(Network& network, const LabelAt& label_at,
                             const PartitionOptions& options, const RunContext& context) {
  return Labeller(label_at, options, context).run(network);
}

}  // namespace burin::detail
