#include "space.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin::csg {
namespace {

// Relative to the size of all: points whose doubles are worse than this are solved exactly.
constexpr double kReach = 1e-12;
// Planes whose numbers differ by less may be one.
constexpr double kPlaneReach = 1e-9;

// Lengths that are whole numbers of nanometres are added as such: most of what people write.
constexpr double kSteps = 1e6;
constexpr double kMostSteps = 1e14;

bool to_steps(double v, std::int64_t& steps) {
  const double n = std::nearbyint(v * kSteps);
  if (!(std::abs(n) < kMostSteps) || n / kSteps != v) return false;
  steps = static_cast<std::int64_t>(n);
  return true;
}

int sign_of(double v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

int largest_axis(Vec3 v) {
  const Vec3 a = glm::abs(v);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

/// A number that equal planes share, up to rounding, whichever way their normals point.
double order_of(Vec3 n, double d, double size) {
  const double s = n[largest_axis(n)] < 0 ? -1 : 1;
  return s * (0.3719 * n.x + 0.5527 * n.y + 0.7451 * n.z + d / size);
}

std::uint64_t pair_key(Id a, Id b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

}  // namespace

std::size_t Space::KeyHash::operator()(const Key& k) const {
  std::uint64_t h = 0x9e3779b97f4a7c15;
  for (const Id p : k.planes) h = (h ^ p) * 0xff51afd7ed558ccd, h ^= h >> 32;
  return h;
}

Space::Space(double size)
    : size_(std::max(size, 1e-6)), reach_(kReach * size_), cell_(1e-6 * size_) {}

Id Space::add_matrix(ExactMatrix m) {
  matrices_.push_back(std::move(m));
  return static_cast<Id>(matrices_.size() - 1);
}

std::uint64_t Space::cell(Vec3 at, std::array<int, 3> shift) const {
  std::uint64_t h = 0;
  for (int i = 0; i < 3; ++i) {
    const double v = std::floor((at[i] + shift[static_cast<std::size_t>(i)] * 4 * reach_) / cell_);
    h = (h ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(v))) * 0x9fb21c651e98df25;
    h ^= h >> 29;
  }
  return h;
}

template <typename Same>
Id Space::number(Point&& point, Same&& same) {
  std::array<std::uint64_t, 8> looked{};
  std::size_t count = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto way = [&](unsigned bit) { return (corner & bit) != 0 ? 1 : -1; };
    const std::uint64_t key = cell(point.at, {way(1), way(2), way(4)});
    const auto end = looked.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::find(looked.begin(), end, key) != end) continue;
    looked[count++] = key;
    const auto found = cells_.find(key);
    if (found == cells_.end()) continue;
    for (Id c = found->second; c != kNone; c = points_[c].next) {
      const double limit = 2 * (points_[c].error + point.error) + kUlp * size_;
      const Vec3 gap = glm::abs(points_[c].at - point.at);
      if (std::max({gap.x, gap.y, gap.z}) <= limit && same(c)) return c;
    }
  }
  const auto id = static_cast<Id>(points_.size());
  Id& last = cells_.try_emplace(cell(point.at, {0, 0, 0}), kNone).first->second;
  point.next = std::exchange(last, id);
  points_.push_back(std::move(point));
  return id;
}

bool Space::place_plainly(Point& point) const {
  const ExactMatrix& m = matrices_[point.matrix];
  Vec3 at;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = m.nearest.row[i];
    std::int64_t sum = 0;
    if (!m.plain[i] || !to_steps(row[3], sum)) return false;
    for (std::size_t j = 0; j < 3; ++j) {
      std::int64_t steps = 0;
      if (row[j] == 0) continue;
      if (std::abs(row[j]) != 1 || !to_steps(point.local[static_cast<int>(j)], steps)) return false;
      sum += row[j] > 0 ? steps : -steps;
    }
    at[static_cast<int>(i)] = static_cast<double>(sum) / kSteps;
  }
  point.at = at;
  point.local = at;
  point.matrix = kNone;
  return true;
}

void Space::place(Point& point) const {
  const ExactMatrix& m = matrices_[point.matrix];
  double bound = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = m.nearest.row[i];
    double sum = row[3], sizes = std::abs(row[3]);
    for (std::size_t j = 0; j < 3; ++j) {
      sum += row[j] * point.local[static_cast<int>(j)];
      sizes += std::abs(row[j] * point.local[static_cast<int>(j)]);
    }
    point.at[static_cast<int>(i)] = sum;
    bound = std::max(bound, sizes);
  }
  point.error = 6 * kUlp * bound;
}

