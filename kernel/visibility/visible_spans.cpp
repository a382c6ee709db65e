#include <burin/base/parallel.h>
#include <burin/visibility/visible_spans.h>

#include "outer.h"
#include "pieces.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <numeric>

namespace burin {
namespace {

// Multiples of the occluder's resolution within which two depths are one: curves that meet in
// space.
constexpr double kSameDepth = 4;
// Paper mm: what the features are settled with before they cut other curves.
constexpr double kFeatureMinimum = 0.05;
constexpr std::size_t kCurveGrain = 8;
// Cuts of all features at the most; each is a piece that wants rays. A drawing that can be looked
// at has some ten thousand. As many as are worth a count are expected first.
constexpr double kMostCuts = 5e5, kManyCuts = 5e5;
// Pairs of segments that are looked at for cuts at the most, a second or two; models that are whole
// take 5 million and fewer. Beyond, lines are cut evenly, into fewer pieces: what lies so deep over
// each other wants more time a ray, too.
constexpr std::size_t kMostTests = 100'000'000;
constexpr double kMostEvenCuts = 1e5;

// The pieces as spans from the start of the curve to its end.
std::vector<Span> to_spans(const std::vector<TrackPiece>& pieces, double n) {
  std::vector<Span> spans;
  for (const TrackPiece& p : pieces) {
    if (p.end > n && p.begin < n) {
      spans.push_back({p.begin, n, p.visible, p.outer});
      spans.push_back({0, p.end - n, p.visible, p.outer});
    } else {
      const double shift = p.begin >= n ? n : 0;
      spans.push_back({p.begin - shift, p.end - shift, p.visible, p.outer});
    }
  }
  std::erase_if(spans, [&](const Span& s) { return s.end <= s.begin && spans.size() > 1; });
  std::sort(spans.begin(), spans.end(),
            [](const Span& a, const Span& b) { return a.begin < b.begin; });
  return spans;
}

bool cuts(const Curve3& curve) { return curve.occluding || curve.kind == LineClass::Intersection; }

void add_span(const Track& track, const Span& span, std::vector<PictureSegment>& out) {
  const std::size_t n = track.segment_count();
  const auto first = std::min(static_cast<std::size_t>(span.begin), n - 1);
  for (std::size_t i = first; i < n && static_cast<double>(i) < span.end; ++i) {
    const auto at = static_cast<double>(i);
    out.push_back(part_of(track.segment(i, -1), std::max(0.0, span.begin - at),
                          std::min(1.0, span.end - at)));
  }
}

}  // namespace

struct VisibilityMap::Impl {
  Impl(const Occluder& o, std::span<const ProxyMesh* const> proxies, const Camera& camera,
       std::span<const Curve3> f, const RunContext& context)
      : probe(o, proxies, camera), features(f), same_depth(kSameDepth * o.resolution()) {
    tracks.reserve(features.size());
    for (const Curve3& curve : features) tracks.emplace_back(curve, camera);
    std::vector<PictureSegment> all;
    for (std::size_t c = 0; c < features.size(); ++c) {
      if (!cuts(features[c])) continue;
      for (std::size_t i = 0; i < tracks[c].segment_count(); ++i) {
        if (features[c].self_hidden.empty() || !features[c].self_hidden[i]) {
          all.push_back(tracks[c].segment(i, static_cast<std::int32_t>(c)));
        }
      }
    }
    every = std::make_unique<Cutters>(std::move(all), same_depth);
    probe.know_lines(*every);
    same_cut = spacing_of_cuts(context);
    feature_pieces.resize(features.size());
    const auto classify = [&](const Cutting& cutting, std::size_t c, Scratch& scratch) {
      feature_pieces[c] =
          cutting.classify(features[c], tracks[c], static_cast<std::int32_t>(c), scratch);
    };
    if (same_cut == 0 || !in_bounds(context, classify)) {
      same_cut = length() / kMostEvenCuts;
      every->cut_evenly(same_cut);
      in_bounds(context, classify);
    }
    std::vector<PictureSegment> seen;
    for (std::size_t c = 0; c < features.size(); ++c) {
      if (!cuts(features[c])) continue;
      const auto n = static_cast<double>(tracks[c].segment_count());
      for (const Span& s : to_spans(settle(feature_pieces[c], tracks[c], kFeatureMinimum), n)) {
        if (s.visible) add_span(tracks[c], s, seen);
      }
    }
    visible = std::make_unique<Cutters>(std::move(seen), same_depth);
  }

