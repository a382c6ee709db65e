#include <burin/surface/thread.h>

namespace burin {

Thread placed(const Thread& thread, const Placement& by) {
  Thread out = thread;
  const Vec3 along = by.vector(thread.axis.along);
  const double scale = by.scale(), length = glm::length(along);
  out.axis = {by.point(thread.axis.point), normalize_or(along, thread.axis.along)};
  out.begin *= length;
  out.end *= length;
  out.major *= scale;
  out.minor *= scale;
  out.modelled *= scale;
  return out;
}

}  // namespace burin
