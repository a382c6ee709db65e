#include <burin/base/error.h>
#include <burin/base/input_name.h>

#include "absurd_numbers.h"
#include "byte_order_mark.h"
#include "cad_file.h"
#include "collect.h"
#include "encoding.h"
#include "entity_numbers.h"
#include "long_lists.h"
#include "occt_session.h"
#include "pmi/pmi_parts.h"
#include "pmi/step_pmi.h"
#include "pmi/step_text.h"
#include "step_external.h"
#include "step_names.h"
#include "tessellated.h"
#include "text.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRep_Tool.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
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

bool parses(STEPCAFControl_Reader& reader, std::string_view text, const Source& source,
            RunContext& context) {
  PolledText buffer(text, context);
  std::istream in(&buffer);
  const IFSelect_ReturnStatus status = reader.ChangeReader().ReadStream(source.file().c_str(), in);
  context.check();
  return status == IFSelect_RetDone;
}

/// A file that was cut off, closed after its last whole entity; empty where it was not.
std::string closed_early(std::string_view text) {
  if (text.find("END-ISO-10303-21") != std::string_view::npos) return {};
  const std::size_t data = text.find("DATA");
  const std::size_t end = text.rfind(';');
  if (data == std::string_view::npos || end == std::string_view::npos || end < data) return {};
  return std::string(text.substr(0, end + 1)) + "\nENDSEC;\nEND-ISO-10303-21;\n";
}

/// OCCT says "Line 12: what" of a fault in line 11: its scanner begins with 1 and counts the line
/// that it enters.
[[noreturn]] void fail_parsing(const Source& source, const std::string& message) {
  std::int64_t line = 0;
  std::string what = "OCCT cannot parse it";
  if (const std::size_t at = message.find("Line "); at != std::string::npos) {
    line = std::max(std::strtoll(message.c_str() + at + 5, nullptr, 10) - 1, 0ll);
    const std::size_t words = message.find(": ", at);
    if (words != std::string::npos) what = message.substr(words + 2);
    what.erase(what.find_last_not_of(" *") + 1);
  }
  throw InputError(fmt::format("is broken or no STEP file ({}); export the model again", what),
                   source.file(), line);
}

/// Where a file ends that was cut off: the line; 0: it was not.
using EndsAt = std::int64_t;

/// Reads the entities, and of a file that was cut off those before the cut. `pmi`: what it says of
/// sizes and tolerances, where that is wanted.
EndsAt parse(STEPCAFControl_Reader& reader, const Source& source, const CadReadOptions& options,
             const OcctSession& session, StepPmi& pmi, Diagnostics& diagnostics,
             RunContext& context) {
  const std::string changed = unique_entity_numbers(source, diagnostics);
  std::string_view bytes = changed.empty() ? source.bytes() : std::string_view(changed);
  bytes.remove_prefix(byte_order_mark(bytes));
  const std::string decoded = utf8_text(bytes, options.encoding, diagnostics);
  std::string_view text = decoded.empty() ? bytes : std::string_view(decoded);
  // Before lists are shortened that annotations are drawn with.
  if (options.pmi && may_have_pmi(text)) pmi = read_step_pmi(StepText(text, context));
  const std::string shortened = without_triangle_lists(text);
  if (!shortened.empty()) text = shortened;
  if (parses(reader, text, source, context)) return 0;
  const std::string message = session.first_message();
  const std::string closed = closed_early(text);
  if (closed.empty() || !parses(reader, closed, source, context)) fail_parsing(source, message);
  const EndsAt line = source.line_of(source.bytes().data() + source.bytes().size());
  diagnostics.add(Severity::Error, "step.truncated", 1,
                  fmt::format("the file ends early, in line {}; the part before it was read, the "
                              "rest is missing and parts may be out of place",
                              line));
  return line;
}

