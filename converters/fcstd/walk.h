#pragma once
// From the tree of a document to the shapes that stand in space; internal to the module.

#include <burin/base/diagnostics.h>

#include "document.h"
#include "left_out.h"

#include <map>
#include <memory>
#include <optional>
#include <set>

namespace burin::detail {

/// Links inside links multiply: a few lines can ask for 2^60 shapes.
inline constexpr std::size_t kMostVisits = 200'000;

/// One shape or mesh in one place.
struct FcUse {
  const FcDocument* document = nullptr;
  const FcObject* object = nullptr;
  /// `object` again, or a feature with the shape of a body that has none of its own.
  const FcObject* shape = nullptr;
  /// Applied after the object's own placement where `own`, else in its stead.
  Placement placement;
  bool own = true;
  std::string name = {};
  /// The name of what this is an instance of: the same for an object and all links to it.
  std::string definition = {};
  /// Whether it has that name from a link, as the object's own label says nothing.
  bool named_by_link = false;
  /// What the link to it is called, where it says that and links to nothing else.
  std::string link = {};
  FcLook look = {};
  std::vector<std::string> assembly = {};
};

/// The documents that a walk has opened, each once.
class FcDocuments {
 public:
  explicit FcDocuments(const RunContext& context) : context_(context) {}
  const FcDocument& open(const std::filesystem::path& path, const std::filesystem::path& copy = {});

 private:
  const RunContext& context_;
  std::map<std::filesystem::path, std::unique_ptr<FcDocument>> open_;
};

class FcWalk {
 public:
  FcWalk(FcDocuments& documents, const FcDocument& root, const RunContext& context);

  /// Everything that is visible.
  void visible();
  /// Objects by their names or labels. Throws InputError that names the nearest.
  void chosen(const std::vector<std::string>& names);

  std::vector<FcUse> uses;
  Diagnostics diagnostics;
  LeftOut left_out;

 private:
  struct Place {
    Placement placement;
    /// Whether the object's own placement applies.
    bool own = true;
    /// Whether it is shown whatever its own visibility.
    bool shown = false;
    /// Whether a user named it.
    bool named = false;
    std::vector<std::string> assembly;
    /// Of the outermost link that leads here.
    std::string alias;
    /// Of the outermost link that replaces that of what it links to.
    std::optional<FcLook> look;
    /// What the nearest link that leads here is called, where that says something.
    std::string given;
    /// Whether that link leads to nothing else.
    bool alone = true;
  };
  struct Target {
    const FcDocument* document = nullptr;
    std::int32_t object = -1;
    Placement before;
    /// Whether `object` lies below the one that the link names first.
    bool below = false;
  };

  void visit(const FcDocument& document, std::int32_t number, const Place& place);
  void visit_here(const FcDocument& document, const FcObject& object, const Place& place);
  void members(const FcDocument& document, const FcObject& object, const Place& place);
  void link_group(const FcDocument& document, const FcObject& object, const Place& place);
  void link(const FcDocument& document, const FcObject& object, const Place& place);
  void elements(const FcDocument& document, const FcObject& object, const Place& place);
  void array(const FcDocument& document, const FcObject& object, const Target& target,
             const Place& place);
  void leaf(const FcDocument& document, const FcObject& object, const Place& place);
  void define(FcUse& use, const Place& place) const;
  bool find_target(const FcDocument& document, const FcObject& object, Target& target);
  static bool descend(const std::string& sub, bool transform, Target& target);
  void find_parents();
  Place place_of(std::int32_t number) const;
  void note(const char* code, const std::string& message);
  void lost_member(const FcObject& object, const std::string& name);

  FcDocuments& documents_;
  const FcDocument& root_;
  const RunContext& context_;
  /// Of the objects of the root document; -1 = none.
  std::vector<std::int32_t> parent_;
  std::vector<std::int32_t> roots_;
  std::vector<const FcObject*> path_;
  std::set<std::string> noted_;
  LeftOut broken_links_;
  std::size_t visits_ = 0;
};

}  // namespace burin::detail
