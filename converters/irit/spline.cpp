// SURFACE, CURVE and TRIVAR of IRIT data.
#include "items.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::irit {
namespace {

/// One direction of a spline: control points in the file, order, knots.
struct Axis {
  std::int64_t points = 0;
  std::int64_t order = 0;
  std::vector<double> knots;
  bool periodic = false;

  int degree() const { return static_cast<int>(order - 1); }
  /// With the first points once more at the end of a periodic direction.
  std::int64_t all_points() const { return points + (periodic ? order - 1 : 0); }
};

/// E1..E9 and P1..P9; later versions of IRIT go on to 18.
struct PointType {
  bool rational = false;
  int coordinates = 3;
};

enum class Basis : std::uint8_t { Bezier, BSpline, Other };

Basis basis_of(const Token& token) {
  const std::string word = raised(token.text);
  if (word == "BEZIER") return Basis::Bezier;
  return word == "BSPLINE" ? Basis::BSpline : Basis::Other;
}

/// Orders beyond this are no designs; the work of one evaluation is their product.
constexpr std::int64_t kMaxOrder = 32;

class SplineReader {
 public:
  SplineReader(Lexer& in, const Token& keyword, int axes)
      : in_(in), keyword_(keyword), axes_(static_cast<std::size_t>(axes)) {}

  /// False where the spline is of a kind that is not read; its block is skipped then.
  bool read();
  std::string unread() const { return unread_; }
  const Axis& axis(std::size_t i) const { return axes_[i]; }
  IritAttributes attributes;
  /// Trivariates: in the order of the file.
  std::vector<double> scalars;
  /// Others: in the order of NurbsData, wrapped.
  std::vector<Vec3> points;
  std::vector<double> weights;

 private:
  bool skip(std::string what);
  void counts(bool bspline);
  void point_type();
  void knots(Axis& axis);
  void bezier_knots(Axis& axis);
  void fits(const Token& at) const;
  /// Why it is none of the trivariates that are functions of space; empty: it is.
  std::string no_function() const;
  void scalar_points();
  void control_points();
  void control_point(std::size_t index);

  Lexer& in_;
  Token keyword_;
  std::vector<Axis> axes_;
  PointType type_;
  std::string unread_;
};

bool SplineReader::skip(std::string what) {
  unread_ = raised(keyword_.text) + " " + std::move(what);
  in_.skip_block();
  return false;
}

bool SplineReader::read() {
  const Token kind = in_.next();
  if (kind.kind != Token::Kind::Word) in_.expected(kind, "BEZIER or BSPLINE");
  const Basis basis = basis_of(kind);
  if (basis == Basis::Other) return skip(clean_name(raised(kind.text)));
  attributes = read_attributes(in_);
  const Token at = in_.peek();
  counts(basis == Basis::BSpline);
  point_type();
  const bool trivariate = axes_.size() == 3;
  if (!trivariate && type_.coordinates < 2) return skip("of points with one coordinate");
  fits(at);
  for (Axis& axis : axes_) basis == Basis::BSpline ? knots(axis) : bezier_knots(axis);
  if (trivariate && !no_function().empty()) return skip(no_function());
  trivariate ? scalar_points() : control_points();
  in_.close("the ] after the control points");
  return true;
}

void SplineReader::counts(bool bspline) {
  const Token at = in_.peek();
  for (Axis& axis : axes_) axis.points = axis.order = in_.count("a number of control points");
  if (bspline) {
    for (Axis& axis : axes_) axis.order = in_.count("an order");
  }
  for (const Axis& axis : axes_) {
    if (axis.order < 2 || axis.order > kMaxOrder || axis.order > axis.points) {
      in_.fail(at, fmt::format("order {} of {} control points: orders go from 2 to the number of "
                               "points, at most {}; export it again",
                               axis.order, axis.points, kMaxOrder));
    }
  }
}

void SplineReader::point_type() {
  const Token token = in_.next();
  const std::string word = raised(token.text);
  const std::string digits = word.substr(std::min<std::size_t>(1, word.size()));
  const bool good = token.kind == Token::Kind::Word && !digits.empty() && digits.size() <= 2 &&
                    (word[0] == 'E' || word[0] == 'P') && std::ranges::all_of(digits, is_digit);
  const int coordinates = good ? std::stoi(digits) : 0;
  if (coordinates < 1 || coordinates > 18) in_.expected(token, "a type of points, E1 to P18");
  type_ = {word[0] == 'P', coordinates};
}

/// Before anything is allocated: each point takes its brackets and its numbers.
void SplineReader::fits(const Token& at) const {
  double all = 1;
  for (const Axis& axis : axes_) all *= static_cast<double>(axis.points);
  const double bytes = all * (2 * (type_.coordinates + (type_.rational ? 1 : 0)) + 1);
  if (bytes > static_cast<double>(in_.left())) {
    in_.fail(at, fmt::format("{:.0f} control points cannot fit into the {} bytes that follow; the "
                             "file is truncated or damaged",
                             all, in_.left()));
  }
}

void SplineReader::bezier_knots(Axis& axis) {
  axis.knots.assign(static_cast<std::size_t>(axis.order), 0);
  axis.knots.resize(2 * axis.knots.size(), 1);
}

void SplineReader::knots(Axis& axis) {
  const Token begin = in_.peek();
  in_.open("the [ of a knot vector");
  const Token word = in_.next();
  const std::string keyword = raised(word.text);
  if (keyword != "KV" && keyword != "KVP") in_.expected(word, "KV or KVP");
  axis.periodic = keyword == "KVP";
  while (in_.peek().kind != Token::Kind::Close) {
    const Token at = in_.peek();
    const double knot = in_.number("a knot");
    if (!axis.knots.empty() && knot < axis.knots.back()) {
      in_.fail(at, fmt::format("the knot {} is less than the one before it, {}; knots ascend, "
                               "export it again",
                               knot, axis.knots.back()));
    }
    axis.knots.push_back(knot);
  }
  in_.close("the ] of a knot vector");
  const std::int64_t due = axis.all_points() + axis.order;
  if (static_cast<std::int64_t>(axis.knots.size()) != due) {
    in_.fail(begin, fmt::format("the knot vector holds {} knots, {} points of order {}{} need {}; "
                                "export it again",
                                axis.knots.size(), axis.points, axis.order,
                                axis.periodic ? " in a period" : "", due));
  }
  if (!(axis.knots[static_cast<std::size_t>(axis.degree())] <
        axis.knots[static_cast<std::size_t>(axis.all_points())])) {
    in_.fail(begin, "the knots leave no interval to draw; export it again");
  }
}

std::string SplineReader::no_function() const {
  constexpr std::int64_t kMaxFunctionOrder = 10;
  if (type_.rational || type_.coordinates != 1) {
    return fmt::format("of points {}{}", type_.rational ? "P" : "E", type_.coordinates);
  }
  for (const Axis& axis : axes_) {
    if (axis.periodic) return "with periodic knots";
    if (axis.order > kMaxFunctionOrder) return fmt::format("of order {}", axis.order);
  }
  return {};
}

void SplineReader::scalar_points() {
  std::size_t all = 1;
  for (const Axis& axis : axes_) all *= static_cast<std::size_t>(axis.points);
  scalars.resize(all);
  for (double& value : scalars) {
    in_.source().context().check();
    in_.open("the [ of a control point");
    read_attributes(in_);
    const Token at = in_.peek();
    value = in_.number("a coordinate");
    if (std::abs(value) > kLargestCoordinate) {
      in_.fail(at, "this value is absurdly large; export it again");
    }
    in_.close("the ] of a control point");
  }
}

void SplineReader::control_point(std::size_t index) {
  in_.open("the [ of a control point");
  read_attributes(in_);
  const Token at = in_.peek();
  const double weight = type_.rational ? in_.number("a weight") : 1.0;
  Vec3 p(0);
  for (int k = 0; k < type_.coordinates; ++k) {
    const double x = in_.number("a coordinate");
    if (k < 3) p[k] = x;
  }
  in_.close("the ] of a control point");
  if (weight <= 0) {
    in_.fail(at, fmt::format("the weight {} is not positive; export it again", weight));
  }
  points[index] = p / weight;
  const Vec3& q = points[index];
  if (!(std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}) <= kLargestCoordinate)) {
    in_.fail(at, "the coordinates of this point are absurdly large; export it again");
  }
  if (type_.rational) weights[index] = weight;
}

