// Models of the figures of Elber's paper, of our own making.
#include "splines.h"

#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace burin::samples {
namespace {

constexpr double kPi = std::numbers::pi;

NurbsData moved(NurbsData s, Vec3 by) {
  for (Vec3& p : s.points) p += by;
  return s;
}

/// A body of rings along x: (x, half width in y, half height in z, middle in z).
struct Station {
  double x, wide, high, z = 0;
};
NurbsData hull(const std::vector<Station>& stations) {
  std::vector<Ring> rings;
  for (const Station& s : stations)
    rings.push_back({{s.x, 0, s.z}, {0, s.wide, 0}, {0, 0, s.high}});
  return sweep(rings);
}

/// A wing from root to tip: each section an ellipse of a chord, about a point on its axis.
struct Section {
  Vec3 middle;
  double chord, thick;
};
NurbsData wing(const std::vector<Section>& sections, Vec3 up) {
  std::vector<Ring> rings;
  for (const Section& s : sections)
    rings.push_back({s.middle, {0.5 * s.chord, 0, 0}, 0.5 * s.thick * up});
  return sweep(rings);
}

NurbsData ball(double radius, Vec3 at) {
  // Control rows of a cubic that keeps within 1 % of the ball.
  const double r = radius;
  return moved(turn({{0, -r},
                     {0.3 * r, -r},
                     {0.86 * r, -0.72 * r},
                     {1.11 * r, 0},
                     {0.86 * r, 0.72 * r},
                     {0.3 * r, r},
                     {0, r}}),
               at);
}

/// A flat patch from one corner along two sides.
NurbsData patch(Vec3 corner, Vec3 a, Vec3 b) {
  NurbsData s = bezier_patch(1, 1, {corner, corner + b, corner + a, corner + a + b});
  s.weights.assign(s.points.size(), 1);
  return s;
}

// Foot, and what all pieces stand on; (radius, height) up to the neck.
std::vector<Vec2> foot(double wide, double neck) {
  return {{0, 0},
          {wide, 0},
          {1.02 * wide, 1.2},
          {wide, 3},
          {0.78 * wide, 4},
          {0.8 * wide, 5.4},
          {0.62 * wide, 6.6},
          {0.4 * wide, 10},
          {0.36 * wide, 0.55 * neck + 5},
          {0.34 * wide, neck}};
}

NurbsData turned(std::vector<Vec2> profile, const std::vector<Vec2>& head) {
  profile.insert(profile.end(), head.begin(), head.end());
  return turn(profile);
}

std::vector<NurbsData> pawn() {
  return {turned(foot(7, 15), {{4.4, 15.5},
                               {4.4, 16.6},
                               {2.2, 17},
                               {3.4, 18},
                               {5, 20.5},
                               {4.4, 24},
                               {1.6, 25.6},
                               {0, 25.6}})};
}

std::vector<NurbsData> rook() {
  std::vector<NurbsData> out{turned(foot(8, 20), {{5.6, 21},
                                                  {5.8, 22},
                                                  {4.6, 22.6},
                                                  {4.8, 23},
                                                  {6.2, 23.6},
                                                  {6.3, 26},
                                                  {6.2, 29},
                                                  {4.9, 29.2},
                                                  {4.6, 27},
                                                  {2, 26.6},
                                                  {0, 26.6}})};
  return out;
}

std::vector<NurbsData> bishop() {
  return {turned(foot(8, 24), {{5.4, 24.6},
                               {5.4, 26},
                               {2.6, 26.6},
                               {3.4, 28},
                               {5.4, 31},
                               {4.6, 35.5},
                               {1.6, 38.6},
                               {0.8, 39.4}}),
          ball(1.5, {0, 0, 40})};
}

std::vector<NurbsData> queen() {
  std::vector<NurbsData> out{turned(foot(9, 30), {{6, 30.8},
                                                  {6.2, 32.2},
                                                  {3.4, 33},
                                                  {3.2, 34},
                                                  {4, 37},
                                                  {5.4, 41},
                                                  {6.6, 43.6},
                                                  {5.6, 44},
                                                  {4.6, 43},
                                                  {3.4, 44.6},
                                                  {1.4, 46},
                                                  {0, 46}}),
                             ball(1.7, {0, 0, 47.2})};
  for (int i = 0; i < 8; ++i) {
    const double a = 2 * kPi * i / 8;
    out.push_back(ball(1.1, {6 * std::cos(a), 6 * std::sin(a), 44}));
  }
  return out;
}

std::vector<NurbsData> king() {
  std::vector<NurbsData> out{turned(foot(9.4, 33), {{6.2, 34},
                                                    {6.4, 35.4},
                                                    {3.6, 36.2},
                                                    {3.4, 37.4},
                                                    {4.2, 41},
                                                    {5.6, 46.4},
                                                    {4.8, 47.6},
                                                    {3, 48.6},
                                                    {1.2, 49.4},
                                                    {0, 49.4}})};
  const auto bar = [](Vec3 from, Vec3 to, Vec3 a, Vec3 b) {
    return sweep({{from, {}, {}},
                  {from, 0.9 * a, 0.9 * b},
                  {glm::mix(from, to, 0.15), 0.8 * a, 0.8 * b},
                  {0.5 * (from + to), 0.55 * a, 0.55 * b},
                  {glm::mix(from, to, 0.85), 0.8 * a, 0.8 * b},
                  {to, 0.9 * a, 0.9 * b},
                  {to, {}, {}}});
  };
  const Vec3 x(1.4, 0, 0), y(0, 1.1, 0), z(0, 0, 1.4);
  out.push_back(bar({0, 0, 48.8}, {0, 0, 56}, x, y));
  out.push_back(bar({-3.2, 0, 53}, {3.2, 0, 53}, y, z));
  return out;
}

std::vector<NurbsData> knight() {
  std::vector<NurbsData> out{turned(foot(8, 9), {{5.8, 9.6}, {5.8, 11}, {3, 11.6}, {0, 11.6}})};
  // Neck, brow and muzzle along a bent line; half axes across it in the plane y = 0 and along y.
  const auto ring = [](double x, double z, double turn, double along, double across) {
    const double a = turn * kPi / 180;
    return Ring{{x, 0, z}, along * Vec3(std::cos(a), 0, std::sin(a)), {0, across, 0}};
  };
  out.push_back(sweep({ring(0, 11, 0, 0, 0), ring(0, 11, 0, 5.2, 3.8), ring(-0.6, 15, 5, 5.4, 3.8),
                       ring(-1.4, 20, 12, 4.9, 3.4), ring(-1.2, 25, 0, 4.2, 3.1),
                       ring(0.6, 29, -35, 4, 3), ring(3.4, 30.6, -75, 4, 2.9),
                       ring(6.2, 29, -110, 3, 2.5), ring(8.6, 26.6, -118, 2.3, 2.2),
                       ring(10, 24.8, -122, 1.9, 1.9), ring(10.2, 24.4, -122, 0, 0)}));
  for (const double side : {-1.0, 1.0}) {
    out.push_back(sweep({ring(-0.6, 30, -20, 0, 0), ring(-0.6, 30.6, -20, 1.2, 0.8),
                         ring(-0.8, 32.6, -10, 0.9, 0.6), ring(-0.9, 34.4, 0, 0, 0)}));
    for (Vec3& p : out.back().points) p.y += side * 1.6;
  }
  return out;
}

// Of a file of pieces one kind, on a square of the board: (0, 0) is a1.
constexpr double kSquare = 22;
std::string placed(const char* piece, const std::string& name, int column, int row, double turn) {
  return fmt::format(
      "    {{\"file\": \"chess/{}.itd\", \"name\": \"{}\", \"place\": {{\"rotate\": [0, 0, {:g}], "
      "\"translate\": [{:g}, {:g}, 0]}}}}",
      piece, name, turn, kSquare * (column - 3.5), kSquare * (row - 3.5));
}

}  // namespace

