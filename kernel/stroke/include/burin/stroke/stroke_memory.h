#pragma once
/// What strokes leave for the same ones in another light.

#include <burin/stroke/options.h>

#include <memory>

namespace burin {

/// For `trace_strokes`, again and again with the same surfaces, camera, field, probe, options and
/// seed and another tone: what is seen where, and where the lines of the first family of even
/// strokes stand, which takes most of the time. The strokes are the same with and without it. Some
/// 150 bytes a cell of 0.4 mm that is seen, and the lines.
class StrokeMemory {
 public:
  StrokeMemory();
  ~StrokeMemory();

  struct Impl;
  Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// The options with all that changes nothing of what is remembered set to one value: pens, tapers,
/// what ink there has to be.
HatchOptions remembered_by(HatchOptions options);

}  // namespace burin
