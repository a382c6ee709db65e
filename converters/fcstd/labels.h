#pragma once
// Labels that a person gave, not those that FreeCAD makes; internal to the module.

#include "document.h"

#include <string>

namespace burin::detail {

/// Whether a label is one that FreeCAD gives to new objects of its type: "Body001", "Cut",
/// "Würfel".
bool is_meaningless(const FcObject& object);

/// What a person called an object: its label, or else that of the container that shows it alone.
/// Empty where neither says anything.
std::string given_name(const FcDocument& document, const FcObject& object);

/// Whether no more than one of what a container holds can be seen in it.
bool shows_one(const FcDocument& document, const FcObject& container);

/// Whether it is an aid of modelling, no part of the model: sketches, planes, binders.
bool is_aid(const FcObject& object);
/// Whether it is what another workbench keeps its books in: constraints of Assembly 3, which link
/// to faces of parts that are drawn anyway.
bool is_bookkeeping(const FcObject& object);

}  // namespace burin::detail
