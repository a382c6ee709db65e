#include "cad_file.h"

#include <burin/base/error.h>

#include "cad_format.h"
#include "foreign_file.h"
#include "occt_session.h"

#include <fmt/format.h>

#include <optional>

namespace burin {
namespace {

CadFormat detect(const Source& source, const std::filesystem::path& path) {
  const auto by_content = cad_format_of(source.bytes());
  if (by_content) return *by_content;
  if (const char* what = foreign_file(source.bytes())) source.fail(what);
  if (source.bytes().starts_with("PK\x03\x04")) source.fail("is a zip archive; unpack it first");
  const auto by_suffix = cad_format_of_suffix(path);
  if (by_suffix == CadFormat::Step) {
    source.fail("is no STEP file, which begins with ISO-10303-21; is it another format?");
  }
  if (by_suffix == CadFormat::Iges) {
    source.fail("is no IGES file, which has lines of 80 columns; is it another format?");
  }
  if (by_suffix) source.fail("is no BREP file of OCCT; is it another format?");
  source.fail("is no CAD file of a known kind; STEP, IGES and BREP are read");
}

CadFile read_as(CadFormat format, const Source& source, const CadReadOptions& options,
                const OcctSession& session, RunContext& context) {
  switch (format) {
    case CadFormat::Step:
      return read_step(source, options, session, context);
    case CadFormat::Iges:
      return read_iges(source, options.encoding, context);
    case CadFormat::BrepText:
      return read_brep(source, false, context);
    case CadFormat::BrepBinary:
      return read_brep(source, true, context);
  }
  source.fail("is of an unknown format");
}

}  // namespace

CadFile read_cad_file(const std::filesystem::path& path, const CadReadOptions& options,
                      const OcctSession& session, RunContext& context) {
  const Source source(path, context);
  const CadFormat format = detect(source, path);
  CadFile file;
  session.guarded(source.file(),
                  [&] { file = read_as(format, source, options, session, context); });
  if (file.parts.empty()) {
    source.fail("holds no faces to draw; export the solids or surfaces of the model");
  }
  return file;
}

}  // namespace burin
