#include <burin/base/catalogue.h>
#include <burin/drawing/added_formats.h>

namespace burin {
namespace {

GrowingCatalogue<AddedFormat>& all() {
  static GrowingCatalogue<AddedFormat> formats({});
  return formats;
}

}  // namespace

std::span<const AddedFormat> added_formats() { return all().rows(); }

void add(AddedFormat format) { all().add(std::move(format)); }

}  // namespace burin
