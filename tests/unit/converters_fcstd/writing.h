#pragma once
// FreeCAD documents made by hand: XML as FreeCAD writes it, shapes by OCCT, zipped by libzip.

#include <burin/base/error.h>
#include <burin/converters/fcstd_reader.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>
#include <burin_test/command.h>
#include <burin_test/shapes.h>
#include <fmt/format.h>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <gtest/gtest.h>
#include <zip.h>

#include <bit>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace burin::test {

/// A box from the origin to `size`, at `offset` by its location.
inline TopoDS_Shape located_box(Vec3 size, Vec3 offset) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(offset.x, offset.y, offset.z));
  return BRepPrimAPI_MakeBox(size.x, size.y, size.z).Shape().Located(TopLoc_Location(move));
}

inline std::string brep_text(const TopoDS_Shape& shape) {
  std::ostringstream out;
  BRepTools::Write(shape, out);
  return out.str();
}

template <class T>
void put(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.begin(), raw.end());
}

/// FreeCAD's binary mesh.
inline std::string bms(const TriMesh& mesh) {
  std::string out;
  put<std::uint32_t>(out, 0xA0B0C0D0);
  put<std::uint32_t>(out, 0x010000);
  out += std::string(256, '-');
  put(out, static_cast<std::uint32_t>(mesh.positions.size()));
  put(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Vec3& p : mesh.positions) {
    for (int i = 0; i < 3; ++i) put(out, static_cast<float>(p[i]));
  }
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) put(out, static_cast<std::uint32_t>(t[i]));
    for (int i = 0; i < 3; ++i) put(out, std::uint32_t{0xffffffff});
  }
  return out;
}

inline std::string property(const std::string& name, const std::string& value) {
  return fmt::format("<Property name=\"{}\" type=\"x\">{}</Property>\n", name, value);
}
inline std::string text_property(const std::string& name, const std::string& value) {
  return property(name, fmt::format("<String value=\"{}\"/>", value));
}
inline std::string link_list(const std::string& name, const std::vector<std::string>& to) {
  std::string links;
  for (const std::string& t : to) links += fmt::format("<Link value=\"{}\"/>", t);
  return property(name, fmt::format("<LinkList count=\"{}\">{}</LinkList>", to.size(), links));
}
inline std::string group(const std::vector<std::string>& to) { return link_list("Group", to); }
inline std::string placed(Vec3 p, const std::string& name = "Placement", Vec3 axis = {0, 0, 1},
                          double degrees = 0) {
  const double half = degrees * kPi / 360;
  const Vec3 q = std::sin(half) * axis;
  return property(name, fmt::format("<PropertyPlacement Px=\"{}\" Py=\"{}\" Pz=\"{}\" Q0=\"{}\" "
                                    "Q1=\"{}\" Q2=\"{}\" Q3=\"{}\"/>",
                                    p.x, p.y, p.z, q.x, q.y, q.z, std::cos(half)));
}
inline std::string hidden() { return text_property("Visibility", "false"); }
inline std::string linked(const std::string& object, const std::string& file = "",
                          const std::string& sub = "") {
  return property("LinkedObject",
                  fmt::format("<XLink file=\"{}\" stamp=\"\" name=\"{}\" {}/>", file, object,
                              sub.empty() ? "" : "sub=\"" + sub + "\""));
}

inline std::string label(const std::string& text) { return text_property("Label", text); }
inline std::string link_property(const std::string& name, const std::string& to) {
  return property(name, "<Link value=\"" + to + "\"/>");
}
inline std::string integer(const std::string& name, int value) {
  return property(name, fmt::format("<Integer value=\"{}\"/>", value));
}
inline std::string proxy(const std::string& module, const std::string& name) {
  return property("Proxy",
                  fmt::format("<Python value=\"x\" module=\"{}\" class=\"{}\"/>", module, name));
}
inline std::string scaled(Vec3 s) {
  return property(
      "ScaleVector",
      fmt::format("<PropertyVector valueX=\"{}\" valueY=\"{}\" valueZ=\"{}\"/>", s.x, s.y, s.z));
}
/// A member with places that differ by their offsets.
inline std::string place_list(const std::vector<Vec3>& offsets) {
  std::string list;
  put(list, static_cast<std::uint32_t>(offsets.size()));
  for (const Vec3& p : offsets) {
    for (const double v : {p.x, p.y, p.z, 0.0, 0.0, 0.0, 1.0}) put(list, v);
  }
  return list;
}