std::vector<SplineObject> two_discs() {
  const double r = 20, a = r * std::numbers::sqrt2 / 2, b = r * std::numbers::sqrt2;
  NurbsData square = bezier_patch(2, 2,
                                  {{-a, -a, 0},
                                   {-b, 0, 0},
                                   {-a, a, 0},
                                   {0, -b, 0},
                                   {0, 0, 0},
                                   {0, b, 0},
                                   {a, -a, 0},
                                   {b, 0, 0},
                                   {a, a, 0}});
  const double w = std::numbers::sqrt2 / 2;
  square.weights = {1, w, 1, w, 1, w, 1, w, 1};
  // About a point off the middle: parameters tell nothing of the disc.
  std::vector<Ring> rings;
  for (const double share : {0.0, 0.1, 0.35, 0.7, 1.0}) {
    rings.push_back({Vec3(9 * (1 - share), 0, 0), {share * r, 0, 0}, {0, share * r, 0}});
  }
  return {{"square", "", {moved(square, {-22, 0, 0})}},
          {"polar", "", {moved(sweep(rings), {22, 0, 0})}}};
}

std::vector<SplineObject> aeroplane() {
  std::vector<SplineObject> out;
  out.push_back({"nose",
                 "",
                 {hull({{-60, 0, 0, -1},
                        {-60, 2, 2, -1},
                        {-55, 6, 6, -0.5},
                        {-44, 8.6, 9, 0.6},
                        {-36, 9.2, 11.4, 1.6},
                        {-26, 9.2, 11, 1.4},
                        {-16, 9, 9.2, 0.4},
                        {-6, 9, 9, 0},
                        {0, 9, 9, 0}})}});
  out.push_back({"tail_cone",
                 "",
                 {hull({{0, 9, 9, 0},
                        {6, 9, 9, 0},
                        {20, 8.8, 8.8, 0.2},
                        {36, 7, 7, 1.6},
                        {52, 4, 4.2, 3.6},
                        {64, 1.8, 2, 5},
                        {68, 0.6, 0.6, 5.6},
                        {68, 0, 0, 5.6}})}});
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? "right_" : "left_";
    const auto at = [side](double x, double y, double z) { return Vec3(x, side * y, z); };
    out.push_back({name + "wing",
                   "",
                   {wing({{at(-4, 6, -3), 34, 4.6},
                          {at(-2, 14, -2.6), 30, 4},
                          {at(4, 34, -1), 20, 2.8},
                          {at(10, 58, 1), 13, 1.8},
                          {at(13, 70, 2.2), 9.6, 1.3}},
                         {0, 0, 1})}});
    out.push_back({name + "tip",
                   "",
                   {wing({{at(13, 70, 2.2), 9.6, 1.3},
                          {at(13.5, 72, 2.4), 9, 1.2},
                          {at(14.6, 74, 2.8), 6, 0.8},
                          {at(15.6, 75, 3.2), 2, 0.3},
                          {at(15.8, 75, 3.3), 0, 0}},
                         {0, 0, 1})}});
    out.push_back({name + "tailplane",
                   "",
                   {wing({{at(54, 2, 4.6), 15, 2},
                          {at(56, 8, 4.8), 12, 1.6},
                          {at(59, 18, 5.2), 8.4, 1.1},
                          {at(61, 25, 5.5), 5.4, 0.7},
                          {at(61.6, 26, 5.6), 0, 0}},
                         {0, 0, 1})}});
    std::vector<Station> engine;
    for (const auto& [x, r] : {std::pair{-18.0, 0.0},
                               {-18.0, 2.4},
                               {-15.0, 3.6},
                               {-8.0, 3.9},
                               {0.0, 3.4},
                               {6.0, 2.2},
                               {9.0, 1.2},
                               {9.0, 0.0}}) {
      engine.push_back({x, r, r, -5.6});
    }
    out.push_back({name + "engine", "", {moved(hull(engine), {0, side * 25, 0})}});
  }
  // The fin stands upright: its sections are thick along y.
  out.push_back({"fin",
                 "",
                 {wing({{{50, 0, 5}, 18, 2},
                        {{53, 0, 10}, 15, 1.8},
                        {{58, 0, 19}, 10, 1.2},
                        {{61, 0, 25}, 7, 0.8},
                        {{62, 0, 26}, 0, 0}},
                       {0, 1, 0})}});
  return out;
}

