#include "document.h"

#include "binary.h"
#include "gui.h"
#include "text.h"
#include "xml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// An archive of 100 bytes an object cannot hold more than this in its XML.
constexpr std::size_t kMostObjects = 1'000'000;

using Node = pugi::xml_node;

/// What of a property is kept, by its name.
class ObjectReader {
 public:
  explicit ObjectReader(FcObject& object) : o_(object) {}

  void take(const Node& property) {
    const std::string_view name = property.attribute("name").value();
    const Node value = first_element(property);
    if (o_.hole) o_.hole->take(name, value);
    if (o_.pattern) o_.pattern->take(name, value);
    if (name == "Label") {
      // A label of blanks says nothing.
      if (std::string label = clean_name(text_of(value)); !label.empty()) o_.label = label;
    } else if (name == "Visibility") {
      o_.visible = truth(value);
    } else if (name == "Shape") {
      o_.shape = value.attribute("file").value();
    } else if (name == "Mesh") {
      o_.mesh = value.attribute("file").value();
    } else if (name == "Placement" || name == "LinkPlacement") {
      o_.placement = placement(value);
      o_.has_placement = true;
    } else if (name == "Group") {
      o_.has_group = true;
      o_.group = names(value);
    } else if (name == "Tip") {
      o_.tip = text_of(value);
    } else if (name == "Proxy") {
      o_.proxy_module = value.attribute("module").value();
      o_.proxy_class = value.attribute("class").value();
    } else if (name == "Source" && o_.is("Part::Mirroring")) {
      o_.copy_of = link_name(value);
    } else if (name == "Geometry" && o_.type.starts_with("Sketcher::")) {
      o_.circles = circle_centers(value);
    } else if (name == "Objects") {
      copied_ = names(value);
    } else {
      take_of_link(name, value);
    }
  }

  void take_extension(std::string_view type) {
    if (type.starts_with("App::Link")) o_.extensions.link = true;
    if (type.find("GroupExtension") != type.npos) o_.extensions.group = true;
    // App::GeoFeatureGroupExtension, App::OriginGroupExtension, and those that Python adds.
    if (type.starts_with("App::GeoFeatureGroup") || type.starts_with("App::OriginGroup")) {
      o_.extensions.places_members = true;
    }
  }

  /// What several properties say together, once all have been taken.
  void finish() {
    if (o_.extensions.link && !o_.link && !base_.empty()) o_.link = FcLink{{}, base_, {}};
    if (o_.extensions.link && o_.element_count == 0) o_.element_count = count_;
    if (o_.proxy_module.starts_with("draftobjects.") && o_.proxy_class == "Clone" &&
        copied_.size() == 1) {
      o_.copy_of = copied_.front();
    }
  }

 private:
  void take_of_link(std::string_view name, const Node& value) {
    if (name == "LinkedObject") {
      link(value);
    } else if (name == "Base") {  // the names that Draft gives to two of the properties of a link
      base_ = link_name(value);
    } else if (name == "Count") {
      count_ = count(value);
    } else if (name == "LinkTransform") {
      o_.link_transform = truth(value);
    } else if (name == "ShowElement") {
      o_.show_elements = truth(value);
    } else if (name == "ScaleVector") {
      o_.scale = {number(value, "valueX", 1), number(value, "valueY", 1),
                  number(value, "valueZ", 1)};
    } else if (name == "ElementCount") {
      o_.element_count = count(value);
    } else if (name == "ElementList") {
      o_.elements = names(value);
    } else if (name == "VisibilityList") {
      // The first element's is the last digit.
      const std::string digits = text_of(value);
      for (auto it = digits.rbegin(); it != digits.rend(); ++it) {
        o_.elements_visible.push_back(*it != '0');
      }
    } else if (name == "PlacementList") {
      o_.placement_list = value.attribute("file").value();
    } else if (name == "ScaleList") {
      o_.scale_list = value.attribute("file").value();
    }
  }

