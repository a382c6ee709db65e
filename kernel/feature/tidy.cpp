#include "tidy.h"

#include "edge_chains.h"
#include "paper_limits.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

namespace burin {

namespace {

using PointKey = std::array<double, 3>;
PointKey point_key(const Vec3& p) { return {p.x, p.y, p.z}; }

void reverse(Curve3& c) {
  std::ranges::reverse(c.points);
  std::ranges::reverse(c.normals);
  std::ranges::reverse(c.faces);
  std::ranges::reverse(c.self_hidden);
}

// What is drawn as the border of the object alone stays apart from what is drawn anyway.
bool joinable(const Curve3& c) {
  return c.kind == LineClass::Contour && !c.closed && !c.border_alone;
}

/// Which curves end at which points.
class Ends {
 public:
  explicit Ends(const std::vector<Curve3>& curves) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (!joinable(curves[i])) continue;
      for (const bool front : {true, false}) {
        const Vec3& p = front ? curves[i].points.front() : curves[i].points.back();
        ends_.push_back({point_key(p), curves[i].source, i, front});
      }
    }
    std::ranges::sort(ends_, {}, [](const End& e) { return std::pair(e.key(), e.curve); });
  }

  /// The only other curve of the same source at the given end of curve `i`, and which of its ends.
  std::pair<std::size_t, bool> partner(const std::vector<Curve3>& curves, std::size_t i,
                                       bool front) const {
    const Curve3& c = curves[i];
    const Key at{point_key(front ? c.points.front() : c.points.back()), c.source};
    const auto first = std::lower_bound(ends_.begin(), ends_.end(), at,
                                        [](const End& e, const Key& k) { return e.key() < k; });
    const auto last = std::upper_bound(first, ends_.end(), at,
                                       [](const Key& k, const End& e) { return k < e.key(); });
    if (last - first != 2) return {kNone, false};
    const End& other = first[0].curve == i && first[0].front == front ? first[1] : first[0];
    if (other.curve == i) return {kNone, false};
    const Curve3& d = curves[other.curve];
    const Vec3& n = front ? c.normals.front() : c.normals.back();
    const Vec3& m = other.front ? d.normals.front() : d.normals.back();
    if (glm::dot(n, m) <= 0) return {kNone, false};
    return {other.curve, other.front};
  }

 private:
  using Key = std::pair<PointKey, SourceId>;
  struct End {
    PointKey at;
    SourceId source;
    std::size_t curve;
    bool front;
    Key key() const { return {at, source}; }
  };
  std::vector<End> ends_;
};

/// Adds `next`, which begins where `c` ends.
void add(Curve3& c, const Curve3& next) {
  c.points.insert(c.points.end(), next.points.begin() + 1, next.points.end());
  c.normals.insert(c.normals.end(), next.normals.begin() + 1, next.normals.end());
  c.faces.insert(c.faces.end(), next.faces.begin(), next.faces.end());
  c.self_hidden.insert(c.self_hidden.end(), next.self_hidden.begin(), next.self_hidden.end());
  if (c.crease_sign != next.crease_sign) c.crease_sign = 0;
}

}  // namespace

void join_contours(std::vector<Curve3>& curves) {
  const Ends ends(curves);
  std::vector<std::uint8_t> used(curves.size(), 0);
  std::vector<Curve3> out;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (used[i]) continue;
    if (!joinable(curves[i])) {
      out.push_back(curves[i]);
      continue;
    }
    // Back to where the chain begins, or once round it.
    std::size_t at = i;
    bool front = true;
    for (;;) {
      const auto [previous, its_front] = ends.partner(curves, at, front);
      if (previous == kNone || previous == i) break;
      at = previous;
      front = !its_front;
    }
    Curve3 joined = curves[at];
    if (!front) reverse(joined);
    used[at] = 1;
    for (;;) {
      const auto [next, its_front] = ends.partner(curves, at, !front);
      if (next == kNone) break;
      if (used[next]) {
        joined.closed = joined.points.size() > 3 && joined.points.front() == joined.points.back();
        break;
      }
      Curve3 piece = curves[next];
      if (!its_front) reverse(piece);
      add(joined, piece);
      used[next] = 1;
      at = next;
      front = its_front;
    }
    if (joined.closed) {
      joined.points.pop_back();
      joined.normals.pop_back();
    }
    out.push_back(std::move(joined));
  }
  curves = std::move(out);
}

void drop_specks(std::vector<Curve3>& curves, const Camera& camera) {
  const auto speck = [&](const Curve3& c) {
    if (c.kind != LineClass::Crease || c.closed) return false;
    double length = 0;
    for (std::size_t i = 0; i + 1 < c.points.size() && length < kSpeckLength; ++i) {
      length += glm::length(c.points[i + 1] - c.points[i]) * camera.scale_at(c.points[i]);
    }
    return length < kSpeckLength;
  };
  // A speck may hang on another one: what is left of a twig goes in a few rounds.
  for (int round = 0; round < 4; ++round) {
    std::map<PointKey, int> touched;
    for (const Curve3& c : curves) {
      if (!speck(c)) continue;
      touched[point_key(c.points.front())] = 0;
      touched[point_key(c.points.back())] = 0;
    }
    if (touched.empty()) return;
    for (const Curve3& c : curves) {
      for (const Vec3& p : c.points) {
        const auto found = touched.find(point_key(p));
        if (found != touched.end()) ++found->second;
      }
    }
    const auto dropped = std::erase_if(curves, [&](const Curve3& c) {
      return speck(c) &&
             (touched[point_key(c.points.front())] < 2 || touched[point_key(c.points.back())] < 2);
    });
    if (dropped == 0) return;
  }
}

}  // namespace burin
