#pragma once
/// What a model file holds: its parts, and what it asks of the drawing of them.

#include <burin/base/vec.h>
#include <burin/surface/scene.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin {

/// What marks in a model ask of its drawing: the words of burin.scad, the modifiers of OpenSCAD.
struct ModelMarks {
  /// How a part is drawn, where that differs from the others.
  struct Look {
    /// Its path.
    std::string part;
    bool hatched = true, transparent = false, listed = true;
    /// Absent: that of the drawing.
    std::optional<std::string> style = {};
  };
  /// Parts that come apart together.
  struct Step {
    std::vector<std::string> parts;
    /// The way and how far, model mm.
    Vec3 move{0};
  };
  /// A thread of a part, as an illustration has them.
  struct Thread {
    /// Its path.
    std::string part;
    std::string size = {};
    std::optional<double> length = {};
  };
  /// Words beside the drawing, with a leader to a part.
  struct Note {
    /// Its path.
    std::string part;
    std::string text;
  };
  /// An arrow before a part, the way that it moves.
  struct Arrow {
    /// Its path.
    std::string part;
    Vec3 along{0};
  };
  /// The file, for errors.
  std::string source = {};
  std::vector<Look> looks = {};
  std::vector<Step> steps = {};
  std::vector<Thread> threads = {};
  std::vector<Note> notes = {};
  std::vector<Arrow> arrows = {};
  bool callouts = false;
  /// Numbers as they are asked for, and the part that each is for; of equal ones the first holds.
  std::vector<std::pair<double, std::string>> items = {};
  /// As the options `view` and `up` take them.
  std::optional<std::string> view = {}, up = {};

  bool empty() const {
    return looks.empty() && steps.empty() && threads.empty() && notes.empty() && arrows.empty() &&
           !callouts && items.empty() && !view && !up;
  }
};

struct ReadResult {
  Scene scene;
  /// Of each file that has some, in the order of the files. Whoever draws decides whether to follow
  /// them.
  std::vector<ModelMarks> marks = {};
};

}  // namespace burin
