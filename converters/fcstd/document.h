#pragma once
// A FreeCAD document as it stands in its archive; internal to the module.

#include <burin/base/run_context.h>
#include <burin/forms/charted/chart.h>

#include "package.h"
#include "patterns.h"
#include "source.h"
#include "threads.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace burin::detail {

/// Where a link points: into `file` (empty: the same document), at `object`, and from there down
/// `sub` ("Part.Box.").
struct FcLink {
  std::string file, object, sub;
};

/// How the window shows an object.
struct FcLook {
  /// "#rrggbb" or empty.
  std::string color;
  /// 1 hides what is behind, 0 is not seen at all.
  double opacity = 1;
  /// Of each face, where they differ; of glass with its opacity, where that is not the part's.
  std::shared_ptr<const std::vector<std::string>> faces = {};
};

/// What FreeCAD adds to an object of any type ("App::LinkExtensionPython"), as far as it says where
/// the object's shapes come from.
struct FcExtensions {
  bool link = false, group = false;
  /// A group that moves its members.
  bool places_members = false;
};

struct FcObject {
  std::string name, type, label;
  FcExtensions extensions;
  /// The Python class behind an object: "draftobjects.array", "Array".
  std::string proxy_module, proxy_class;
  bool visible = true;
  FcLook look;
  /// Links: whether `look` replaces that of what is linked.
  bool overrides_look = false;

  /// Members of the archive, empty where there is none: "PartShape.brp", "MeshKernel.bms".
  std::string shape, mesh;
  Placement placement;
  /// Whether it stands somewhere in space: sheets, pages, joints, materials do not.
  bool has_placement = false;
  /// What it is an unchanged or mirrored copy of (Part::Mirroring, clones), with a shape of its
  /// own.
  std::string copy_of;
  bool has_group = false;
  std::vector<std::string> group;
  std::string tip;
  /// Of a PartDesign::Hole.
  std::optional<FcHole> hole;
  /// Of what repeats features of PartDesign.
  std::optional<FcPattern> pattern;
  /// Of a sketch: the centres of its circles, in its own plane.
  std::vector<Vec3> circles;

  std::optional<FcLink> link;
  bool link_transform = false;
  bool show_elements = true;
  Vec3 scale{1};
  std::int64_t element_count = 0;
  std::vector<std::string> elements;
  std::vector<bool> elements_visible;
  /// Members of the archive.
  std::string placement_list, scale_list;

  bool is(const char* t) const { return type == t; }
  /// Whether members of `group` are placed by this object: App::Part and its kind.
  bool is_part() const;
  bool is_body() const;
  /// App::Link, and objects of other types with the extension of links: arrays of Draft, parts of
  /// other workbenches.
  bool is_link() const;
  bool is_link_group() const;
  /// Whether it has no shape of its own but members.
  bool is_group() const;
  /// Those that it holds in the tree.
  const std::vector<std::string>& members() const { return has_group ? group : elements; }
  /// Made by Burin's own workbench: a drawing, no model.
  bool is_illustration() const { return proxy_module.starts_with("freecad.burin_wb"); }
};

class FcDocument {
 public:
  /// `copy` (a recomputed one, else empty) is read in the place of `path`, which still gives what
  /// belongs to the window, the folder of links, and the name in errors. Throws InputError for what
  /// is no document.
  FcDocument(const std::filesystem::path& path, const std::filesystem::path& copy,
             const RunContext& context);

  const std::filesystem::path& path() const { return path_; }
  /// "FreeCAD 0.20".
  const std::string& program() const { return program_; }
  const std::vector<FcObject>& objects() const { return objects_; }
  /// The number of an object, or -1.
  std::int32_t find(const std::string& name) const;
  /// The first App::Part or group of links that has an object as a member, or nothing.
  const FcObject* holder(const FcObject& object) const;
  std::string member(const std::string& name) const { return package_.read(name); }

  bool gui_is_broken() const { return gui_is_broken_; }

  /// Lists of links of arrays; shorter than the array where the file holds less.
  std::vector<Placement> placements(const FcObject& object) const;
  std::vector<Vec3> scales(const FcObject& object) const;

 private:
  void read_objects();
  void read_gui(const Package& package);
  void find_holders();

  std::filesystem::path path_;
  Source source_;
  Package package_;
  std::string program_;
  std::vector<FcObject> objects_;
  std::unordered_map<std::string, std::int32_t> index_;
  std::vector<std::int32_t> holder_;
  bool gui_is_broken_ = false;
};

}  // namespace burin::detail
