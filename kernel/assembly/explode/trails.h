#pragma once
// Lines from where parts belong to where they are; internal to the module.

#include <burin/base/curve.h>
#include <burin/explode/explode.h>

#include "contacts.h"
#include "shapes.h"

#include <vector>

namespace burin::detail {

std::vector<Curve3> make_trails(const std::vector<ExplodeStep>& steps, double factor,
                                const Shapes& shapes, const std::vector<Contact>& contacts);

}  // namespace burin::detail
