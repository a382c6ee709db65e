#include <burin/base/error.h>

#include "cad_file.h"
#include "collect.h"
#include "occt_session.h"
#include "text.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <streambuf>

namespace burin {
namespace {

// Share of the time that goes into parsing; the rest is translation.
constexpr double kParsing = 0.3;

/// Hands a text out in pieces, and ends it early once the run is cancelled: the one way to stop
/// OCCT's parser.
class PolledText : public std::streambuf {
 public:
  PolledText(std::string_view text, RunContext& context) : text_(text), context_(context) {}

 protected:
  int_type underflow() override {
    constexpr std::size_t kPiece = 1u << 16;
    at_ += static_cast<std::size_t>(egptr() - eback());
    if (context_.cancelled() || at_ >= text_.size()) return traits_type::eof();
    context_.progress(kParsing * static_cast<double>(at_) / static_cast<double>(text_.size()));
    char* begin = const_cast<char*>(text_.data()) + at_;  // never written to
    setg(begin, begin, begin + std::min(kPiece, text_.size() - at_));
    return traits_type::to_int_type(*begin);
  }

 private:
  std::string_view text_;
  RunContext& context_;
  std::size_t at_ = 0;
};

void parse(STEPCAFControl_Reader& reader, std::string_view text, const Source& source,
           RunContext& context) {
  PolledText buffer(text, context);
  std::istream in(&buffer);
  const IFSelect_ReturnStatus status = reader.ChangeReader().ReadStream(source.file().c_str(), in);
  context.check();
  if (status != IFSelect_RetDone) {
    source.fail("is broken or no STEP file: OCCT cannot parse it; export the model again");
  }
}

std::string schema_of(STEPCAFControl_Reader& reader) {
  const APIHeaderSection_MakeHeader header(reader.ChangeReader().StepModel());
  if (!header.HasFs() || header.NbSchemaIdentifiers() < 1) return {};
  const Handle(TCollection_HAsciiString) name = header.SchemaIdentifiersValue(1);
  return name.IsNull() ? std::string() : clean_name(name->ToCString());
}

std::string protocol_of(const std::string& schema) {
  if (schema.starts_with("CONFIG_CONTROL_DESIGN")) return "STEP (AP203)";
  if (schema.starts_with("AP203")) return "STEP (AP203)";
  if (schema.starts_with("AUTOMOTIVE_DESIGN")) return "STEP (AP214)";
  if (schema.starts_with("AP242")) return "STEP (AP242)";
  return "STEP";
}

/// Entities that OCCT says it failed at.
void add_failures(STEPCAFControl_Reader& reader, Diagnostics& diagnostics) {
  const Handle(Transfer_TransientProcess) process =
      reader.Reader().WS()->TransferReader()->TransientProcess();
  if (process.IsNull()) return;
  std::int64_t failures = 0;
  std::string first;
  Interface_CheckIterator checks = process->CheckList(Standard_False);
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check)& check = checks.Value();
    if (!check->HasFailed()) continue;
    if (failures++ == 0) first = clean_name(check->CFail(1));
  }
  if (failures == 0) return;
  diagnostics.add(Severity::Warning, "step.not_translated", failures,
                  fmt::format("entities could not be translated, the first because: {}", first));
}

}  // namespace

CadFile read_step(const Source& source, RunContext& context) {
  STEPCAFControl_Reader reader;
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  reader.SetPropsMode(Standard_False);
  reader.SetGDTMode(Standard_False);
  reader.SetMatMode(Standard_False);
  reader.SetViewMode(Standard_False);
  parse(reader, source.bytes(), source, context);

  CadFile file;
  file.schema = schema_of(reader);
  file.format = protocol_of(file.schema);
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(OcctProgress) progress = new OcctProgress(context, kParsing, 1);
  const bool done = reader.Transfer(document, progress->Start());
  context.check();
  add_failures(reader, file.diagnostics);
  if (done) {
    const std::string stem = clean_name(std::filesystem::path(source.file()).stem().string());
    file.parts = collect_parts(document, stem, file.diagnostics, context);
  }
  return file;
}

}  // namespace burin
