#include "knot_spans.h"

namespace burin {

KnotSpans::KnotSpans(std::vector<double> knots, int degree, int count, bool periodic)
    : degree_(degree), knots_(std::move(knots)) {
  const auto p = static_cast<std::size_t>(degree), n = static_cast<std::size_t>(count);
  max_ = knots_[n];
  // 1e-12 of the domain: what remains of a parameter after a few operations in double precision.
  const double same = 1e-12 * (max_ - knots_[p]);
  for (std::size_t i = p + 1; i <= n; ++i) {
    if (knots_[i] - knots_[i - 1] <= same) knots_[i] = knots_[i - 1];
  }
  // Knots that run into the end of the domain are the end.
  for (std::size_t i = n; i > p && max_ - knots_[i] <= same; --i) knots_[i] = max_;
  for (std::size_t i = p; i < n; ++i) {
    if (knots_[i + 1] <= knots_[i]) continue;
    starts_.push_back(knots_[i]);
    last_knot_.push_back(static_cast<int>(i));
  }
  if (periodic) period_ = max_ - min();
  const std::size_t cells = size() == 1 ? 1 : 2 * size();
  cells_per_unit_ = static_cast<double>(cells) / (max_ - min());
  cell_low_.assign(cell(max_) + 1, 0);
  cell_high_.assign(cell_low_.size(), 0);
  std::size_t span = 0;
  for (std::size_t c = 0; c < cell_low_.size(); ++c) {
    cell_low_[c] = static_cast<std::uint32_t>(span);
    while (span + 1 < size() && cell(starts_[span + 1]) <= c) ++span;
    cell_high_[c] = static_cast<std::uint32_t>(span);
  }
}

std::vector<double> KnotSpans::extraction(std::size_t span) const {
  // The polar form of the span at (start, ..., start, end, ..., end), by de Boor's scheme for each
  // control point's share: every factor lies in [0, 1].
  const auto p = static_cast<std::size_t>(degree_), order = p + 1;
  const auto k = static_cast<std::size_t>(last_knot_[span]);
  const double start = starts_[span], end = start + width(span);
  std::vector<double> result(order * order);
  std::vector<double> d(order * order);
  for (std::size_t j = 0; j < order; ++j) {
    d.assign(order * order, 0);
    for (std::size_t i = 0; i < order; ++i) d[i * order + i] = 1;
    for (std::size_t r = 1; r <= p; ++r) {
      const double x = r <= j ? end : start;
      for (std::size_t i = p; i >= r; --i) {
        const double left = knots_[k - p + i], right = knots_[k + 1 + i - r];
        const double f = (x - left) / (right - left);
        for (std::size_t c = 0; c < order; ++c) {
          d[i * order + c] = (1 - f) * d[(i - 1) * order + c] + f * d[i * order + c];
        }
      }
    }
    for (std::size_t c = 0; c < order; ++c) result[j * order + c] = d[p * order + c];
  }
  return result;
}

std::vector<double> KnotSpans::breaks(int order) const {
  std::vector<double> result;
  for (std::size_t s = 1; s < size(); ++s) {
    const int multiplicity = last_knot_[s] - last_knot_[s - 1];
    if (degree_ - multiplicity < order) result.push_back(starts_[s]);
  }
  return result;
}

}  // namespace burin