/// A document under construction.
class Document {
 public:
  /// `extension` is one that a Python object has been given: "App::LinkExtensionPython".
  void add(const std::string& type, const std::string& name, const std::string& properties = "",
           const std::string& extension = "") {
    objects_ += fmt::format("<Object type=\"{}\" name=\"{}\" id=\"1\"/>\n", type, name);
    const std::string extensions = extension.empty()
                                       ? ""
                                       : fmt::format(
                                             "<Extensions Count=\"1\"><Extension type=\"{}\" "
                                             "name=\"x\"></Extension></Extensions>",
                                             extension);
    data_ += fmt::format("<Object name=\"{}\">{}<Properties Count=\"1\">{}</Properties></Object>\n",
                         name, extensions, properties);
  }
  void add_shape(const std::string& name, const TopoDS_Shape& shape,
                 const std::string& properties = "", const std::string& type = "Part::Feature") {
    const std::string member = "PartShape" + name + ".brp";
    members.emplace_back(member, brep_text(shape));
    add(type, name, property("Shape", "<Part file=\"" + member + "\"/>") + properties);
  }
  /// A view provider.
  void view(const std::string& name, const std::string& properties) {
    views_ += fmt::format(
        "<ViewProvider name=\"{}\"><Properties Count=\"1\">{}</Properties></ViewProvider>\n", name,
        properties);
  }
  std::string xml() const {
    return "<?xml version='1.0' encoding='utf-8'?>\n<Document SchemaVersion=\"4\" "
           "ProgramVersion=\"0.20R29177 (Git)\" FileVersion=\"1\">\n<Objects Count=\"1\">\n" +
           objects_ + "</Objects>\n<ObjectData Count=\"1\">\n" + data_ +
           "</ObjectData>\n</Document>\n";
  }
  std::string bytes() const {
    std::vector<std::pair<std::string, std::string>> all = {{"Document.xml", xml()}};
    if (!views_.empty()) {
      all.emplace_back("GuiDocument.xml",
                       "<?xml version='1.0'?>\n<Document SchemaVersion=\"1\"><ViewProviderData "
                       "Count=\"1\">" +
                           views_ + "</ViewProviderData></Document>\n");
    }
    all.insert(all.end(), members.begin(), members.end());
    return zipped(all);
  }
  static std::string zipped(const std::vector<std::pair<std::string, std::string>>& members) {
    const Folder folder;
    int error = 0;
    zip_t* archive = zip_open((folder / "a.zip").c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    for (const auto& [name, bytes] : members) {
      zip_file_add(archive, name.c_str(), zip_source_buffer(archive, bytes.data(), bytes.size(), 0),
                   0);
    }
    zip_close(archive);
    return slurp(folder / "a.zip");
  }

  std::vector<std::pair<std::string, std::string>> members;

 private:
  std::string objects_, data_, views_;
};

class FcstdTest : public ::testing::Test {
 protected:
  Scene read_bytes(const std::string& bytes, const FcstdOptions& options = {},
                   const std::string& name = "a.FCStd") {
    RunContext context;
    return read_fcstd(folder_.write(name, bytes), options, context);
  }
  Scene read(const Document& document, const FcstdOptions& options = {}) {
    return read_bytes(document.bytes(), options);
  }
  std::string error_of(const std::string& bytes, const FcstdOptions& options = {}) {
    try {
      read_bytes(bytes, options);
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      return e.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return {};
  }

  Folder folder_;
};

inline Box3 box_of(const Part& part) { return part.form->bounds(Mat3(1)); }
inline void expect_box(const Part& part, Vec3 min, Vec3 max) {
  const Box3 box = box_of(part);
  EXPECT_LT(glm::length(box.min - min) + glm::length(box.max - max), 1e-9)
      << fmt::format("{}: {} {} {} to {} {} {}", part.name, box.min.x, box.min.y, box.min.z,
                     box.max.x, box.max.y, box.max.z);
}
/// "Assembly/Sub/Name" of each part.
inline std::vector<std::string> paths(const Scene& scene) {
  std::vector<std::string> out;
  for (const Part& part : scene.parts) {
    std::string path;
    for (const std::string& name : part.assembly) path += name + "/";
    out.push_back(path + part.name);
  }
  return out;
}
inline bool has(const Scene& scene, const std::string& code, const std::string& words) {
  for (const Diagnostic& d : scene.diagnostics.entries()) {
    if (d.code == code && d.message.find(words) != std::string::npos) return true;
  }
  return false;
}
/// What each part is an instance of.
inline std::vector<std::string> definitions(const Scene& scene) {
  std::vector<std::string> out;
  for (const Part& part : scene.parts) out.push_back(part.definition);
  return out;
}
inline bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

using Paths = std::vector<std::string>;

}  // namespace burin::test
