#include <burin/base/error.h>
#include <burin/base/input_name.h>

#include "cad_file.h"
#include "collect.h"
#include "occt_session.h"
#include "text.h"

#include <IGESCAFControl_Reader.hxx>
#include <TDocStd_Document.hxx>

namespace burin {

CadFile read_iges(const Source& source, RunContext& context) {
  IGESCAFControl_Reader reader;
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  const IFSelect_ReturnStatus status = reader.ReadFile(source.file().c_str());
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
    const std::string stem = clean_name(model_stem(source.file()));
    file.parts = collect_parts(document, stem, file.diagnostics, context);
  }
  return file;
}

}  // namespace burin
