#pragma once
/// An exploded view read backwards: in which order a product is put together.

#include <burin/explode/explode.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// Parts that come to their place together; what they are is a part, or a sub-assembly that was put
/// together before.
struct BuildMove {
  std::vector<std::size_t> parts;
  /// Unit vector: the way from where they are added to where they come from.
  Vec3 along{0, 0, 1};
};

/// What a page shows.
struct BuildStep {
  std::vector<BuildMove> moves;
  /// What stands there already, ascending; where `begins`, it is new, too.
  std::vector<std::size_t> assembled;
  bool begins = false;
  /// What is put together: empty for the whole, else what its parts are called together, and how
  /// many of it are needed.
  std::string assembly;
  std::size_t quantity = 1;

  std::vector<std::size_t> parts() const;
};

struct BuildOptions {
  /// Items that a step adds at the most, where it can be parted; instances of one item count once.
  std::size_t items = 6;
};

/// The steps backwards. A sub-assembly is put together before it is added, once where there are
/// several alike; steps that add the same are one; what only follows others (a second way of what
/// has left already) adds nothing. `drawn`: one a part; others are left out. `item_of`: the number
/// of each part's item. One step that shows everything where nothing comes apart. Cost: the square
/// of the steps.
std::vector<BuildStep> build_steps(const Scene& scene, const std::vector<bool>& drawn,
                                   const std::vector<ExplodeStep>& steps,
                                   const std::vector<int>& item_of, const BuildOptions& options);

/// What parts are called together: the name of the assembly whose parts they are, all of those that
/// are drawn; else their own names, each once, with " + " between them.
std::string name_together(const Scene& scene, const std::vector<bool>& drawn,
                          const std::vector<std::size_t>& parts);

/// Parts that are one thing below `depth` names of assemblies: all drawn ones of a sub-assembly, or
/// one part.
std::vector<std::vector<std::size_t>> units_of(const Scene& scene, const std::vector<bool>& drawn,
                                               const std::vector<std::size_t>& parts,
                                               std::size_t depth);

}  // namespace burin
