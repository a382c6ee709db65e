#include "byte_order_mark.h"
#include "formats.h"
#include "groups.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <unordered_map>

// Own code: OpenMesh reads the corners as floats, and none of the libraries at hand keeps the names
// of several solids.
namespace burin {
namespace {

class StlTextReader {
 public:
  explicit StlTextReader(const Source& source)
      : source_(source), text_(source, byte_order_mark(source.bytes())) {}
  MeshFile read();

 private:
  void word();
  void solid();
  void facet();
  void loop();
  const char* matched(const char* from, std::string_view lower) const;
  bool ends_word(const char* at) const;
  bool at_word(std::string_view lower);
  bool at_pair(std::string_view first, std::string_view second);
  bool at_facet();
  bool at_vertex();
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

/// Behind this word, in any case, where it stands at `from`; else null.
const char* StlTextReader::matched(const char* from, std::string_view lower) const {
  const char* end = text_.where() + text_.left();
  if (static_cast<std::size_t>(end - from) < lower.size()) return nullptr;
  for (const char c : lower) {
    if ((*from++ | 0x20) != c) return nullptr;
  }
  return from;
}

bool StlTextReader::ends_word(const char* at) const {
  return *at == '\0' || is_blank(*at) || is_line_end(*at);
}

/// Whether the text goes on with this word; if so it is skipped.
bool StlTextReader::at_word(std::string_view lower) {
  const char* after = matched(text_.where(), lower);
  if (after == nullptr || !ends_word(after)) return false;
  text_.skip(lower.size());
  return true;
}

/// The same of two words, which programs write as one or with blanks between them.
bool StlTextReader::at_pair(std::string_view first, std::string_view second) {
  const char* after = matched(text_.where(), first);
  if (after == nullptr) return false;
  while (is_blank(*after)) ++after;
  after = matched(after, second);
  if (after == nullptr || !ends_word(after)) return false;
  text_.skip(static_cast<std::size_t>(after - text_.where()));
  return true;
}

/// "facet", also where "normal" is glued to it.
bool StlTextReader::at_facet() {
  if (at_word("facet")) return true;
  if (matched(text_.where(), "facetnormal") == nullptr) return false;
  text_.token();
  return true;
}

/// "vertex", also where its first number is glued to it.
bool StlTextReader::at_vertex() {
  constexpr std::string_view kVertex = "vertex";
  if (at_word(kVertex)) return true;
  const char* after = matched(text_.where(), kVertex);
  if (after == nullptr || !(is_digit(*after) || *after == '-' || *after == '+' || *after == '.')) {
    return false;
  }
  text_.skip(kVertex.size());
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
    if (at_pair("outer", "loop")) return loop();
    if (at_word("outer")) {
      text_.skip_space();
      if (at_word("loop")) return loop();
      text_.fail("'loop' should follow 'outer'; the file is damaged, export it again");
    }
    if (at_pair("end", "facet")) return;
    text_.token();
  }
}

void StlTextReader::loop() {
  const std::size_t begin = faces_.positions.size();
  for (;;) {
    text_.skip_space();
    if (at_vertex()) {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        text_.skip_space();
        p[i] = text_.number("a coordinate");
      }
      faces_.positions.push_back(p);
    } else if (at_pair("end", "loop")) {
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
  if (at_facet()) return facet();
  if (at_pair("end", "facet")) return;
  if (at_pair("outer", "loop")) return loop();  // one more loop of a facet
  if (at_word("solid")) return solid();
  if (at_pair("end", "solid")) {
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
  split_groups(std::move(faces_), file, source_.context());
  // One solid is called as its file then.
  if (file.objects.size() == 1 && is_made_up(file.objects[0].name)) file.objects[0].name.clear();
  return file;
}

/// Whether a program made the name up, so that it says nothing of the model.
bool is_made_up(const std::string& name) {
  static constexpr std::string_view kWhole[] = {"openscad_model", "vcg", "default", "ascii",
                                                "mesh"};
  static constexpr std::string_view kBegin[] = {"exported from ", "exported by ", "created by ",
                                                "stl generated by ",
                                                "visualization toolkit generated"};
  const std::string low = lowered(name);
  return std::ranges::find(kWhole, low) != std::end(kWhole) ||
         std::ranges::any_of(kBegin, [&](std::string_view b) { return low.starts_with(b); });
}

}  // namespace

MeshFile read_stl_ascii(const Source& source) { return StlTextReader(source).read(); }

}  // namespace burin
