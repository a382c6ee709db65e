#pragma once
// What rows of dimensions and notes write; internal to the module.

#include <burin/annotate/label.h>
#include <burin/arrange/dimension_row.h>

#include <memory>
#include <string>

namespace burin::detail {

/// How a row writes numbers on a sheet of that style.
DimensionOptions style_of(const DimensionRow& row, DimensionOptions style);
/// A text with each place of a name taken by something else.
std::string replaced(std::string text, const std::string& name, const std::string& by);

/// What stands at the end of a note's leader. Throws PluginError where a plug-in draws it and
/// fails.
std::shared_ptr<const Label> note_label(const MeasuredRow& row, const DimensionOptions& sheet);
/// The words of it alone.
std::shared_ptr<const Label> note_words(const MeasuredRow& row, const DimensionOptions& sheet);

}  // namespace burin::detail