  static std::int64_t count(const Node& value) {
    return static_cast<std::int64_t>(std::clamp(number(value, "value", 0), 0.0, 1e9));
  }

  static std::vector<std::string> names(const Node& list) {
    std::vector<std::string> out;
    for (const Node& link : list.children()) {
      if (const char* name = link_name(link); *name) out.emplace_back(name);
    }
    return out;
  }

  /// `value` in a plain link, `name` in one that may leave the document.
  static const char* link_name(const Node& link) {
    const char* name = link.attribute("value").value();
    return *name ? name : link.attribute("name").value();
  }

  void link(const Node& value) {
    FcLink link{value.attribute("file").value(), link_name(value), value.attribute("sub").value()};
    // More than one sub-name stand in elements of their own.
    if (link.sub.empty()) link.sub = first_element(value).attribute("value").value();
    if (!link.object.empty()) o_.link = std::move(link);
  }

  FcObject& o_;
  std::string base_;
  std::int64_t count_ = 0;
  std::vector<std::string> copied_;
};

const char* const kPartTypes[] = {"App::Part", "Assembly::AssemblyObject",
                                  "Assembly::AssemblyLink"};

template <class T>
T at(const std::string& bytes, std::size_t offset) {
  return load<T>(bytes.data() + offset, std::endian::little);
}

/// Rows of `width` doubles behind a count; single precision where the size says so.
std::vector<std::vector<double>> rows(const std::string& bytes, std::size_t width) {
  std::vector<std::vector<double>> out;
  if (bytes.size() < 4) return out;
  const std::size_t count = at<std::uint32_t>(bytes, 0), rest = bytes.size() - 4;
  const bool narrow = rest == count * width * sizeof(float);
  const std::size_t bytes_each = narrow ? sizeof(float) : sizeof(double);
  const std::size_t there = std::min(count, rest / (width * bytes_each));
  for (std::size_t i = 0; i < there; ++i) {
    std::vector<double> row(width);
    for (std::size_t k = 0; k < width; ++k) {
      const std::size_t offset = 4 + (i * width + k) * bytes_each;
      row[k] = narrow ? static_cast<double>(at<float>(bytes, offset)) : at<double>(bytes, offset);
      if (!std::isfinite(row[k])) return out;
    }
    out.push_back(std::move(row));
  }
  return out;
}

const Source& archive(const Source& source) {
  if (!source.bytes().starts_with("PK")) {
    source.fail("is no FreeCAD document, which is a zip archive; save the document again");
  }
  return source;
}

}  // namespace

bool FcObject::is_part() const {
  return std::any_of(std::begin(kPartTypes), std::end(kPartTypes),
                     [&](const char* t) { return type == t; }) ||
         (extensions.places_members && !is_body());
}
bool FcObject::is_body() const { return is("PartDesign::Body"); }
bool FcObject::is_link() const {
  if (is_link_group()) return false;
  // A Python object may have the extension of links, not use it, and keep a shape.
  return type.starts_with("App::Link") ||
         (extensions.link && (link || !elements.empty() || shape.empty()));
}
bool FcObject::is_link_group() const {
  return type.starts_with("App::LinkGroup") || (extensions.link && has_group);
}
bool FcObject::is_group() const {
  // Storeys of buildings (App::GeometryPython) hold their members, and a shape that sums them up.
  return has_group && !is_body() &&
         (shape.empty() || (extensions.group && type.starts_with("App::")));
}

FcDocument::FcDocument(const std::filesystem::path& path, const std::filesystem::path& copy,
                       const RunContext& context)
    : path_(path),
      source_(copy.empty() ? path : copy, context),
      package_(archive(source_), "FreeCAD document") {
  if (!package_.has("Document.xml")) {
    source_.fail("is a zip archive without a Document.xml, so no FreeCAD document");
  }
  read_objects();
  if (copy.empty()) {
    read_gui(package_);
  } else {
    const Source original(path, context);
    read_gui(Package(archive(original), "FreeCAD document"));
  }
}

