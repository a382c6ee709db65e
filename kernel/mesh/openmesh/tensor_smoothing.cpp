#include "tensor_smoothing.h"

#include <burin/base/parallel.h>

#include "../build_steps.h"

#include <algorithm>

namespace burin {

namespace {

double turned(double value, Vec2) { return value; }

Tensor turned(const Tensor& t, Vec2 turn) {
  return {t.mean, t.dx * turn.x - t.dy * turn.y, t.dx * turn.y + t.dy * turn.x};
}

template <class Value>
std::vector<Value> smooth(std::vector<Value> values, const WedgeLinks& links, int passes,
                          const RunContext& context) {
  std::vector<Value> next(values.size());
  for (int pass = 0; pass < passes; ++pass) {
    parallel_for(
        values.size(), kFaceGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t w = begin; w < end; ++w) {
            Value sum = values[w];
            const std::uint32_t first = links.offsets[w], last = links.offsets[w + 1];
            for (std::uint32_t i = first; i < last; ++i) {
              sum += turned(values[links.links[i].to], links.links[i].turn);
            }
            next[w] = (1.0 / (1 + last - first)) * sum;
          }
        },
        &context);
    values.swap(next);
  }
  return values;
}

}  // namespace

WedgeLinks wedge_links(const RingMesh& rings, const Groups<RingHandle>& of_wedge,
                       const ProxyMesh& proxy, const RunContext& context) {
  const std::size_t wedges = of_wedge.size();
  const auto each_wedge = [&](const auto& visit) {
    parallel_for(
        wedges, kFaceGrain,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t w = begin; w < end; ++w) visit(w);
        },
        &context);
  };
  // Each half-edge leads to its end; the last one before a crease or boundary to the start of that
  // too.
  const auto last_before_edge = [&](RingHandle h) {
    const HalfEdge in = rings.corner(rings.prev_halfedge_handle(h));
    return proxy.edge_kind[static_cast<std::size_t>(in)] != EdgeKind::Smooth;
  };
  WedgeLinks result;
  result.offsets.assign(wedges + 1, 0);
  each_wedge([&](std::size_t w) {
    for (const RingHandle h : of_wedge[w]) result.offsets[w + 1] += last_before_edge(h) ? 2 : 1;
  });
  for (std::size_t w = 0; w < wedges; ++w) result.offsets[w + 1] += result.offsets[w];
  result.links = std::make_unique_for_overwrite<WedgeLink[]>(result.offsets[wedges]);
  each_wedge([&](std::size_t w) {
    WedgeLink* next = &result.links[result.offsets[w]];
    const TangentFrame here = tangent_frame(proxy.wedge_normal[w]);
    const auto add = [&](RingHandle to) {
      const std::uint32_t there = wedge_of(proxy, rings.corner(to));
      *next++ = {there, double_turn(tangent_frame(proxy.wedge_normal[there]), here)};
    };
    for (const RingHandle h : of_wedge[w]) {
      add(rings.next_halfedge_handle(h));
      if (last_before_edge(h)) add(rings.prev_halfedge_handle(h));
    }
  });
  return result;
}

std::vector<Tensor> smoothed(std::vector<Tensor> tensors, const WedgeLinks& links, int passes,
                             const RunContext& context) {
  return smooth(std::move(tensors), links, passes, context);
}

std::vector<double> smoothed(std::vector<double> values, const WedgeLinks& links, int passes,
                             const RunContext& context) {
  return smooth(std::move(values), links, passes, context);
}

}  // namespace burin
