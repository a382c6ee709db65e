#pragma once
/// Triangles in place of surfaces, as AP242 can hold them: OCCT 7.6 has no class for them, and
/// passes them over without a word.

#include "cad_file.h"

class StepData_StepModel;

namespace burin {

/// What of a STEP model is tessellated.
class Tessellated {
 public:
  explicit Tessellated(const StepData_StepModel& model);
  /// Says what was passed over; throws InputError where there is nothing else.
  void report(CadFile& file, const Source& source) const;

 private:
  /// Faces, and sets of triangles without a body.
  std::int64_t faces_ = 0;
  /// Solids and shells, and those of them that double no exact one.
  std::int64_t bodies_ = 0, alone_ = 0;
};

}  // namespace burin
