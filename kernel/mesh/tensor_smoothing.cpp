#include "tensor_smoothing.h"

#include <burin/base/parallel.h>

#include "build_steps.h"

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

WedgeLinks wedge_links(const ProxyMesh& proxy, const Corners& corners, const RunContext& context) {
  const std::size_t wedges = proxy.wedge_vertex.size(), vertices = proxy.mesh.positions.size();
  WedgeLinks result;
  result.offsets.assign(wedges + 1, 0);
  // Each corner leads to the next vertex of its triangle; the last one before a crease or boundary
  // to both.
  const auto last_before_edge = [&](HalfEdge h) {
    return proxy.edge_kind[static_cast<std::size_t>(prev_in_face(h))] != EdgeKind::Smooth;
  };
  parallel_for(
      vertices, kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge h : corners[v]) {
            result.offsets[wedge_of(proxy, h) + 1] += last_before_edge(h) ? 2 : 1;
          }
        }
      },
      &context);
  for (std::size_t w = 0; w < wedges; ++w) result.offsets[w + 1] += result.offsets[w];
  result.links = std::make_unique_for_overwrite<WedgeLink[]>(result.offsets[wedges]);
  parallel_for(
      vertices, kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t>
            filled;  // of the wedges of one vertex, which have consecutive indices
        for (std::size_t v = begin; v < end; ++v) {
          filled.clear();
          std::uint32_t base = 0xffffffffu;
          for (const HalfEdge h : corners[v]) base = std::min(base, wedge_of(proxy, h));
          const auto add = [&](std::uint32_t w, std::uint32_t to) {
            if (filled.size() <= w - base) filled.resize(w - base + 1, 0);
            const TangentFrame here = tangent_frame(proxy.wedge_normal[w]);
            const TangentFrame there = tangent_frame(proxy.wedge_normal[to]);
            result.links[result.offsets[w] + filled[w - base]++] = {to, double_turn(there, here)};
          };
          for (const HalfEdge h : corners[v]) {
            const std::uint32_t w = wedge_of(proxy, h);
            add(w, wedge_of(proxy, next_in_face(h)));
            if (last_before_edge(h)) add(w, wedge_of(proxy, prev_in_face(h)));
          }
        }
      },
      &context);
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
