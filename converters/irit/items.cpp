#include "items.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin::irit {
namespace {

/// Kinds of a fixed number of numbers.
struct NumberKind {
  std::string_view keyword;
  int count;
};
constexpr NumberKind kNumberKinds[] = {
    {"NUMBER", 1}, {"POINT", 3}, {"VECTOR", 3}, {"PLANE", 4}, {"MATRIX", 16}};

constexpr std::string_view kUnreadTypes[] = {"TRISRF",  "MULTIVAR",   "TRIMMODEL", "VMODEL",
                                             "TRIMCRV", "TRIMCRVSEG", "CTLPT"};
constexpr std::string_view kOther[] = {"SURFACE",   "CURVE",    "POLYGON", "POLYLINE",
                                       "POINTLIST", "STRING",   "OBJECT",  "TRIVAR",
                                       "POLYSTRIP", "INSTANCE", "TRIMSRF", "MODEL"};

IritNumbers read_numbers(Lexer& in, const NumberKind& kind) {
  IritNumbers numbers{std::string(kind.keyword), {}};
  for (int i = 0; i < kind.count; ++i) numbers.values.push_back(in.number("a number"));
  in.close("the ] after the numbers");
  return numbers;
}

IritInstance read_instance(Lexer& in, const Token& keyword) {
  IritInstance instance;
  instance.place = in.place_of(keyword.where);
  const Token name = in.next();
  if (name.kind != Token::Kind::Word && name.kind != Token::Kind::Quoted) {
    in.expected(name, "the name of an object");
  }
  instance.of = plain(name.text);
  for (double& x : instance.matrix) x = in.number("a number of the matrix");
  in.close("the ] after the matrix");
  return instance;
}

IritPolygon read_polygon(Lexer& in, IritPolygon::Kind kind) {
  constexpr std::size_t kPointBytes = 7;  // "[0 0 0]"
  IritPolygon polygon{kind, {}, read_attributes(in)};
  const Token at = in.peek();
  const auto count = static_cast<std::size_t>(in.count("the number of points"));
  if (count > in.left() / kPointBytes) {
    in.fail(at, fmt::format("{} points cannot fit into the {} bytes that follow; the file is "
                            "truncated or damaged",
                            count, in.left()));
  }
  polygon.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    in.source().context().check();
    in.open("the [ of a point");
    read_attributes(in);
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = in.number("a coordinate");
    in.close("the ] of a point");
    polygon.points.push_back(p);
  }
  in.close("the ] after the points");
  return polygon;
}

}  // namespace

bool is_item(std::string_view keyword) {
  const auto same = [&](std::string_view k) { return k == keyword; };
  return std::ranges::any_of(kUnreadTypes, same) || std::ranges::any_of(kOther, same) ||
         std::ranges::any_of(kNumberKinds, [&](const NumberKind& k) { return same(k.keyword); });
}

IritAttributes read_attributes(Lexer& in, bool until_item) {
  IritAttributes attributes;
  while (in.peek().kind == Token::Kind::Open) {
    Lexer ahead = in;
    ahead.next();
    const Token name = ahead.next();
    if (name.kind != Token::Kind::Word || (until_item && is_item(raised(name.text)))) break;
    in = ahead;
    IritAttribute attribute{plain(name.text), {}};
    for (Token token = in.next(); token.kind != Token::Kind::Close; token = in.next()) {
      if (token.kind == Token::Kind::End) in.expected(token, "the ] of an attribute");
      if (token.kind == Token::Kind::Open) {
        in.skip_block();
        continue;
      }
      if (!attribute.value.empty()) attribute.value += ' ';
      attribute.value += plain(token.text);
    }
    attributes.push_back(std::move(attribute));
  }
  return attributes;
}

IritItem read_item(Lexer& in, const Token& keyword) {
  const std::string word = raised(keyword.text);
  if (word == "SURFACE") return read_surface(in, keyword);
  if (word == "CURVE") return read_curve(in, keyword);
  if (word == "TRIMSRF" || word == "MODEL") return read_trimmed(in, keyword);
  if (word == "TRIVAR") return read_trivariate(in, keyword);
  if (word == "INSTANCE") return read_instance(in, keyword);
  if (word == "POLYGON") return read_polygon(in, IritPolygon::Kind::Polygon);
  if (word == "POLYLINE") return read_polygon(in, IritPolygon::Kind::Polyline);
  if (word == "POLYSTRIP") return read_polygon(in, IritPolygon::Kind::Strip);
  if (word == "POINTLIST") return read_polygon(in, IritPolygon::Kind::PointList);
  if (word == "STRING") {
    std::string text = plain(in.next().text);
    in.close("the ] after a text");
    return text;
  }
  for (const NumberKind& kind : kNumberKinds) {
    if (word == kind.keyword) return read_numbers(in, kind);
  }
  const std::int64_t line = in.line_of(keyword.where);
  in.skip_block();
  return IritUnread{clean_name(word), line};
}

}  // namespace burin::irit
