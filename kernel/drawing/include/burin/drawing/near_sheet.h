#pragma once
/// The part of a drawing that formats of limited range can hold.

#include <burin/drawing/ink.h>

#include <deque>
#include <vector>

namespace burin {

/// The layers of a drawing with paths that run far off the sheet (more than its longer side) cut
/// there; what is cut from a closed path is open. Points into the drawing and into itself. Cost:
/// one look at every point.
class NearSheet {
 public:
  explicit NearSheet(const Drawing& drawing);
  NearSheet(const NearSheet&) = delete;
  NearSheet& operator=(const NearSheet&) = delete;

  const std::vector<InkLayer>& layers() const { return layers_; }

 private:
  std::vector<InkLayer> layers_;
  std::deque<Path> pieces_;
};

}  // namespace burin
