// TRIMSRF and MODEL of IRIT data.
#include <burin/base/error.h>

#include "items.h"
#include "text.h"
#include "words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

namespace burin::irit {
namespace {

/// Loops of models name their curves by numbers: a kilobyte could ask for gigabytes.
constexpr std::size_t kMostLoopPoints = 5'000'000;

TrimCurve trim_curve(IritCurve curve) {
  TrimCurve out{curve.degree, std::move(curve.knots), {}, std::move(curve.weights)};
  out.points.assign(curve.points.begin(), curve.points.end());
  return out;
}

TrimCurve turned(TrimCurve curve) {
  std::ranges::reverse(curve.knots);
  for (double& k : curve.knots) k = -k;
  std::ranges::reverse(curve.points);
  std::ranges::reverse(curve.weights);
  return curve;
}

/// A border of a model, on the surfaces (from 1; 0: none) that it lies between.
struct ModelSegment {
  std::int64_t surface[2] = {0, 0};
  std::optional<TrimCurve> curve[2];
};

/// A loop of a model, by the numbers of its segments, negative where they are turned.
struct ModelLoop {
  std::size_t face = 0;
  TextPlace place;
  std::vector<std::int64_t> segments;
};

class TrimmedReader {
 public:
  explicit TrimmedReader(Lexer& in) : in_(in) {}

  /// False where a spline in it is of a kind that is not read.
  bool read_trimmed(const Token& keyword);
  bool read_model();
  IritTrimmed trimmed;
  std::string unread;

 private:
  Token block(std::string_view keyword, const char* what);
  TextPlace place(const Token& token) { return in_.place_of(token.where); }
  std::int64_t whole_number(const char* what);
  bool surface(const Token& keyword);
  bool loop();
  bool segment(TrimLoop& loop);
  std::optional<IritCurve> curve(const char* what);
  bool is_unread(const IritItem& item);

  bool model_surface();
  void model_loop();
  bool model_segment();
  void resolve(const ModelLoop& loop);
  const TrimCurve& curve_of(const ModelLoop& loop, std::int64_t number) const;

