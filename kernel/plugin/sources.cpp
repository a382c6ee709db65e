#include <burin/base/catalogue.h>
#include <burin/plugin/sources.h>

namespace burin::plugin {
namespace {

GrowingCatalogue<ReaderKind>& all_readers() {
  static GrowingCatalogue<ReaderKind> kinds({});
  return kinds;
}

GrowingCatalogue<FormKind>& all_forms() {
  static GrowingCatalogue<FormKind> kinds({});
  return kinds;
}

}  // namespace

std::span<const ReaderKind> readers() { return all_readers().rows(); }
std::span<const FormKind> forms() { return all_forms().rows(); }

void add(ReaderKind kind) { all_readers().add(std::move(kind)); }
void add(FormKind kind) { all_forms().add(std::move(kind)); }

bool names_form(std::string_view input) { return input.starts_with(kFormPrefix); }

const FormKind& find_form(std::string_view input) {
  const std::string_view name = names_form(input) ? input.substr(kFormPrefix.size()) : input;
  if (forms().empty()) {
    throw UsageError("no plug-in offers the form '" + std::string(name) +
                     "', nor any other (see burin plugins)");
  }
  return find_row(forms(), name, "form");
}

}  // namespace burin::plugin