bool has_outline(const CadBody& body) {
  for (TopExp_Explorer wire(body.shape, TopAbs_WIRE); wire.More(); wire.Next()) {
    if (BRep_Tool::IsClosed(wire.Current())) return true;
  }
  return false;
}

/// Of a file that was cut off: parts of which no face kept a whole outline.
void drop_unbounded(std::vector<CadPart>& parts) {
  std::erase_if(
      parts, [](const CadPart& part) { return std::ranges::none_of(*part.bodies, has_outline); });
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

/// Counts checks that failed; the message of the first one.
class Failures {
 public:
  void add(const Handle(Interface_Check) & check) {
    if (check.IsNull() || !check->HasFailed() || is_reported_elsewhere(check->CFail(1))) return;
    if (count_++ == 0) first_ = clean_name(check->CFail(1));
  }
  void report(Diagnostics& diagnostics, Severity severity, const char* code,
              const char* what) const {
    if (count_ == 0) return;
    diagnostics.add(severity, code, count_, fmt::format("{}; the first: {}", what, first_));
  }

 private:
  /// Files that are not there are named all together (report_external).
  static bool is_reported_elsewhere(std::string_view fail) {
    return fail.starts_with("Can not read external file");
  }

  std::int64_t count_ = 0;
  std::string first_;
};

/// Entities that refer to what is not there, or that OCCT could make nothing of.
void add_failures(STEPCAFControl_Reader& reader, Diagnostics& diagnostics) {
  Failures broken, untranslated;
  const Handle(StepData_StepModel) model = reader.ChangeReader().StepModel();
  for (int i = 1; i <= model->NbEntities(); ++i) broken.add(model->Check(i, Standard_True));
  // Mostly names, styles and tolerances that no drawing needs.
  broken.report(diagnostics, Severity::Info, "step.broken_entities",
                "entities of the file are broken");
  const Handle(Transfer_TransientProcess) process =
      reader.Reader().WS()->TransferReader()->TransientProcess();
  if (process.IsNull()) return;
  Interface_CheckIterator checks = process->CheckList(Standard_False);
  for (checks.Start(); checks.More(); checks.Next()) untranslated.add(checks.Value());
  untranslated.report(diagnostics, Severity::Warning, "step.not_translated",
                      "entities could not be translated");
}

}  // namespace

CadFile read_step(const Source& source, const CadReadOptions& options, const OcctSession& session,
                  RunContext& context) {
  STEPCAFControl_Reader reader;
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_False);
  reader.SetPropsMode(Standard_False);
  reader.SetGDTMode(Standard_False);
  reader.SetMatMode(Standard_False);
  reader.SetViewMode(Standard_False);

  CadFile file;
  StepPmi pmi;
  const EndsAt cut = parse(reader, source, options, session, pmi, file.diagnostics, context);
  refuse_absurd_numbers(*reader.ChangeReader().StepModel(), source);
  file.schema = schema_of(reader);
  file.format = protocol_of(file.schema);
  seek_beside(reader, source);
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(OcctProgress) progress = new OcctProgress(context, kParsing, 1);
  const bool done = reader.Transfer(document, progress->Start());
  context.check();
  add_failures(reader, file.diagnostics);
  if (done) {
    const std::string stem = clean_name(model_stem(source.file()));
    const CollectOptions collect{
        Roots::Products, stem, numbers_of_products(reader), {}, names_of_solids(reader)};
    file.parts = collect_parts(document, collect, file.diagnostics, context);
  }
  if (cut > 0) {
    drop_unbounded(file.parts);
    if (file.parts.empty()) {
      throw InputError("the file ends early, before any whole face; copy or export it again",
                       source.file(), cut);
    }
  }
  if (options.pmi && !file.parts.empty()) {
    give_pmi(std::move(pmi), reader, file.parts, file.diagnostics);
  }
  report_external(reader, source, file);
  Tessellated(*reader.ChangeReader().StepModel()).report(file, source);
  return file;
}

}  // namespace burin
