#include "formats.h"
#include "groups.h"
#include "text.h"

#include <fmt/format.h>

#include <unordered_map>

// Own code: OpenMesh reads the corners as floats, and none of the libraries at hand keeps the names
// of several solids.
namespace burin {
namespace {

class StlTextReader {
 public:
  explicit StlTextReader(const Source& source) : source_(source), text_(source) {}
  MeshFile read();

 private:
  void word();
  void solid();
  void facet();
  void loop();
  bool at_word(std::string_view lower);
  [[noreturn]] void truncated(const char* inside) const;

  const Source& source_;
  TextCursor text_;
  GroupedFaces faces_;
  std::unordered_map<std::string, std::uint32_t> names_;
  std::uint32_t group_ = kNoGroup;
  std::int64_t short_loops_ = 0;
  bool in_solid_ = false;
};

void StlTextReader::truncated(const char* inside) const {
  text_.fail(fmt::format("the file ends inside {}; it is truncated, export it again", inside));
}

/// Whether the text goes on with this word, in any case; if so it is skipped.
bool StlTextReader::at_word(std::string_view lower) {
  if (text_.left() < lower.size()) return false;
  const char* p = text_.where();
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if ((p[i] | 0x20) != lower[i]) return false;
  }
  const char after = p[lower.size()];
  if (after != '\0' && !is_blank(after) && !is_line_end(after)) return false;
  text_.skip(lower.size());
  return true;
}

void StlTextReader::solid() {
  const std::string name(text_.rest_of_line());
  const auto next = static_cast<std::uint32_t>(faces_.names.size());
  in_solid_ = true;
  if (!name.empty()) {  // a name that comes again goes on with its solid
    const auto [entry, is_new] = names_.try_emplace(name, next);
    group_ = entry->second;
    if (!is_new) return;
  }
  group_ = next;
  faces_.names.push_back(name);
}

void StlTextReader::facet() {
  // The normal follows from the corners; what stands in the file is often 0 or NaN.
  for (;;) {
    text_.skip_space();
    if (text_.at_end()) truncated("a facet");
    if (at_word("outer")) break;
    if (at_word("endfacet")) return;
    text_.token();
  }
  text_.skip_space();
  if (!at_word("loop"))
    text_.fail("'loop' should follow 'outer'; the file is damaged, export it again");
  loop();
}

void StlTextReader::loop() {
  const std::size_t begin = faces_.positions.size();
  for (;;) {
    text_.skip_space();
    if (at_word("vertex")) {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        text_.skip_space();
        p[i] = text_.number("a coordinate");
      }
      faces_.positions.push_back(p);
    } else if (at_word("endloop")) {
      break;
    } else if (text_.at_end()) {
      truncated("a facet");
    } else {
      text_.fail(in_quotes(text_.token()) +
                 " stands where 'vertex' or 'endloop' should; the file is damaged, "
                 "export it again");
    }
  }
  if (faces_.positions.size() - begin < 3) {
    faces_.positions.resize(begin);
    ++short_loops_;
    return;
  }
  if (faces_.positions.size() >= kNoGroup)
    text_.fail("more than 4,294,967,294 corners; split the model");
  for (std::size_t i = begin; i < faces_.positions.size(); ++i) {
    faces_.indices.push_back(static_cast<std::uint32_t>(i));
  }
  faces_.offsets.push_back(faces_.indices.size());
  faces_.group.push_back(group_);
}

void StlTextReader::word() {
  if (at_word("facet")) return facet();
  if (at_word("endfacet")) return;
  if (at_word("outer")) {  // one more loop of a facet
    text_.skip_space();
    if (at_word("loop")) return loop();
  }
  if (at_word("solid")) return solid();
  if (at_word("endsolid")) {
    in_solid_ = false;
    group_ = kNoGroup;
    text_.next_line();
    return;
  }
  if (at_word("color")) return text_.next_line();
  text_.fail(in_quotes(text_.token()) +
             " is no word of an ASCII STL; the file is damaged, export it again");
}

MeshFile StlTextReader::read() {
  for (text_.skip_space(); !text_.at_end(); text_.skip_space()) {
    source_.context().check();
    word();
  }
  if (faces_.group.empty()) source_.fail("the ASCII STL holds no triangles; export it again");
  MeshFile file;
  file.format = "STL (ASCII)";
  if (in_solid_) {
    file.diagnostics.add(Severity::Warning, "stl.no_endsolid", 1,
                         "the ASCII STL ends without 'endsolid'; it may be truncated");
  }
  if (short_loops_ > 0) {
    file.diagnostics.add(Severity::Warning, "stl.short_loops", short_loops_,
                         "facets of fewer than three corners were left out");
  }
  faces_.join_connected = true;
  file.objects = split_groups(std::move(faces_), file.diagnostics, source_.context());
  return file;
}

}  // namespace

MeshFile read_stl_ascii(const Source& source) { return StlTextReader(source).read(); }

}  // namespace burin
