#pragma once
// A FreeCAD document as it stands in its archive; internal to the room.

#include <burin/base/run_context.h>
#include <burin/forms/charted/chart.h>

#include "package.h"
#include "source.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// Where a link points: into `file` (empty: the same document), at `object`, and from there down
/// `sub` ("Part.Box.").
struct FcLink {
  std::string file, object, sub;
};

struct FcObject {
  std::string name, type, label;
  bool visible = true;
  /// "#rrggbb" or empty.
  std::string color;
  /// Links: whether `color` replaces that of what is linked.
  bool overrides_color = false;

  /// Members of the archive, empty where there is none: "PartShape.brp", "MeshKernel.bms".
  std::string shape, mesh;
  Placement placement;
  bool has_group = false;
  std::vector<std::string> group;
  std::string tip;

  std::optional<FcLink> link;
  bool link_transform = false;
  bool show_elements = true;
  Vec3 scale{1};
  std::int64_t element_count = 0;
  std::vector<std::string> elements;
  std::vector<bool> elements_visible;
  /// Members of the archive.
  std::string placement_list, scale_list;

  /// Made by Burin's own workbench: a drawing, no model.
  bool is_illustration = false;

  bool is(const char* t) const { return type == t; }
  /// Whether members of `group` are placed by this object: App::Part and its kind.
  bool is_part() const;
  bool is_body() const;
  bool is_link() const;
  bool is_link_group() const;
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
  std::string member(const std::string& name) const { return package_.read(name); }

  bool gui_is_broken() const { return gui_is_broken_; }

  /// Lists of links of arrays; shorter than the array where the file holds less.
  std::vector<Placement> placements(const FcObject& object) const;
  std::vector<Vec3> scales(const FcObject& object) const;

 private:
  void read_objects();
  void read_gui(const Package& package);

  std::filesystem::path path_;
  Source source_;
  Package package_;
  std::string program_;
  std::vector<FcObject> objects_;
  std::map<std::string, std::int32_t> index_;
  bool gui_is_broken_ = false;
};

}  // namespace burin::detail
