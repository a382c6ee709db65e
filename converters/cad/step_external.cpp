#include "step_external.h"

#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/short_list.h>

#include "text.h"

#include <IFSelect_ReturnStatus.hxx>
#include <STEPCAFControl_ExternFile.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPConstruct_ExternRefs.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>
#include <fmt/format.h>

#include <filesystem>
#include <set>

namespace burin {
namespace {

// More names than these make no line that anybody reads.
constexpr std::size_t kMostNamed = 5;

std::filesystem::path folder_of(const Source& source) {
  return std::filesystem::absolute(source.file()).parent_path();
}

/// As the files name them: in order, each once.
using Names = std::set<std::string>;

/// The files that the assembly itself names; those may name others.
Names named_in(STEPCAFControl_Reader& reader) {
  STEPConstruct_ExternRefs references(reader.Reader().WS());
  references.LoadExternRefs();
  Names names;
  for (int i = 1; i <= references.NbExternRefs(); ++i) {
    if (references.ProdDef(i).IsNull()) continue;  // a document that belongs to no product
    const char* name = references.FileName(i);
    if (name != nullptr && *name != '\0') names.insert(name);
  }
  return names;
}

/// Those that were not read, the ones of another format too, at which OCCT does not even look.
Names not_read(STEPCAFControl_Reader& reader, const std::filesystem::path& folder) {
  Names missing = named_in(reader);
  using Files = NCollection_DataMap<TCollection_AsciiString, Handle(STEPCAFControl_ExternFile)>;
  for (Files::Iterator it(reader.ExternFiles()); it.More(); it.Next()) {
    const std::filesystem::path path = folder / it.Key().ToCString();
    InputFiles::opens(path);
    const std::string name = path.lexically_proximate(folder).string();
    if (it.Value()->GetLoadStatus() == IFSelect_RetDone) {
      missing.erase(name);
    } else {
      missing.insert(name);
    }
  }
  return missing;
}

std::string listed(const Names& names) { return short_list(names, kMostNamed, clean_name); }

}  // namespace

void seek_beside(STEPCAFControl_Reader& reader, const Source& source) {
  const std::filesystem::path folder = folder_of(source);
  for (const std::string& name : named_in(reader)) InputFiles::opens(folder / name);
  reader.Reader().WS()->SetLoadedFile((folder / "assembly.step").c_str());
}

void report_external(STEPCAFControl_Reader& reader, const Source& source, CadFile& file) {
  const Names missing = not_read(reader, folder_of(source));
  if (missing.empty()) return;
  const std::string what = fmt::format(
      "parts of the assembly are in other files, which are missing or are no STEP "
      "files: {}; put them into its folder, or export it as one file",
      listed(missing));
  if (file.parts.empty()) throw InputError(what, source.file());
  file.diagnostics.add(Severity::Warning, "step.missing_file", std::ssize(missing), what);
}

}  // namespace burin
