#include "flat.h"
#include "flat/import/import_file.h"

namespace burin::csg {
namespace {

/// None where the children say it.
Dimension own_dimension(const Node& node) {
  if (makes_solid(node.module)) return Dimension::Solid;
  if (makes_flat(node.module)) return Dimension::Flat;
  if (node.module != Module::Import) return Dimension::None;
  const std::string suffix = suffix_of(node.text("file"));
  return suffix == ".dxf" || suffix == ".svg" ? Dimension::Flat : Dimension::Solid;
}

}  // namespace

std::vector<Dimension> dimensions(const Tree& tree) {
  std::vector<Dimension> out(tree.nodes.size(), Dimension::None);
  // Children stand behind their parents.
  for (auto i = static_cast<std::uint32_t>(tree.nodes.size()); i-- > 0;) {
    out[i] = own_dimension(tree.nodes[i]);
    if (out[i] != Dimension::None) continue;
    for_each_child(tree, i, [&](std::uint32_t child) {
      if (out[i] == Dimension::None && !tree.nodes[child].background) out[i] = out[child];
    });
  }
  return out;
}

}  // namespace burin::csg
