#pragma once
/// Items sorted into numbered groups: the triangles at each vertex, the links at each node.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace burin {

/// Group i holds list[first[i]] to list[first[i + 1] - 1]; `first` has one entry more than there
/// are groups.
template <class T>
struct Groups {
  std::vector<std::uint32_t> first;
  std::vector<T> list;

  std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }
  std::span<const T> operator[](std::size_t group) const {
    return {list.data() + first[group], list.data() + first[group + 1]};
  }
};

/// Item i of `items` goes once into each of the groups `keys(i)`, an array of numbers below
/// `groups`, as what stands at the same place of the array `values(i)`. Each group keeps the order
/// of the items. Cost: linear (a counting sort); `keys` is asked twice, `values` once.
template <class Keys, class Values>
auto grouped(std::size_t groups, std::size_t items, const Keys& keys, const Values& values) {
  using T = typename decltype(values(std::size_t{}))::value_type;
  Groups<T> out;
  out.first.assign(groups + 1, 0);
  for (std::size_t i = 0; i < items; ++i) {
    for (const std::uint32_t k : keys(i)) ++out.first[k + 1];
  }
  for (std::size_t g = 0; g < groups; ++g) out.first[g + 1] += out.first[g];
  out.list.resize(out.first[groups]);
  std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
  for (std::size_t i = 0; i < items; ++i) {
    const auto all = keys(i);
    auto each = values(i);
    for (std::size_t n = 0; n < all.size(); ++n) out.list[next[all[n]]++] = std::move(each[n]);
  }
  return out;
}

}  // namespace burin
