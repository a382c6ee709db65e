#pragma once
/// What the groups, subfigures and solids of an IGES file are called.

#include <TopoDS_Shape.hxx>

#include <string>
#include <utility>
#include <vector>

class IGESCAFControl_Reader;

namespace burin {

/// The shapes that were made of groups, subfigures and solids that have a name, with that, as the
/// bytes of the file. To be called after the transfer.
std::vector<std::pair<TopoDS_Shape, std::string>> named_members(IGESCAFControl_Reader& reader);

}  // namespace burin
