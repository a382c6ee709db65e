// TRIMSRF of IRIT data.
#include "items.h"
#include "text.h"

#include <utility>

namespace burin::irit {
namespace {

class TrimmedReader {
 public:
  explicit TrimmedReader(Lexer& in) : in_(in) {}

  /// False where a spline in it is of a kind that is not read.
  bool read(const Token& keyword);
  IritTrimmed trimmed;
  std::string unread;

 private:
  Token block(std::string_view keyword, const char* what);
  TextPlace place(const Token& token) {
    return {in_.line_of(token.where), in_.column_of(token.where)};
  }
  bool surface();
  bool loop();
  bool segment(TrimLoop& loop);
  bool is_unread(const IritItem& item);

  Lexer& in_;
};

/// The keyword of a block that must stand here.
Token TrimmedReader::block(std::string_view keyword, const char* what) {
  in_.open(what);
  const Token word = in_.next();
  if (word.kind != Token::Kind::Word || raised(word.text) != keyword) in_.expected(word, what);
  return word;
}

bool TrimmedReader::is_unread(const IritItem& item) {
  const auto* other = std::get_if<IritUnread>(&item);
  if (other != nullptr) unread = other->what;
  return other != nullptr;
}

bool TrimmedReader::surface() {
  const Token keyword = block("SURFACE", "the [SURFACE of a trimmed surface");
  IritItem item = read_surface(in_, keyword);
  if (is_unread(item)) return false;
  trimmed.data.surface = std::move(std::get<IritSurface>(item).data);
  return true;
}

/// The curve in the parameters of the surface; the one in space, which may follow it, says the same
/// less exactly.
bool TrimmedReader::segment(TrimLoop& loop) {
  block("TRIMCRVSEG", "the [TRIMCRVSEG of a trimming loop");
  read_attributes(in_, true);
  IritItem item = read_curve(in_, block("CURVE", "the [CURVE of a trimming curve"));
  if (is_unread(item)) return false;
  auto& curve = std::get<IritCurve>(item);
  TrimCurve& out = loop.curves.emplace_back();
  out.degree = curve.degree;
  out.knots = std::move(curve.knots);
  out.weights = std::move(curve.weights);
  out.points.assign(curve.points.begin(), curve.points.end());
  if (in_.peek().kind == Token::Kind::Open) {
    if (is_unread(read_curve(in_, block("CURVE", "the [CURVE in space of a trimming curve")))) {
      unread.clear();
    }
  }
  in_.close("the ] of a trimming curve");
  return true;
}

bool TrimmedReader::loop() {
  TrimLoop& loop = trimmed.data.loops.emplace_back();
  loop.place = place(block("TRIMCRV", "the [TRIMCRV of a trimmed surface"));
  read_attributes(in_, true);
  do {
    in_.source().context().check();
    if (!segment(loop)) return false;
  } while (in_.peek().kind == Token::Kind::Open);
  in_.close("the ] of a trimming loop");
  return true;
}

bool TrimmedReader::read(const Token& keyword) {
  trimmed.data.place = place(keyword);
  trimmed.attributes = read_attributes(in_, true);
  if (!surface()) return false;
  while (in_.peek().kind == Token::Kind::Open) {
    if (!loop()) return false;
  }
  in_.close("the ] of a trimmed surface");
  return true;
}

}  // namespace

IritItem read_trimmed(Lexer& in, const Token& keyword) {
  const Lexer begin = in;
  TrimmedReader reader(in);
  if (reader.read(keyword)) return std::move(reader.trimmed);
  in = begin;
  in.skip_block();
  return IritUnread{"TRIMSRF of " + reader.unread, reader.trimmed.data.place.line};
}

}  // namespace burin::irit
