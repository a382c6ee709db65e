#pragma once
// The title block on the sheet; internal to the module.

#include <burin/annotate/annotate.h>
#include <burin/annotate/title_block.h>
#include <burin/base/box.h>
#include <burin/camera/paper.h>

#include <memory>
#include <optional>

namespace burin::detail {

struct TitleBlockPlan {
  std::shared_ptr<const TitleBlockLayout> layout;
  /// Its lower left corner, paper mm.
  Vec2 at{0};
  /// What drawings and tables keep clear of; empty: nothing.
  Box2 box = {};
  /// Of the block of ISO 7200 where the sheet has no room for its width.
  bool narrow = false;
};

/// Nothing where there is none or it has no room.
std::optional<TitleBlockPlan> plan_title_block(const Annotations& annotations,
                                               const CalloutOptions& style, const Paper& paper);

/// Lays the layer "title_block"; tells of what is narrow or cut.
void lay_title_block(const TitleBlockPlan& plan, const TitleBlock& block,
                     const CalloutOptions& style, Drawing& drawing);

}  // namespace burin::detail