void FcDocument::read_objects() {
  const Xml xml(package_.read("Document.xml"), "Document.xml", source_);
  const Node root = xml.root("Document");
  program_ = clean_name(root.attribute("ProgramVersion").value());
  program_ = "FreeCAD " + program_.substr(0, program_.find('R'));
  for (const Node& node : root.child("Objects").children("Object")) {
    FcObject object;
    object.name = node.attribute("name").value();
    object.type = node.attribute("type").value();
    object.label = clean_name(object.name);
    if (object.is("PartDesign::Hole")) object.hole.emplace();
    object.pattern = FcPattern::of_type(object.type);
    if (objects_.size() >= kMostObjects) source_.fail("holds absurdly many objects; it is damaged");
    const auto number = static_cast<std::int32_t>(objects_.size());
    if (index_.emplace(object.name, number).second) objects_.push_back(std::move(object));
  }
  for (const Node& node : root.child("ObjectData").children("Object")) {
    source_.context().check();
    const std::int32_t number = find(node.attribute("name").value());
    if (number < 0) continue;
    FcObject& object = objects_[static_cast<std::size_t>(number)];
    ObjectReader reader(object);
    for (const Node& e : node.child("Extensions").children("Extension")) {
      reader.take_extension(e.attribute("type").value());
    }
    for (const Node& p : node.child("Properties").children("Property")) reader.take(p);
    reader.finish();
  }
  find_holders();
}

void FcDocument::find_holders() {
  holder_.assign(objects_.size(), -1);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const FcObject& o = objects_[i];
    if (!o.is_part() && !o.is_link_group()) continue;
    for (const std::string& name : o.members()) {
      const std::int32_t child = find(name);
      if (child < 0 || holder_[static_cast<std::size_t>(child)] >= 0) continue;
      holder_[static_cast<std::size_t>(child)] = static_cast<std::int32_t>(i);
    }
  }
}

const FcObject* FcDocument::holder(const FcObject& object) const {
  const std::int32_t i = holder_[static_cast<std::size_t>(&object - objects_.data())];
  return i < 0 ? nullptr : &objects_[static_cast<std::size_t>(i)];
}

void FcDocument::read_gui(const Package& package) {
  if (!package.has("GuiDocument.xml")) return;
  // Colours are not worth a refusal: what is wrong with the file of the window is passed over.
  try {
    const Xml xml(package.read("GuiDocument.xml"), "GuiDocument.xml", source_);
    const auto list = [&](const std::string& name) {
      return package.has(name) ? package.read(name) : std::string();
    };
    for (const Node& node :
         xml.root("Document").child("ViewProviderData").children("ViewProvider")) {
      source_.context().check();
      const std::int32_t number = find(node.attribute("name").value());
      if (number >= 0) apply_view(node, list, objects_[static_cast<std::size_t>(number)]);
    }
  } catch (const InputError&) {
    gui_is_broken_ = true;
  }
}

std::int32_t FcDocument::find(const std::string& name) const {
  const auto it = index_.find(name);
  return it == index_.end() ? -1 : it->second;
}

std::vector<Placement> FcDocument::placements(const FcObject& object) const {
  std::vector<Placement> out;
  if (object.placement_list.empty()) return out;
  for (const std::vector<double>& r : rows(member(object.placement_list), 7)) {
    out.push_back(make_placement({r[0], r[1], r[2]}, {r[3], r[4], r[5], r[6]}));
  }
  return out;
}

std::vector<Vec3> FcDocument::scales(const FcObject& object) const {
  std::vector<Vec3> out;
  if (object.scale_list.empty()) return out;
  for (const std::vector<double>& r : rows(member(object.scale_list), 3)) {
    out.emplace_back(r[0], r[1], r[2]);
  }
  return out;
}

}  // namespace burin::detail
