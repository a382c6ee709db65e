#include "occluders.h"

#include <burin/surface/empty_surface.h>

#include <algorithm>
#include <utility>

namespace burin::detail {
namespace {

std::vector<const ProxyMesh*> proxies_of(const Surfaces& surfaces) {
  std::vector<const ProxyMesh*> proxies;
  for (const auto& surface : surfaces) proxies.push_back(&surface->proxy());
  return proxies;
}

std::vector<const ProxyMesh*> solid_ones(std::vector<const ProxyMesh*> proxies,
                                         const std::vector<bool>& transparent) {
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    if (transparent[i]) proxies[i] = &empty_surface()->proxy();
  }
  return proxies;
}

}  // namespace

std::vector<double> sizes_of(const Surfaces& surfaces) {
  std::vector<double> sizes(surfaces.size(), 0);
  for (std::size_t i = 0; surfaces.size() > 1 && i < surfaces.size(); ++i) {
    const TriMesh& mesh = surfaces[i]->proxy().mesh;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) sizes[i] += mesh.area(t);
  }
  return sizes;
}

Occluders::Occluders(Surfaces surfaces, std::vector<bool> transparent, std::vector<double> ranks,
                     const RunContext& context)
    : surfaces_(std::move(surfaces)),
      transparent_(std::move(transparent)),
      ranks_(std::move(ranks)),
      proxies_(proxies_of(surfaces_)),
      solid_proxies_(solid_ones(proxies_, transparent_)),
      solid_(solid_proxies_, context, tree_options()) {}

bool Occluders::any_transparent() const {
  return std::ranges::find(transparent_, true) != transparent_.end();
}

std::vector<const ProxyMesh*> Occluders::proxies_with(const std::vector<bool>& parts) const {
  std::vector<const ProxyMesh*> proxies = solid_proxies_;
  for (std::size_t i = 0; i < proxies.size(); ++i) {
    if (parts[i]) proxies[i] = proxies_[i];
  }
  return proxies;
}

std::vector<const ProxyMesh*> Occluders::proxies_before(std::size_t part) const {
  std::vector<const ProxyMesh*> proxies = solid_proxies_;
  proxies[part] = proxies_[part];
  return proxies;
}

}  // namespace burin::detail