  // Paper mm of all features.
  double length() const {
    return std::accumulate(tracks.begin(), tracks.end(), 0.0,
                           [](double sum, const Track& track) { return sum + track.length(); });
  }

  // Does something with each feature; false where that took more than kMostTests, which leaves it
  // undone for some.
  template <class Each>
  bool in_bounds(const RunContext& context, const Each& each) const {
    std::atomic<std::size_t> tests{0};
    parallel_for(
        features.size(), kCurveGrain,
        [&](std::size_t begin, std::size_t end) {
          Scratch scratch;
          const Cutting cutting(probe, *every, CutRule::NearerOrAt, same_cut);
          for (std::size_t c = begin; c < end && tests <= kMostTests; ++c) {
            scratch.crossings.tests = 0;
            each(cutting, c, scratch);
            tests += scratch.crossings.tests;
          }
        },
        &context);
    return tests <= kMostTests;
  }

  // Paper mm below which cuts are one, so that no more are left than kMostCuts; 0 where they cannot
  // be counted.
  double spacing_of_cuts(const RunContext& context) const {
    if (!(every->expected_cuts(length()) > kManyCuts)) return kSameCut;
    std::vector<std::size_t> count(tracks.size(), 0);
    const bool counted =
        in_bounds(context, [&](const Cutting& cutting, std::size_t c, Scratch& scratch) {
          count[c] = cutting.count_cuts(tracks[c], static_cast<std::int32_t>(c), scratch);
        });
    if (!counted) return 0;
    const auto all =
        static_cast<double>(std::accumulate(count.begin(), count.end(), std::size_t{0}));
    return all > kMostCuts ? length() / kMostCuts : kSameCut;
  }

  std::vector<Span> finish(std::vector<TrackPiece> pieces, const Curve3& curve, const Track& track,
                           std::int32_t number, const VisibilityOptions& options,
                           Scratch& scratch) const {
    pieces = settle(std::move(pieces), track, options.minimum_length);
    if (options.classify_outer && curve.occluding) {
      pieces = find_outer(probe, *every, *visible, curve, track, number, pieces,
                          options.minimum_length, same_cut, scratch);
    }
    return to_spans(pieces, static_cast<double>(track.segment_count()));
  }

  Probe probe;
  std::span<const Curve3> features;
  double same_depth;
  double same_cut = kSameCut;
  std::vector<Track> tracks;  // of the features
  std::vector<std::vector<TrackPiece>> feature_pieces;
  std::unique_ptr<Cutters> every;  // all occluding features
  // Those that can be seen. What is seen along any other curve can change only at these: the
  // foremost sheet of the picture changes nowhere else.
  std::unique_ptr<Cutters> visible;
};

VisibilityMap::VisibilityMap(const Occluder& occluder, std::span<const ProxyMesh* const> proxies,
                             const Camera& camera, std::span<const Curve3> features,
                             const RunContext& context)
    : impl_(std::make_unique<Impl>(occluder, proxies, camera, features, context)) {}

VisibilityMap::~VisibilityMap() = default;

double VisibilityMap::merged_cuts() const {
  return impl_->same_cut > kSameCut ? impl_->same_cut : 0;
}

std::vector<std::vector<Span>> VisibilityMap::classify(std::span<const Curve3> curves,
                                                       const VisibilityOptions& options,
                                                       const RunContext& context) const {
  std::vector<std::vector<Span>> out(curves.size());
  const bool known =
      curves.data() == impl_->features.data() && curves.size() == impl_->features.size();
  parallel_for(
      curves.size(), kCurveGrain,
      [&](std::size_t begin, std::size_t end) {
        Scratch scratch;
        const Cutting cutting(impl_->probe, *impl_->visible, CutRule::AnyDepth, impl_->same_cut);
        for (std::size_t c = begin; c < end; ++c) {
          if (known) {
            out[c] = impl_->finish(impl_->feature_pieces[c], curves[c], impl_->tracks[c],
                                   static_cast<std::int32_t>(c), options, scratch);
          } else {
            const Track track(curves[c], impl_->probe.camera());
            out[c] = impl_->finish(cutting.classify(curves[c], track, -1, scratch), curves[c],
                                   track, -1, options, scratch);
          }
        }
      },
      &context);
  return out;
}

}  // namespace burin
