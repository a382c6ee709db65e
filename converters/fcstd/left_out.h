#pragma once
// What a document shows and a drawing of it does not, by name; internal to the module.

#include <burin/base/diagnostics.h>

#include "document.h"

#include <string>
#include <vector>

namespace burin::detail {

/// One line a reason, with the names of all objects that it holds for.
class LeftOut {
 public:
  /// `why` is the line without the names.
  void add(Severity severity, const char* code, const std::string& why, const std::string& name);
  void report(Diagnostics& diagnostics) const;

 private:
  struct Reason {
    Severity severity;
    const char* code;
    std::string why;
    std::vector<std::string> names;
  };
  std::vector<Reason> reasons_;
};

/// Tells of an object without a shape, called `name`; not of what is nowhere to be seen: sheets,
/// pages, joints, data.
void leave_out_shapeless(const FcObject& object, const std::string& name, LeftOut& left_out);
/// Tells of an aid of modelling that was not named. Sketches and binders are seen, of planes, axes
/// and points nobody expects it.
void leave_out_aid(const FcObject& object, const std::string& name, LeftOut& left_out);
/// Tells of an object whose shape has no face.
void leave_out_faceless(const std::string& name, LeftOut& left_out);

}  // namespace burin::detail
