#include <burin/drawing/paper_breaks.h>

namespace burin {

Vec2 PaperBreaks::shift(std::size_t piece) const {
  double by = 0;
  for (std::size_t i = 0; i < piece && i < bands.size(); ++i) {
    by += gap_of(bands[i]) - (bands[i].high - bands[i].low);
  }
  return offset + by * along;
}

Vec2 PaperBreaks::moved(Vec2 place) const {
  const double at = glm::dot(along, place);
  std::size_t piece = 0;
  while (piece < bands.size() && at >= bands[piece].high) ++piece;
  Vec2 to = place + shift(piece);
  if (piece < bands.size() && at > bands[piece].low) {
    const Band& band = bands[piece];
    to += (at - band.low) * (gap_of(band) / (band.high - band.low) - 1) * along;
  }
  return to;
}

bool PaperBreaks::leaves_out(Vec2 place, double around) const {
  constexpr double kRounding = 1e-6;  // paper mm
  const double at = glm::dot(along, place);
  return std::ranges::any_of(bands, [&](const Band& band) {
    return at + around > band.low + kRounding && at - around < band.high - kRounding;
  });
}

PaperBreaks PaperBreaks::of_moved_view(Vec2 by) const {
  PaperBreaks out = *this;
  out.offset -= by;
  for (Band& band : out.bands) {
    band.low += glm::dot(along, by);
    band.high += glm::dot(along, by);
  }
  return out;
}

}  // namespace burin
