#pragma once
// The views that a sheet of several shows, and where sections cut in them; internal to the module.

#include <burin/annotate/sections.h>
#include <burin/arrange/illustration.h>
#include <burin/illustrate/sheet.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace burin::detail {

/// A view of the sheet before it has its place.
struct WantedView {
  std::string name;
  /// The view in whose place it stands.
  std::string stands_as;
  ViewOptions view;
  const SectionView* section = nullptr;
  /// Whether it shows where a section cuts.
  bool marked = false;
  bool none_hidden = false;
  /// Paper mm that marks and names need beside it.
  Margin room = Margin(0);
};

/// Right, up and to the viewer, as rows, of a view, whatever it shows.
Mat3 axes_of(const ViewOptions& view);

/// "front", "iso" ... of a view that has the direction of such a one, else "view".
std::string name_of(const ViewOptions& view);

/// Those that are named, and one for each section that has its own. Without names the view that is
/// asked for, after those that see sections from their edges where it does not itself; none where
/// no section has a view of its own. Throws UsageError where `hidden_views` names another.
std::vector<WantedView> wanted_views(const Illustration& illustration);

/// The number of the view that shows where a section cuts, if one does.
std::optional<std::size_t> parent_of(const std::vector<WantedView>& views,
                                     const Illustration& illustration, const SectionView& section);

/// Where a section cuts, in a view that has its place; nothing where a break leaves it out.
std::optional<SectionMark> mark_of(const SectionView& section, const Scene& scene,
                                   const Illustration& illustration, const ViewOptions& view,
                                   const PlacedView& placed);

/// Tells of a section that no view shows from its edge.
void report_no_line(Scene& scene, const Illustration& illustration, const SectionView& section);

}  // namespace burin::detail