Id Space::corner(Vec3 local, Id matrix) {
  Point point;
  point.local = local;
  point.matrix = matrix;
  if (matrices_[matrix].identity) {
    point.at = local;
    point.matrix = kNone;
  }
  if (point.matrix == kNone || place_plainly(point)) {
    const Vec3 a = glm::abs(point.at);
    point.error = kUlp * std::max({a.x, a.y, a.z});
  } else {
    place(point);
  }
  return number(std::move(point), [&](Id c) {
    const Point& other = points_[c];
    if (point.matrix == kNone && other.matrix == kNone && other.line == kNone) {
      return point.at == other.at;
    }
    ++exact_count;
    return equal_points(exact_point(c), solve(point));
  });
}

Exact Space::solve(const Point& point) {
  if (point.line == kNone) {
    if (point.matrix == kNone) return csg::exact_point(point.local);
    return transformed(matrices_[point.matrix], point.local);
  }
  const Line& line = lines_[point.line];
  if (line.a != kNone) {
    return csg::meet(exact_point(line.a), exact_point(line.b), exact_plane(point.plane));
  }
  return meet_planes(exact_plane(line.p), exact_plane(line.q), exact_plane(point.plane));
}

const Exact& Space::exact_point(Id point) {
  Point& p = points_[point];
  if (!p.exact) p.exact = std::make_unique<Exact>(solve(p));
  return *p.exact;
}

const Exact& Space::exact_plane(Id plane) {
  Plane& p = planes_[plane];
  if (!p.exact) {
    p.exact = std::make_unique<Exact>(csg::plane_through(
        exact_point(p.corners[0]), exact_point(p.corners[1]), exact_point(p.corners[2])));
  }
  return *p.exact;
}

void Space::fit(Plane& plane) {
  const Point &a = points_[plane.corners[0]], &b = points_[plane.corners[1]],
              &c = points_[plane.corners[2]];
  const Vec3 u = b.at - a.at, v = c.at - a.at;
  const Vec3 n = glm::cross(u, v);
  const double length = glm::length(n);
  const double places = a.error + b.error + c.error;
  const double lengths = glm::length(u) + glm::length(v);
  double error = (2 * places * lengths + 8 * kUlp * glm::length(u) * glm::length(v)) / length;
  plane.n = n / length;
  if (!(error < 1e-11)) {
    plane.exact = std::make_unique<Exact>(csg::plane_through(exact_point(plane.corners[0]),
                                                             exact_point(plane.corners[1]),
                                                             exact_point(plane.corners[2])));
    mpz_class most = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      if (abs(plane.exact->c[i]) > most) most = abs(plane.exact->c[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      plane.n[static_cast<int>(i)] = mpq_class(plane.exact->c[i], most).get_d();
    }
    plane.n = glm::normalize(plane.n);
    error = 8 * kUlp;
  }
  plane.d = -glm::dot(plane.n, a.at);
  plane.n_error = error + 4 * kUlp;
  const Vec3 size = glm::abs(a.at);
  plane.d_error =
      plane.n_error * (size.x + size.y + size.z) + 2 * a.error + 4 * kUlp * std::abs(plane.d);
  plane.axis = largest_axis(plane.n);
}

std::pair<Id, bool> Space::plane(Id a, Id b, Id c) {
  Plane plane;
  plane.corners = {a, b, c};
  fit(plane);
  const double order = order_of(plane.n, plane.d, size_);
  for (auto at = plane_order_.lower_bound(order - 4 * kPlaneReach);
       at != plane_order_.end() && at->first <= order + 4 * kPlaneReach; ++at) {
    const Plane& other = planes_[at->second];
    const bool same_way = glm::dot(other.n, plane.n) > 0;
    const Vec3 gap = glm::abs(other.n - (same_way ? plane.n : -plane.n));
    if (std::max({gap.x, gap.y, gap.z}) > kPlaneReach) continue;
    const Id id = at->second;
    if (side(a, id) == 0 && side(b, id) == 0 && side(c, id) == 0) return {id, same_way};
  }
  const auto id = static_cast<Id>(planes_.size());
  plane_order_.emplace(order, id);
  // A normal whose largest component is nearly as large as another may be either way round.
  plane_order_.emplace(-order, id);
  planes_.push_back(std::move(plane));
  for (const Id p : {a, b, c}) lies_in(p, id);
  return {id, true};
}

Id Space::plane_beside(Id a, Id b, Id plane) {
  // Off the plane: along the axis that its normal is nearest to.
  Point off;
  off.local = points_[a].at;
  off.local[planes_[plane].axis] += glm::length(points_[b].at - points_[a].at);
  off.at = off.local;
  off.error = 2 * kUlp * size_;
  const auto id = static_cast<Id>(points_.size());
  points_.push_back(std::move(off));
  return this->plane(a, b, id).first;
}

bool Space::knows(Id point, Id plane) const {
  const auto& list = points_[point].planes;
  return std::find(list.begin(), list.end(), plane) != list.end();
}

void Space::lies_in(Id point, Id plane) {
  if (!knows(point, plane)) points_[point].planes.push_back(plane);
}

std::pair<double, double> Space::distance(Id plane, Vec3 at) const {
  const Plane& p = planes_[plane];
  const Vec3 a = glm::abs(at);
  const double sum = a.x + a.y + a.z;
  return {glm::dot(p.n, at) + p.d, p.n_error * sum + p.d_error + 4 * kUlp * (sum + std::abs(p.d))};
}

int Space::side(Id point, Id plane) {
  const auto [s, bound] = distance(plane, points_[point].at);
  if (std::abs(s) > bound + 2 * points_[point].error) return sign_of(s);
  if (knows(point, plane)) return 0;
  ++exact_count;
  const Exact& e = exact_plane(plane);
  int sign = csg::side(exact_point(point), e);
  if (sign == 0) points_[point].planes.push_back(plane);
  return sign;
}

Id Space::add_line(Line line) {
  Vec3 way;
  if (line.a != kNone) {
    way = points_[line.b].at - points_[line.a].at;
  } else {
    way = glm::cross(planes_[line.p].n, planes_[line.q].n);
    // Nearly parallel planes: the direction from whole numbers.
    if (glm::length(way) < 1e-6) {
      const Exact &p = exact_plane(line.p), &q = exact_plane(line.q);
      std::array<mpz_class, 3> w;
      mpz_class most = 1;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        w[i] = p.c[j] * q.c[k] - p.c[k] * q.c[j];
        if (abs(w[i]) > most) most = abs(w[i]);
      }
      for (std::size_t i = 0; i < 3; ++i) way[static_cast<int>(i)] = mpq_class(w[i], most).get_d();
    }
  }
  line.axis = largest_axis(way);
  lines_.push_back(line);
  return static_cast<Id>(lines_.size() - 1);
}

