#pragma once
/// A CAD file as it stands: shapes in their places, before they become forms.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/converters/cad_reader.h>
#include <burin/forms/charted/chart.h>
#include <burin/surface/face_colors.h>
#include <burin/surface/pmi.h>

#include "look.h"
#include "source.h"

#include <TopoDS_Shape.hxx>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace burin {

class OcctSession;

/// A solid of a product, a shell outside solids, or what faces outside shells sew into.
struct CadBody {
  /// "solid 2", counted in its product; "solid 2 (housing)" where somebody named it.
  std::string name;
  /// Where it stands in the product.
  TopoDS_Shape shape;
  /// The faces as the file has them, of what was sewn; else none.
  std::vector<TopoDS_Shape> sewn_from = {};
};

/// The faces of a body that has several colours, in the order of TopExp::MapShapes.
struct CadFaces {
  /// Without a colour: that of the body.
  std::vector<Appearance> color;
  /// In the square of the file's unit.
  std::vector<double> area;
};

/// A part with the colours of its faces; absent where all look like it. What is of glass as a
/// whole, or has no other faces, is of glass.
struct CadPaint {
  Appearance look;
  std::shared_ptr<const FaceColors> faces;
};

struct CadPart {
  std::string name;
  std::vector<std::string> assembly;
  /// The name of the product that it is an instance of; empty where that says nothing.
  std::string definition = {};
  /// What it is made of, shared by all instances; at least one body.
  std::shared_ptr<const std::vector<CadBody>> bodies;
  /// Of each body.
  std::vector<Appearance> colors;
  /// Of each body; none where all bodies of the part have one colour and no face has another.
  std::shared_ptr<const std::vector<CadFaces>> faces = {};
  Placement placement;
  /// Shared by instances; none where there is nothing, or it was not asked for.
  std::shared_ptr<const Pmi> pmi = {};

  /// The one that all bodies have, else none.
  Appearance color() const;
  /// The colours of some bodies and of their faces, which are numbered through.
  CadPaint painted(const std::vector<std::size_t>& of) const;
  /// The same of the body `of[only]` alone, whose faces have the numbers that they have there.
  CadPaint painted(const std::vector<std::size_t>& of, std::size_t only) const;
};

struct CadFile {
  std::string format, schema;
  std::vector<CadPart> parts;
  Diagnostics diagnostics;
};

/// By content, else by suffix. Throws InputError; nothing of OCCT gets out.
CadFile read_cad_file(const std::filesystem::path& path, const CadReadOptions& options,
                      const OcctSession& session, RunContext& context);

/// One reader a format, to be called inside `guarded`.
CadFile read_step(const Source& source, const CadReadOptions& options, const OcctSession& session,
                  RunContext& context);
CadFile read_iges(const Source& source, const std::string& encoding, RunContext& context);
CadFile read_brep(const Source& source, bool binary, RunContext& context);

}  // namespace burin
