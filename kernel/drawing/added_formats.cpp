#include <burin/base/catalogue.h>
#include <burin/drawing/added_formats.h>

namespace burin {
namespace {

GrowingCatalogue<AddedFormat>& added_catalogue() {
  static GrowingCatalogue<AddedFormat> formats({});
  return formats;
}

}  // namespace

std::span<const AddedFormat> added_formats() { return added_catalogue().rows(); }

void add(AddedFormat format) { added_catalogue().add(std::move(format)); }

}  // namespace burin
