#include "alike.h"

namespace burin::csg {

Alike alike(const Gather& all, std::span<const std::uint32_t> children) {
  const Gather::Child& one = all.children[children.front()];
  if (children.size() == 1) return {{one.shape}, one.matrix};
  // The children of a union stand beside each other: what holds the first and the last holds all.
  std::uint32_t a = one.within, b = all.children[children.back()].within;
  while (a != b) {
    std::uint32_t& deeper = all.unions[a].depth >= all.unions[b].depth ? a : b;
    deeper = all.unions[deeper].parent;
  }
  const Gather::Within& within = all.unions[a];
  Alike out{{within.shape}, within.matrix};
  for (const std::uint32_t c : children) out.key.push_back(c - within.first);
  return out;
}

}  // namespace burin::csg