Id Space::line(Id a, Id b, Id p, Id q) {
  const auto [at, fresh] = line_of_planes_.try_emplace(pair_key(p, q), kNone);
  if (fresh) {
    Line line{p, q, a, b};
    at->second = add_line(line);
  }
  return at->second;
}

Id Space::find_line(Id p, Id q) const {
  const auto found = line_of_planes_.find(pair_key(p, q));
  return found == line_of_planes_.end() ? kNone : found->second;
}

Id Space::line(Id p, Id q) {
  const auto [at, fresh] = line_of_planes_.try_emplace(pair_key(p, q), kNone);
  if (fresh) at->second = add_line({p, q});
  return at->second;
}

void Space::locate(Point& point) {
  const Line& line = lines_[point.line];
  if (line.a != kNone) {
    const Point &u = points_[line.a], &v = points_[line.b];
    const auto [su, eu] = distance(point.plane, u.at);
    const auto [sv, ev] = distance(point.plane, v.at);
    const double whole = su - sv, t = su / whole;
    const Vec3 way = v.at - u.at, a = glm::abs(u.at);
    point.at = u.at + t * way;
    const double t_error = 2 * (eu + ev + 2 * (u.error + v.error)) / std::abs(whole);
    point.error = glm::length(way) * (t_error + 4 * kUlp * (1 + std::abs(t))) +
                  (1 + std::abs(t)) * (u.error + v.error) + 4 * kUlp * std::max({a.x, a.y, a.z});
    return;
  }
  const Plane &p = planes_[line.p], &q = planes_[line.q], &r = planes_[point.plane];
  const Vec3 qr = glm::cross(q.n, r.n), rp = glm::cross(r.n, p.n), pq = glm::cross(p.n, q.n);
  const double det = glm::dot(p.n, qr);
  point.at = -(p.d * qr + q.d * rp + r.d * pq) / det;
  const double n_error = p.n_error + q.n_error + r.n_error + 8 * kUlp;
  const double d_error = p.d_error + q.d_error + r.d_error;
  const double d = std::abs(p.d) + std::abs(q.d) + std::abs(r.d);
  // Every number of the solution carries the errors of its planes over the determinant.
  point.error = 4 * (d_error + n_error * (d + glm::length(point.at))) / std::abs(det);
}