  Lexer& in_;
  std::vector<ModelLoop> loops_;
  std::vector<ModelSegment> segments_;
  std::size_t points_ = 0;
};

/// The keyword of a block that must stand here.
Token TrimmedReader::block(std::string_view keyword, const char* what) {
  in_.open(what);
  const Token word = in_.next();
  if (word.kind != Token::Kind::Word || raised(word.text) != keyword) in_.expected(word, what);
  return word;
}

std::int64_t TrimmedReader::whole_number(const char* what) {
  const Token token = in_.next();
  const auto number = token.kind == Token::Kind::Word ? whole(token.text) : std::nullopt;
  if (!number) in_.expected(token, what);
  return *number;
}

bool TrimmedReader::is_unread(const IritItem& item) {
  const auto* other = std::get_if<IritUnread>(&item);
  if (other != nullptr) unread = other->what;
  return other != nullptr;
}

bool TrimmedReader::surface(const Token& keyword) {
  IritItem item = read_surface(in_, block("SURFACE", "the [SURFACE of a trimmed surface"));
  if (is_unread(item)) return false;
  trimmed.faces.push_back({std::move(std::get<IritSurface>(item).data), {}, place(keyword)});
  return true;
}

std::optional<IritCurve> TrimmedReader::curve(const char* what) {
  IritItem item = read_curve(in_, block("CURVE", what));
  if (is_unread(item)) return std::nullopt;
  return std::move(std::get<IritCurve>(item));
}

/// The curve in the parameters of the surface; the one in space, which may follow it, says the same
/// less exactly.
bool TrimmedReader::segment(TrimLoop& loop) {
  block("TRIMCRVSEG", "the [TRIMCRVSEG of a trimming loop");
  read_attributes(in_, true);
  std::optional<IritCurve> found = curve("the [CURVE of a trimming curve");
  if (!found) return false;
  loop.curves.push_back(trim_curve(std::move(*found)));
  if (in_.peek().kind == Token::Kind::Open) curve("the [CURVE in space of a trimming curve");
  in_.close("the ] of a trimming curve");
  return true;
}

bool TrimmedReader::loop() {
  TrimLoop& loop = trimmed.faces.back().loops.emplace_back();
  loop.place = place(block("TRIMCRV", "the [TRIMCRV of a trimmed surface"));
  read_attributes(in_, true);
  do {
    in_.source().context().check();
    if (!segment(loop)) return false;
  } while (in_.peek().kind == Token::Kind::Open);
  in_.close("the ] of a trimming loop");
  return true;
}

bool TrimmedReader::read_trimmed(const Token& keyword) {
  trimmed.attributes = read_attributes(in_, true);
  if (!surface(keyword)) return false;
  while (in_.peek().kind == Token::Kind::Open) {
    if (!loop()) return false;
  }
  in_.close("the ] of a trimmed surface");
  return true;
}

void TrimmedReader::model_loop() {
  ModelLoop& loop = loops_.emplace_back();
  loop.face = trimmed.faces.size() - 1;
  loop.place = place(block("MDLLOOP", "the [MDLLOOP of a surface of a model"));
  do {
    loop.segments.push_back(whole_number("the number of a segment"));
  } while (in_.peek().kind != Token::Kind::Close);
  in_.close("the ] of a loop");
}

bool TrimmedReader::model_surface() {
  const Token keyword = block("MDLTSRF", "the [MDLTSRF of a model");
  const std::int64_t loops = whole_number("a number of loops");
  if (!surface(keyword)) return false;
  for (std::int64_t i = 0; i < loops; ++i) {
    in_.source().context().check();
    model_loop();
  }
  in_.close("the ] of a surface of a model");
  return true;
}

bool TrimmedReader::model_segment() {
  constexpr int kInSpace = 4;
  block("MDLTSEG", "the [MDLTSEG of a model");
  const Token at = in_.peek();
  const std::int64_t mask = whole_number("which curves a segment has");
  if (mask < 1 || mask > 7) in_.fail(at, "which curves a segment has is a number from 1 to 7");
  ModelSegment& segment = segments_.emplace_back();
  for (std::int64_t& s : segment.surface) s = whole_number("the number of a surface");
  for (int side = 0; side < 2; ++side) {
    if ((mask & (1 << side)) == 0) continue;
    std::optional<IritCurve> found = curve("the [CURVE of a segment");
    if (!found) return false;
    segment.curve[side] = trim_curve(std::move(*found));
  }
  if ((mask & kInSpace) != 0) curve("the [CURVE in space of a segment");
  in_.close("the ] of a segment");
  return true;
}

/// Of a segment between two sides of one surface the turned use has the second curve.
const TrimCurve& TrimmedReader::curve_of(const ModelLoop& loop, std::int64_t number) const {
  if (number == 0 || static_cast<std::uint64_t>(std::abs(number)) > segments_.size()) {
    fail_at(in_.source().file(), loop.place,
            fmt::format("this loop names segment {}, the model has 1 to {}; export it again",
                        number, segments_.size()));
  }
  const ModelSegment& segment = segments_[static_cast<std::size_t>(std::abs(number) - 1)];
  const auto face = static_cast<std::int64_t>(loop.face + 1);
  const auto has = [&](int side) { return segment.surface[side] == face && segment.curve[side]; };
  const int first = number > 0 ? 0 : 1;
  for (const int side : {first, 1 - first}) {
    if (has(side)) return *segment.curve[side];
  }
  fail_at(
      in_.source().file(), loop.place,
      fmt::format("this loop names segment {}, which has no curve on surface {}; export it again",
                  number, face));
}

void TrimmedReader::resolve(const ModelLoop& loop) {
  TrimLoop& out = trimmed.faces[loop.face].loops.emplace_back();
  out.place = loop.place;
  for (const std::int64_t number : loop.segments) {
    in_.source().context().check();
    const TrimCurve& curve = curve_of(loop, number);
    points_ += curve.points.size();
    if (points_ > kMostLoopPoints) {
      fail_at(in_.source().file(), loop.place,
              fmt::format("the loops up to this one have more than {} points; split the model",
                          kMostLoopPoints));
    }
    out.curves.push_back(number > 0 ? curve : turned(curve));
  }
}

bool TrimmedReader::read_model() {
  trimmed.attributes = read_attributes(in_, true);
  trimmed.model = true;
  const std::int64_t surfaces = in_.count("a number of surfaces");
  const Token at = in_.peek();
  const std::int64_t segments = whole_number("a number of segments");
  if (segments < 0) in_.fail(at, "the number of segments is negative; export it again");
  for (std::int64_t i = 0; i < surfaces; ++i) {
    if (!model_surface()) return false;
  }
  for (std::int64_t i = 0; i < segments; ++i) {
    in_.source().context().check();
    if (!model_segment()) return false;
  }
  in_.close("the ] of a model");
  for (const ModelLoop& loop : loops_) resolve(loop);
  return true;
}

}  // namespace

IritItem read_trimmed(Lexer& in, const Token& keyword) {
  const Lexer begin = in;
  const std::int64_t line = in.line_of(keyword.where);
  TrimmedReader reader(in);
  const std::string word = raised(keyword.text);
  if (word == "MODEL" ? reader.read_model() : reader.read_trimmed(keyword)) {
    return std::move(reader.trimmed);
  }
  in = begin;
  in.skip_block();
  return IritUnread{word + " of " + reader.unread, line};
}

}  // namespace burin::irit
