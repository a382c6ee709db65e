#pragma once
// The parts of one revision as matching and comparing look at them; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/diff/match.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace burin::detail {

/// Realises parts when they are asked for, and keeps as many triangles as there is room for.
class RevisionSurfaces {
 public:
  RevisionSurfaces(const Scene& scene, std::vector<bool> drawn, Diagnostics& diagnostics,
                   RunContext& context)
      : scene_(scene),
        drawn_(std::move(drawn)),
        diagnostics_(diagnostics),
        context_(context),
        kept_(scene.parts.size()),
        failed_(scene.parts.size(), false) {}

  /// All parts, measured. `from` to `to`: the share of the run's stage that it is.
  std::vector<RevisionPart> measured(double from, double to);

  /// The triangles of a part; null where it has none or cannot be realised, which is told once.
  std::shared_ptr<const Surface> surface(std::size_t part);

 private:
  ShapeMeasure measure(std::size_t part);
  void report(std::size_t part, const char* what);

  const Scene& scene_;
  std::vector<bool> drawn_;
  Diagnostics& diagnostics_;
  RunContext& context_;
  std::vector<std::shared_ptr<const Surface>> kept_;
  std::vector<bool> failed_;
  std::size_t triangles_ = 0;
  /// Of what parts are instances of.
  std::map<const void*, std::vector<std::pair<Definition, ShapeMeasure>>> measures_;
};

}  // namespace burin::detail