std::vector<SplineObject> star() {
  // Rows of control points over heights, around at Greville's angles; even about angle 0, so that
  // the seam is smooth.
  constexpr int kAround = 49, kDegree = 3;
  std::vector<double> knots(kDegree + 1, 0);
  for (int i = 1; i < kAround - kDegree; ++i) knots.push_back(i);
  knots.insert(knots.end(), kDegree + 1, kAround - kDegree);
  NurbsData s;
  s.degree_u = s.degree_v = kDegree;
  s.count_v = kAround;
  s.knots_v = knots;
  const std::vector<Vec2> profile{{0, -9}, {5, -9},   {13, -7.5}, {20, -3},
                                  {20, 3}, {13, 7.5}, {5, 9},     {0, 9}};
  s.count_u = static_cast<int>(profile.size());
  s.knots_u.assign(kDegree + 1, 0);
  for (int i = 1; i < s.count_u - kDegree; ++i) s.knots_u.push_back(i);
  s.knots_u.insert(s.knots_u.end(), kDegree + 1, s.count_u - kDegree);
  for (const Vec2& p : profile) {
    std::vector<Vec3> row;
    for (int j = 0; j < kAround; ++j) {
      double greville = 0;
      for (int k = 1; k <= kDegree; ++k)
        greville += knots[static_cast<std::size_t>(j + k)] / kDegree;
      const double a = 2 * kPi * greville / (kAround - kDegree);
      const double r = p.x * (1 + 0.42 * p.x / 20 * std::cos(6 * a));
      row.emplace_back(r * std::cos(a), r * std::sin(a), p.y);
    }
    row.front().x = row.back().x = row[1].x;
    s.points.insert(s.points.end(), row.begin(), row.end());
  }
  s.weights.assign(s.points.size(), 1);
  return {{"star", "", {s}}};
}

