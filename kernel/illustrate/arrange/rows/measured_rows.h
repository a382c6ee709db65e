#pragma once
// Features that rows of dimensions name, measured; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/base/run_context.h>
#include <burin/surface/scene.h>

#include <string>
#include <vector>

namespace burin::detail {

/// "dimension 2 (diameter)".
std::string called(const MeasuredRow& row);
/// Warns of a row: `what` follows its name.
void tell_of(const MeasuredRow& row, const char* code, const std::string& what,
             Diagnostics& diagnostics);

/// Fills `Illustration::measured` once it is known which parts are drawn, before they are cut or
/// moved. Throws UsageError where a row names what is not there or cannot be measured so.
void measure_rows(Scene& scene, Illustration& illustration, RunContext& context);
/// Tells notes the numbers of the items that they name, once these are known.
void number_notes(Illustration& illustration);
/// What is left of the features of the rows in the scenes that were cut, before parts move.
void look_at_cuts(const Scene& scene, Illustration& illustration, RunContext& context);
/// Rows move with their parts; those whose parts come apart are told and left out.
void move_rows(Scene& scene, Illustration& illustration, const std::vector<Vec3>& moves);

}  // namespace burin::detail
