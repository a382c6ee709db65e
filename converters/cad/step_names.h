#pragma once
/// Names that a STEP file has for what is in its products.

#include "collect.h"

#include <map>
#include <string>

class STEPCAFControl_Reader;

namespace burin {

/// The numbers of products that have a name beside them.
std::multimap<std::string, std::string> numbers_of_products(STEPCAFControl_Reader& reader);

/// The names of solids that were translated.
ShapeNames names_of_solids(STEPCAFControl_Reader& reader);

}  // namespace burin