std::vector<SplineObject> tableware() {
  return {
      {"top",
       "",
       {turn({{0, 0},
              {40, 0},
              {86, 0},
              {90, 0.4},
              {90.4, 1.5},
              {90, 2.6},
              {86, 3},
              {40, 3},
              {0, 3}})}},
      {"column",
       "",
       {turn({{0, -70},
              {30, -70},
              {32, -68},
              {26, -66},
              {8, -62},
              {5, -50},
              {4.4, -30},
              {5, -12},
              {12, -4},
              {18, -0.2},
              {0, -0.2}})}},
      {"glass",
       "",
       {turn({{0, 3.1},
              {9, 3.1},
              {9.6, 3.6},
              {7, 4.3},
              {1.6, 5},
              {1.1, 9},
              {1.1, 15},
              {1.4, 18},
              {5, 20},
              {8.6, 24},
              {9.4, 30},
              {8.2, 38},
              {7.4, 38.2},
              {8.4, 30},
              {7.4, 24.6},
              {4, 21},
              {0, 20.4}})}},
      {"plate",
       "",
       {turn({{0, 3.1},
              {10, 3.1},
              {12, 3.6},
              {18, 5.6},
              {19.4, 6.4},
              {18.6, 6.9},
              {12, 4.8},
              {8, 4.2},
              {0, 4.2}})}},
      {"bottle",
       "",
       {turn({{0, 3.1},
              {9, 3.1},
              {10, 4},
              {10, 12},
              {10, 26},
              {9.6, 33},
              {4.4, 39},
              {3.2, 44},
              {3.1, 52},
              {3.8, 53},
              {3.8, 55},
              {2.6, 55.4},
              {0, 55.4}})}},
  };
}

