#pragma once
/// CAD files: STEP (AP203, AP214, AP242), IGES, BREP.

#include <burin/base/run_context.h>
#include <burin/converters/file_info.h>
#include <burin/forms/charted/chart.h>
#include <burin/surface/scene.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Whether the suffix (any case) is one of this reader's: .step .stp .p21 .iges .igs .brep .brp.
bool is_cad_suffix(const std::filesystem::path& path);

/// Whether the first bytes of a file can only be a CAD file's, whatever it is called.
bool is_cad_content(std::string_view head);

struct CadReadOptions {
  /// Of names that a file does not say it of, as iconv knows it; empty: it is found out.
  std::string encoding = {};
  /// Whether `Part::pmi` has the dimensions, tolerances, datums and notes of STEP files. Cost: one
  /// more walk over the text, a fortieth of the time of reading.
  bool pmi = false;
};

/// One part for each leaf of the assembly, whatever number of solids, free shells and what free
/// faces sew into it has (`Part::pieces`, where these are several), in the order of the file, with
/// name, path in the assembly, colour, opacity and placement; instances share one shape.
/// Lengths in mm whatever the file's unit. An exception of OCCT, or a signal raised in it, ends in
/// an InputError that names the file and what to do; what could not be read of a file that holds
/// more becomes a diagnostic. Progress and cancel as far as OCCT allows: converters/cad/README.md
/// says where it does not. Lives in a library of its own (libburin_cad), which is loaded when the
/// first CAD file is read: OCCT's exchange libraries take 65 ms to load. From several threads one
/// file is read at a time, for OCCT's readers share state.
Scene read_cad(const std::filesystem::path& path, RunContext& context,
               const CadReadOptions& options = {});

/// Reads and measures: counts, areas and volumes of the exact surfaces, which parts share a shape.
/// Throws InputError as `read_cad` does.
FileInfo inspect_cad(const std::filesystem::path& path, RunContext& context,
                     const CadReadOptions& options = {});

/// A shape in memory, as OCCT writes it in text or binary, in its place (a rigid motion, a mirror
/// among them): one part without a name, whatever its solids, its faces and edges numbered from 0
/// in the order of TopExp::MapShapes. Throws InputError where the text is broken, GeometryError
/// where the shape has no face. Cost: 1 to 15 ms, and once a process 60 ms to load the library.
Part read_brep_text(const std::string& brep, const Placement& placement, RunContext& context);

/// A shape in memory, read once and placed as often as wanted.
class BrepShape {
 public:
  BrepShape() = default;
  BrepShape(const BrepShape&) = delete;
  BrepShape& operator=(const BrepShape&) = delete;
  virtual ~BrepShape() = default;

  /// The location that the shape itself carries. The functions below leave it out.
  virtual const Placement& own() const = 0;
  /// The shape at `placement`, which may turn, mirror, stretch and shear, but not flatten; faces
  /// and edges numbered as `read_brep_text` does. All forms share one model.
  virtual std::shared_ptr<const Form> form(const Placement& placement) const = 0;
  /// Counts and measures at `placement`; no name.
  virtual PartInfo measure(const Placement& placement) const = 0;
  /// Of each face in turn, in square mm; 0 where OCCT cannot tell. Cost: 0.1 ms a face.
  virtual std::vector<double> face_areas() const = 0;
  /// Whether OCCT finds nothing wrong with the shape (BRepCheck_Analyzer); a check that crashes is
  /// no. Slow, for messages: about 0.25 ms per face.
  virtual bool valid() const = 0;
};

/// As `read_brep_text`, to be placed as often as it is wanted; `own` is the identity.
std::shared_ptr<const BrepShape> read_brep_text(const std::string& brep, RunContext& context);

/// Occt: BREP as OCCT writes it, text or binary. FreecadBinary: what FreeCAD's exportBinary and
/// its documents hold, which lacks OCCT's header and ends in another way.
enum class BrepBytes { Occt, FreecadBinary };

/// Throws InputError where the bytes are broken, GeometryError where the shape has no face.
std::shared_ptr<const BrepShape> read_brep_shape(const std::string& bytes, BrepBytes kind,
                                                 RunContext& context);

}  // namespace burin
