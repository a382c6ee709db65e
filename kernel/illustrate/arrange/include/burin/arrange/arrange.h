#pragma once
/// From a scene as it was read to one that is ready to be drawn: which parts are drawn and how,
/// their numbers, what is cut open, what comes apart, and the views on the sheet.

#include <burin/arrange/illustration.h>
#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/explode/explode.h>
#include <burin/illustrate/session.h>
#include <burin/illustrate/sheet.h>
#include <burin/surface/scene.h>

#include <vector>

namespace burin {

/// All that an illustration does to parts: `select_parts`, `number_parts`, `find_threads`, steps
/// found, parts cut,
/// parts moved by the steps, with trails. Once for a scene. Throws as they do. Cost: that of
/// `ExplodeModel` where parts come apart.
void arrange_parts(Scene& scene, Illustration& illustration, RunContext& context);
/// The views of the parts that are drawn, and where they stand on the sheet. Diagnostics go to
/// `scene`. Throws UsageError where views or details have no room or no size of a sheet to stand
/// on, GeometryError as `Camera::fit`.
SheetOfViews plan_sheet(Scene& scene, const Illustration& illustration);
/// Draws a scene that was arranged on a sheet that was planned; tells of a sheet that is mostly
/// empty. `session`: keeps what the next drawing may use again. Throws as `illustrate`.
Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Illustration& illustration,
                   RunContext& context, Session* session = nullptr);
/// All three.
Drawing illustrate(Scene scene, Illustration illustration, RunContext& context);

/// Turns what an illustration says of parts by name into `illustrate.part_styles`, over what is
/// there. Parts of which a selector names a body are split first (burin/assembly/pieces.h).
/// Throws UsageError where a selector names nothing, or nothing is left to draw.
void select_parts(Scene& scene, Illustration& illustration);
/// Splits the parts of which a selector of the illustration names a body, and names items that a
/// selector means by a name of the illustration (`name_items`). `styles` are made as many
/// as there are parts then; bodies have that of their part.
void split_parts(Scene& scene, const Illustration& illustration, std::vector<PartStyle>& styles);
/// Finds and numbers the items of the scene where the illustration has a use for them, and fills
/// `illustrate.annotations` with those that are drawn, once `select_parts` knows which these are.
/// Tells in the scene's diagnostics of numbers that are kept for parts that are not there. Throws
/// Cancelled.
void number_parts(Scene& scene, Illustration& illustration, RunContext& context);
/// Finds the faces of the threads that the input tells of its parts and of those that the
/// illustration asks for, as `Part::threads`; those of the illustration go over others on their
/// face. Once `select_parts` knows which parts are drawn, and before any is cut or moved. Tells of
/// threads for which no face is found, and of those that no table has. Throws UsageError where a
/// selector names nothing or as `check_thread_row`. Cost: that of `ThreadFinder` a part that has
/// threads.
void find_threads(Scene& scene, const Illustration& illustration, RunContext& context);
/// Throws UsageError where a row says of no thread what it is.
void check_thread_row(const ThreadRow& row);
/// Cuts the parts by the sections of an illustration, once `select_parts` knows which are drawn;
/// sections with a view of their own cut copies (`Illustration::section_views`). Tells of sections
/// that cut nothing and of parts that stay whole by custom. Throws UsageError where a selector
/// names nothing, nothing is left, or a letter stands twice.
void cut_parts(Scene& scene, Illustration& illustration);
/// Finds what breaks leave out of what is drawn, as `Illustration::left_out`, once parts are cut
/// and moved. Tells of breaks that leave nothing out. Throws UsageError where they are along
/// different axes or overlap. Cost: realising all parts, where stretches are to be found or overall
/// dimensions are drawn.
void find_breaks(Scene& scene, Illustration& illustration, RunContext& context);
/// Gives the dimensions and notes of an illustration what their faces and edges look like
/// (`FeatureRow::print`), by which they are found again once the models have changed, once
/// `select_parts` knows which parts are drawn. Rows that lost their place stay as they are;
/// diagnostics go to `scene`. Throws UsageError where a row measures nothing. Cost: that of
/// measuring all faces of their parts.
void keep_features(Scene& scene, Illustration& illustration, RunContext& context);
/// The steps by which a scene comes apart, once `select_parts` knows which parts are drawn: those
/// of the illustration, or those that are found, as selectors that name the parts. Diagnostics go
/// to `scene`. Throws UsageError where a selector names nothing.
std::vector<ExplodeStep> explode_steps(Scene& scene, const Illustration& illustration,
                                       RunContext& context);
/// The same, of a model that is there, by the numbers of the parts. `drawn`: one a part.
std::vector<ExplodeStep> explode_steps(Scene& scene, const Explode& explode,
                                       const std::vector<bool>& drawn, const ExplodeModel& model,
                                       RunContext& context);

}  // namespace burin