void SplineReader::control_points() {
  const Axis curve{1, 1, {}, false};
  const Axis& u = axes_[0];
  const Axis& v = axes_.size() > 1 ? axes_[1] : curve;
  const auto rows = static_cast<std::size_t>(u.all_points());
  const auto columns = static_cast<std::size_t>(v.all_points());
  points.resize(rows * columns);
  if (type_.rational) weights.resize(points.size());
  const auto nu = static_cast<std::size_t>(u.points), nv = static_cast<std::size_t>(v.points);
  // The file has u fastest, NurbsData v.
  for (std::size_t j = 0; j < nv; ++j) {
    in_.source().context().check();
    for (std::size_t i = 0; i < nu; ++i) control_point(i * columns + j);
  }
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t from = (i % nu) * columns + j % nv;
      points[i * columns + j] = points[from];
      if (type_.rational) weights[i * columns + j] = weights[from];
    }
  }
}

}  // namespace

IritItem read_surface(Lexer& in, const Token& keyword) {
  const std::int64_t line = in.line_of(keyword.where);
  SplineReader reader(in, keyword, 2);
  if (!reader.read()) return IritUnread{reader.unread(), line};
  const Axis &u = reader.axis(0), &v = reader.axis(1);
  NurbsData data;
  data.degree_u = u.degree();
  data.degree_v = v.degree();
  data.knots_u = u.knots;
  data.knots_v = v.knots;
  data.count_u = static_cast<int>(u.all_points());
  data.count_v = static_cast<int>(v.all_points());
  data.points = std::move(reader.points);
  data.weights = std::move(reader.weights);
  data.periodic_u = u.periodic;
  data.periodic_v = v.periodic;
  return IritSurface{std::move(data), std::move(reader.attributes), line};
}

IritItem read_curve(Lexer& in, const Token& keyword) {
  const std::int64_t line = in.line_of(keyword.where);
  SplineReader reader(in, keyword, 1);
  if (!reader.read()) return IritUnread{reader.unread(), line};
  const Axis& t = reader.axis(0);
  return IritCurve{t.degree(),
                   t.knots,
                   std::move(reader.points),
                   std::move(reader.weights),
                   t.periodic,
                   std::move(reader.attributes)};
}

IritItem read_trivariate(Lexer& in, const Token& keyword) {
  const std::int64_t line = in.line_of(keyword.where);
  SplineReader reader(in, keyword, 3);
  if (!reader.read()) return IritUnread{reader.unread(), line};
  IritTrivariate out;
  out.line = line;
  for (std::size_t k = 0; k < 3; ++k) {
    const Axis& axis = reader.axis(k);
    out.spline.order[k] = static_cast<std::int32_t>(axis.order);
    out.spline.size[k] = static_cast<std::int32_t>(axis.points);
    out.spline.knots[k] = axis.knots;
  }
  out.spline.coefficients = std::move(reader.scalars);
  out.attributes = std::move(reader.attributes);
  return out;
}

}  // namespace burin::irit