std::vector<std::pair<std::string, std::vector<SplineObject>>> chess_pieces() {
  std::vector<std::pair<std::string, std::vector<SplineObject>>> out;
  const auto add = [&](const char* name, std::vector<NurbsData> surfaces) {
    out.push_back({name, {{name, "", std::move(surfaces)}}});
  };
  add("pawn", pawn());
  add("rook", rook());
  add("knight", knight());
  add("bishop", bishop());
  add("queen", queen());
  add("king", king());
  std::vector<SplineObject> board;
  SplineObject white{"white_squares", "", {}}, black{"black_squares", "", {}},
      frame{"frame", "", {}};
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      // Inlaid, with a joint around each: squares that met would be one part.
      constexpr double kJoint = 0.1, kSide = kSquare - 2 * kJoint;
      const Vec3 corner(kSquare * (column - 4) + kJoint, kSquare * (row - 4) + kJoint, 0);
      SplineObject& color = (row + column) % 2 == 0 ? black : white;
      color.surfaces.push_back(patch(corner, {kSide, 0, 0}, {0, kSide, 0}));
    }
  }
  // Four sides, mitred: a flat top and a rounded edge each.
  const double in = 4 * kSquare, wide = 14, round = 5;
  for (int side = 0; side < 4; ++side) {
    const auto at = [&](double along, double out_by, double z) {
      const double a = side * kPi / 2, x = in + out_by, y = along * (in + out_by);
      return Vec3(std::round(std::cos(a)) * x - std::round(std::sin(a)) * y,
                  std::round(std::sin(a)) * x + std::round(std::cos(a)) * y, z);
    };
    NurbsData top =
        bezier_patch(1, 1, {at(-1, 0, 0), at(1, 0, 0), at(-1, wide, 0), at(1, wide, 0)});
    NurbsData edge =
        bezier_patch(2, 1,
                     {at(-1, wide, 0), at(1, wide, 0), at(-1, wide + round, 0),
                      at(1, wide + round, 0), at(-1, wide + round, -8), at(1, wide + round, -8)});
    for (NurbsData* s : {&top, &edge}) {
      s->weights.assign(s->points.size(), 1);
      frame.surfaces.push_back(std::move(*s));
    }
  }
  out.push_back({"board", {white, black, frame}});
  return out;
}

void write_chess(const std::filesystem::path& path) {
  std::vector<std::string> parts{"    {\"file\": \"chess/board.itd\"}"};
  const char* const order[] = {"rook", "knight", "bishop", "queen",
                               "king", "bishop", "knight", "rook"};
  for (const bool white : {true, false}) {
    for (int column = 0; column < 8; ++column) {
      const std::string color = white ? "white " : "black ";
      const char* piece = order[column];
      parts.push_back(placed(piece, color + piece, column, white ? 0 : 7, white ? 90 : -90));
      parts.push_back(placed("pawn", color + "pawn", column, white ? 1 : 6, 0));
    }
  }
  auto out = fmt::output_file(path.string());
  out.print(R"({{
  "burin": "illustration",
  "version": 1,
  "title": "A chess set",
  "parts": [
{}
  ],
  "view": {{"from": [-0.55, -1, 0.75], "perspective": 24}},
  "paper": "A4",
  "style": {{"base": "pencil", "feature.creases": false, "feature.boundaries": true}},
  "looks": [
    {{"select": "white_squares", "style": {{"base": "engraving", "hatch": {{"field": "fixed", "direction": [1, 1, 0], "cross_from": 2, "width_min": 0.05, "width_max": 0.08, "spacing_min": 1.4, "spacing_max": 1.6, "tone_min": 0.01}}, "tone": {{"law": "constant", "ambient": 0.94, "highlight": 1}}}}}},
    {{"select": "black_squares", "style": {{"base": "engraving", "hatch": {{"field": "fixed", "direction": [1, 1, 0], "cross_from": 2, "spacing_min": 0.45, "spacing_max": 0.5}}, "tone": {{"law": "constant", "ambient": 0.45, "highlight": 1}}}}}},
    {{"select": "frame", "style": {{"base": "engraving", "hatch": {{"field": "isoparametric", "cross_from": 2}}, "tone": {{"light": [0, 1, 0.4], "ambient": 0.1, "diffuse": 0.75, "highlight": 1}}}}}},
    {{"select": "black *", "style": {{"base": "engraving", "hatch": {{"placing": "points", "field": "fixed", "direction": [0.3, 0.2, 1], "length": 4, "width_min": 0.08, "width_max": 0.3, "cross_from": 2}}, "tone": {{"ambient": 0.1, "diffuse": 0.5}}}}}},
    {{"select": "white *", "style": {{"base": "pencil", "hatch": {{"placing": "points", "field": "silhouette", "length": 3, "cross_from": 2, "width_min": 0.08, "width_max": 0.16}}, "tone": {{"law": "silhouette", "decay": 2.5}}}}}}
  ]
}}
)",
            fmt::join(parts, ",\n"));
}

}  // namespace burin::samples
