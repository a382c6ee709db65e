#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/version.h>

namespace burin {

const char* to_string(LineClass kind) {
  switch (kind) {
    case LineClass::Contour:
      return "contour";
    case LineClass::Boundary:
      return "boundary";
    case LineClass::Crease:
      return "crease";
    case LineClass::Smooth:
      return "smooth";
    case LineClass::Seam:
      return "seam";
    case LineClass::Intersection:
      return "intersection";
    case LineClass::Section:
      return "section";
    case LineClass::Ridge:
      return "ridge";
    case LineClass::Valley:
      return "valley";
    case LineClass::Suggestive:
      return "suggestive";
    case LineClass::Isophote:
      return "isophote";
    case LineClass::Stroke:
      return "stroke";
    case LineClass::Pattern:
      return "pattern";
    case LineClass::Trail:
      return "trail";
    case LineClass::Centre:
      return "centre";
    case LineClass::Thread:
      return "thread";
    case LineClass::ThreadEnd:
      return "thread-end";
    case LineClass::Leader:
      return "leader";
    case LineClass::Frame:
      return "frame";
  }
  return "unknown";
}

const char* to_string(Severity severity) {
  switch (severity) {
    case Severity::Info:
      return "info";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "unknown";
}

const char* version() { return BURIN_VERSION; }

}  // namespace burin
