#pragma once
/// Numbers of a STEP file with which OCCT would not come to an end.

#include <StepData_StepModel.hxx>

namespace burin {

class Source;

/// Refuses a file with a point or a knot of a spline beyond 1e12, or one that is no number.
void refuse_absurd_numbers(const StepData_StepModel& model, const Source& source);

}  // namespace burin
