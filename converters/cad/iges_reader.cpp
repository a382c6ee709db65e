#include <burin/base/error.h>
#include <burin/base/input_name.h>
#include <burin/base/platform.h>
#include <burin/base/subprocess.h>

#include "cad_file.h"
#include "collect.h"
#include "encoding.h"
#include "iges_names.h"
#include "occt_session.h"
#include "text.h"

#include <IGESCAFControl_Reader.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>

#include <algorithm>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Names of IGES are bytes, which OCCT takes for letters of Latin-1.
std::string bytes_of(const TCollection_ExtendedString& name) {
  std::string bytes;
  for (int i = 1; i <= name.Length(); ++i) {
    if (name.Value(i) > 0xff) return {};
    bytes += static_cast<char>(name.Value(i));
  }
  return bytes;
}

/// Makes UTF-8 of the names of a document; those of members, which it lacks, are returned.
ShapeNames decode_names(const Handle(TDocStd_Document) & document,
                        const std::vector<std::pair<TopoDS_Shape, std::string>>& members,
                        const std::string& encoding, Diagnostics& diagnostics) {
  std::vector<std::pair<Handle(TDataStd_Name), std::string>> names;
  TextDecoder decoder(encoding);
  for (TDF_ChildIterator it(document->Main(), Standard_True); it.More(); it.Next()) {
    Handle(TDataStd_Name) name;
    if (!it.Value().FindAttribute(TDataStd_Name::GetID(), name)) continue;
    names.emplace_back(name, bytes_of(name->Get()));
    decoder.learn(names.back().second);
  }
  for (const auto& [shape, bytes] : members) decoder.learn(bytes);
  for (const auto& [name, bytes] : names) {
    if (bytes.empty()) continue;
    name->Set(TCollection_ExtendedString(decoder.utf8(bytes).c_str(), Standard_True));
  }
  ShapeNames of_members;
  for (const auto& [shape, bytes] : members) {
    of_members.Bind(shape, clean_name(decoder.utf8(bytes)));
  }
  decoder.report(diagnostics);
  return of_members;
}

void fill(const detail::MemoryFile& file, const Source& source) {
  for (std::string_view left = source.bytes(); !left.empty();) {
    source.context().check();
    constexpr std::size_t kPiece = std::size_t{8} << 20;
    const std::string_view piece = left.substr(0, kPiece);
    if (!platform::write_all(file.descriptor(), piece)) throw std::bad_alloc();
    left.remove_prefix(piece.size());
  }
}

}  // namespace

CadFile read_iges(const Source& source, const std::string& encoding, RunContext& context) {
  IGESCAFControl_Reader reader;
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  // OCCT's reader opens a path, which does not hold what was packed or piped.
  const detail::MemoryFile bytes;
  fill(bytes, source);
  const IFSelect_ReturnStatus status = reader.ReadFile(bytes.path().c_str());
  context.check();
  if (status != IFSelect_RetDone) {
    source.fail("is broken or no IGES file: OCCT cannot parse it; export the model again");
  }
  CadFile file;
  file.format = "IGES";
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(OcctProgress) progress = new OcctProgress(context, 0.3, 1);
  const bool done = reader.Transfer(document, progress->Start());
  context.check();
  if (done) {
    const ShapeNames names =
        decode_names(document, named_members(reader), encoding, file.diagnostics);
    const std::string stem = clean_name(model_stem(source.file()));
    file.parts =
        collect_parts(document, {Roots::Entities, stem, {}, names}, file.diagnostics, context);
  }
  return file;
}

}  // namespace burin