Id Space::meet(Id line_id, Id plane, Vec3 near, double error) {
  const Line line = lines_[line_id];
  Key key{{line.p, line.q, plane}};
  std::sort(key.planes.begin(), key.planes.end());
  if (const auto found = point_of_planes_.find(key); found != point_of_planes_.end()) {
    return found->second;
  }
  Point point;
  point.line = line_id;
  point.plane = plane;
  point.planes = {line.p, line.q, plane};
  if (error >= 0 && error <= reach_) {
    point.at = near;
    point.error = error;
  } else {
    locate(point);
  }
  if (!(point.error <= reach_)) {
    ++exact_count;
    point.exact = std::make_unique<Exact>(solve(point));
    point.at = csg::nearest(*point.exact);
    const Vec3 a = glm::abs(point.at);
    point.error = 2 * kUlp * std::max({a.x, a.y, a.z});
  }
  const Id id = number(std::move(point), [&](Id c) {
    return side(c, line.p) == 0 && side(c, line.q) == 0 && side(c, plane) == 0;
  });
  point_of_planes_.emplace(key, id);
  return id;
}

int Space::along(Id line, Id a, Id b) { return compare(lines_[line].axis, a, b); }

int Space::compare(int axis, Id a, Id b) {
  if (a == b) return 0;
  const double gap = points_[a].at[axis] - points_[b].at[axis];
  if (std::abs(gap) > 2 * (points_[a].error + points_[b].error)) return sign_of(gap);
  ++exact_count;
  return csg::compare(exact_point(a), exact_point(b), static_cast<std::size_t>(axis));
}

std::pair<double, double> Space::area(Id plane, Id a, Id b, Id c) const {
  const int axis = planes_[plane].axis, i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Point &pa = points_[a], &pb = points_[b], &pc = points_[c];
  const double ux = pb.at[i] - pa.at[i], uy = pb.at[j] - pa.at[j];
  const double vx = pc.at[i] - pa.at[i], vy = pc.at[j] - pa.at[j];
  const double places = pa.error + pb.error + pc.error;
  const double lengths = std::abs(ux) + std::abs(uy) + std::abs(vx) + std::abs(vy);
  const double bound = 2 * lengths * places + 8 * kUlp * (std::abs(ux * vy) + std::abs(uy * vx));
  return {ux * vy - uy * vx, bound + 8 * places * places};
}

int Space::turn(Id plane, Id a, Id b, Id c) {
  const auto [s, bound] = area(plane, a, b, c);
  if (std::abs(s) > bound) return sign_of(s);
  if (a == b || b == c || a == c) return 0;
  ++exact_count;
  const auto axis = static_cast<std::size_t>(planes_[plane].axis);
  return csg::turn(exact_point(a), exact_point(b), exact_point(c), (axis + 1) % 3, (axis + 2) % 3);
}

int Space::in_circle(Id plane, const std::array<Id, 3>& triangle, Id point) {
  const int axis = planes_[plane].axis, i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Point& t = points_[point];
  std::array<double, 3> x{}, y{}, lift{};
  double size = 0, places = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& p = points_[triangle[k]];
    x[k] = p.at[i] - t.at[i];
    y[k] = p.at[j] - t.at[j];
    lift[k] = x[k] * x[k] + y[k] * y[k];
    size = std::max({size, std::abs(x[k]), std::abs(y[k])});
    places = std::max(places, p.error + t.error);
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    sum += lift[k] * (x[l] * y[m] - x[m] * y[l]);
  }
  // Three products of a square (2 size^2) and an area (2 size^2), each off by what its four
  // differences are off: 48 size^3 times that, and the rounding of some ten steps each.
  const double off = places + kUlp * size;
  if (std::abs(sum) > 64 * size * size * size * off + 128 * kUlp * size * size * size * size) {
    return sign_of(sum);
  }
  ++exact_count;
  return csg::in_circle(
      {&exact_point(triangle[0]), &exact_point(triangle[1]), &exact_point(triangle[2])},
      exact_point(point), static_cast<std::size_t>(i), static_cast<std::size_t>(j));
}

}  // namespace burin::csg
