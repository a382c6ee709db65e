#pragma once
// What the keys of illustration files are: reading and the schema are made from them; internal to
// the module.

#include <burin/options/request.h>

#include <string>
#include <vector>

namespace burin::detail {

/// A key of an illustration that is an option of a drawing: "view.from" is "view".
struct IllustrationKey {
  std::string path;
  std::string option;
};

const std::vector<IllustrationKey>& illustration_keys();

/// The option of a drawing or of reading of that name.
const RequestOption& option_named(const std::string& name);

/// Members of an input beside options about reading, of a look, of a section, of an exploded view
/// and its steps, of a light, of a detail.
inline const std::vector<std::string> kInputKeys = {"file", "function", "name", "place"};
inline const std::vector<std::string> kPlaceKeys = {"translate", "rotate", "scale", "matrix"};
inline const std::vector<std::string> kItemKeys = {"name", "select"};
inline const std::vector<std::string> kLookKeys = {"select",  "style",       "drawn",
                                                   "hatched", "transparent", "listed"};
inline const std::vector<std::string> kSectionKeys = {"plane", "planes", "steps",
                                                      "box",   "around", "exclude"};
inline const std::vector<std::string> kAroundKeys = {"center", "radius"};
inline const std::vector<std::string> kPlaneKeys = {"normal", "offset"};
inline const std::vector<std::string> kExplodeKeys = {"steps", "along", "base", "fit", "factor"};
inline const std::vector<std::string> kStepKeys = {"move", "along", "by", "trail"};
inline const std::vector<std::string> kDetailKeys = {"select", "at", "radius", "scale", "letter"};
inline const std::vector<std::string> kLightKeys = {"ambient", "from", "at", "strength"};

}  // namespace burin::detail
