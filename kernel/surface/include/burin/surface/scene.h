#pragma once
/// What is drawn: named parts, each with a form that can be realised as a surface.

#include <burin/base/box.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/surface/face_colors.h>
#include <burin/surface/pmi.h>
#include <burin/surface/shape_measure.h>
#include <burin/surface/surface.h>
#include <burin/surface/thread.h>

#include <memory>
#include <string>
#include <vector>

namespace burin {

/// How a form is to be turned into a surface.
struct RealiseOptions {
  /// Chord tolerance of any tessellation in model mm.
  double tolerance = 0.01;
  /// Degrees between neighbouring triangles from which an edge of a mesh is sharp.
  double crease_angle = 30;
  /// Whether principal curvatures are needed.
  bool curvature = true;
  /// The view that is to be drawn. Exact forms cut their proxies along its contours; meshes need
  /// none. Absent = no cuts. Read during `realise` only.
  const Camera* view = nullptr;
  /// Faces that cannot be realised are named here; absent = they are not reported.
  Diagnostics* diagnostics = nullptr;
};

class Form;

/// What `Form::measure` gives where a form knows no better. Not a member: a class of which each
/// function stands in a header has no home that two libraries could both claim.
ShapeMeasure measure_realised(const Form& form, RunContext& context);

/// The plain description of a shape as it was read; cheap to keep, no acceleration structures.
class Form {
 public:
  Form() = default;
  Form(const Form&) = delete;
  Form& operator=(const Form&) = delete;
  virtual ~Form() = default;

  /// The box of `axes * p` over all points p of the form: bounds along the rows of `axes`, which
  /// need be neither unit nor orthogonal (the identity: model axes).
  virtual Box3 bounds(const Mat3& axes) const = 0;
  /// Builds the surface. Stages "build" (connectivity, creases, normals) and "curvature" are timed
  /// on `context`.
  virtual std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                                 RunContext& context) const = 0;
  /// The same shape with its points taken elsewhere by any placement that is invertible: turned,
  /// mirrored, stretched or sheared. It is what the shape becomes, with true normals and
  /// curvatures: a stretched cylinder is freeform, a plane stays plane. Nothing where the form
  /// cannot tell; all that readers make can. `Placer` shares what it can and is what to ask for.
  virtual std::shared_ptr<const Form> mapped(const Placement& /*by*/) const { return nullptr; }
  /// Whether `RealiseOptions::view` changes what is realised.
  virtual bool looks_at_view() const { return true; }
  /// Whether both are sure to be realised as the same surface: one form, or one that was placed or
  /// cut the same way twice. False proves nothing.
  virtual bool same_as(const Form& other) const { return this == &other; }

  /// What the form is an instance of; by itself, where nothing else is known.
  virtual Definition definition() const { return {.shape = this}; }
  /// What tells its shape from others, wherever it stands. The default realises the form to a
  /// thousandth of its size and measures the triangles; forms that know better do better. Throws as
  /// `realise`. Cost: that of `realise`.
  virtual ShapeMeasure measure(RunContext& context) const {
    return measure_realised(*this, context);
  }
  /// Whether `realise` may run beside that of any other form which says so too. What the form is
  /// an instance of (`definition`) is realised by one thread at a time all the same.
  virtual bool realised_beside_others() const { return false; }
};

/// One of several bodies that a part holds, such as a solid of a product.
struct Piece {
  /// Of no other piece of its part: "solid 2".
  std::string name;
  std::shared_ptr<const Form> form;
  /// As those of a part.
  std::string color = {};
  double opacity = 1;
  std::shared_ptr<const FaceColors> face_colors = {};
};

struct Part {
  std::string name;
  /// The file the part came from, as the user named it.
  std::string source;
  std::shared_ptr<const Form> form;
  /// Names from the top of an assembly down to what contains this part; empty outside assemblies.
  std::vector<std::string> assembly = {};
  /// "#rrggbb" where the input gives the part a colour, else empty. Where faces have colours of
  /// their own, that of most of its area.
  std::string color = {};
  /// The name of what this is an instance of, where the input has one beside that of the instance.
  std::string definition = {};
  /// How much of what lies behind it the part covers, as the input says: 1 all of it, 0 nothing.
  double opacity = 1;
  /// Of faces that are coloured otherwise than the part; absent: none is.
  std::shared_ptr<const FaceColors> face_colors = {};
  /// The bodies that `form` is made of, where there are several that can be chosen one by one
  /// (`split_pieces` of burin/assembly/pieces.h); they stand where the part stands.
  std::vector<Piece> pieces = {};
  /// Whether this is one thing with the part before it, told from it by its look alone, such as
  /// what a module of OpenSCAD makes in a second colour: a parts list counts them once, and nothing
  /// takes them apart.
  bool joined = false;
  /// Which of the shapes this is that the input calls the same, from 0, where that was asked: each
  /// has a colour of its own.
  std::size_t shape_of_name = 0;
  /// What an illustration calls the item that this is of (`ItemNumbers`); empty: as the input does.
  std::string item_name = {};
  /// What this is one body of, where a part was split into its bodies: shared by all of them, so
  /// that lists count one part. Absent: this is a part by itself.
  std::shared_ptr<const Part> whole = {};
  /// The form of a plug-in that made it, by its name; empty: none did. Where it fails, all parts
  /// that it made are left out.
  std::string plugin_form = {};
  /// Its screw threads that are no part of its form, by what the input says of them.
  std::vector<Thread> threads = {};
  /// Its dimensions, tolerances, datums and notes, where the input has some and they were asked
  /// for.
  PlacedPmi pmi = {};
};

/// Parts in the order of the input, with what the readers mended or left out.
struct Scene {
  std::vector<Part> parts;
  Diagnostics diagnostics;

  Box3 bounds(const Mat3& axes = Mat3(1)) const;
};

}  // namespace burin
