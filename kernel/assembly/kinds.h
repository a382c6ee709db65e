#pragma once
// Which parts are of one name and one shape; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/congruence/body.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/surface/scene.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace burin::detail {

/// What a part is in lists: itself, or what it is a body of.
inline const Part& listed(const Part& part) { return part.whole ? *part.whole : part; }

/// One shape, as far as it is known.
struct KnownShape {
  /// None of what several parts make: how these stand to each other it does not say.
  std::optional<Definition> definition;
  std::optional<ShapeMeasure> measure;
};

/// Parts that are alike, before they have a number.
struct Kind {
  /// The name without numbers at its end.
  std::string key;
  std::vector<KnownShape> shapes;
  std::vector<std::size_t> parts;
  /// The first shape as triangles, and whether that is its own mirror image, where it was asked.
  std::shared_ptr<const Body> body;
  std::optional<bool> own_image;
};

class Kinds {
 public:
  Kinds(const Scene& scene, Diagnostics& diagnostics, RunContext& context)
      : scene_(scene), diagnostics_(diagnostics), context_(context) {}

  /// In the order of the scene. A thing counts where one of its parts is listed.
  std::vector<Kind> find(const std::vector<bool>& unlisted = {});

 private:
  /// The thing that begins with the part at `index`.
  void add(std::size_t index);
  /// The number of the kind that the thing at `index` is of, made for it where there is none yet.
  std::size_t kind_of(std::size_t index);
  /// Whether the thing at `index`, of `shape`, is a copy of what is known of a kind.
  bool same_shape(Kind& kind, KnownShape& shape, std::size_t index);
  /// Where measures do not tell left from right.
  bool same_hand(Kind& kind, const KnownShape& shape, std::size_t index);
  std::optional<ShapeMeasure> measured(std::size_t index);
  std::shared_ptr<const Body> body_of(std::size_t index);
  /// The triangles of all parts of a thing, as if they were of one.
  ProxyMesh together(std::size_t index) const;
  void report(std::size_t index, const char* why);

  const Scene& scene_;
  Diagnostics& diagnostics_;
  RunContext& context_;
  std::vector<Kind> kinds_;
  std::map<std::string, std::vector<std::size_t>> by_name_;
  /// The kinds of parts of which bodies were met.
  std::map<const Part*, std::size_t> of_whole_;
  std::set<std::size_t> reported_;
};

}  // namespace burin::detail
