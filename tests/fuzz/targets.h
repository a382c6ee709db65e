#pragma once
// What the targets share: a target hands bytes to a reader, which reads them or refuses them by an
// error of ours in one line. Anything else (another exception, a sanitizer's word, too much time or
// memory) is a finding.

#include <string>
#include <string_view>

namespace burin::fuzz {

/// A file with this suffix, by the reader that the suffix or the bytes choose.
void file(std::string_view bytes, const std::string& suffix);
/// The same for the one member `name` of a zip archive, whose check sums would else hide it.
void member(std::string_view bytes, const std::string& name, const std::string& suffix);

/// A formula: its bounds, its values and derivatives at a few points.
void implicit(std::string_view text);
/// A tree of OpenSCAD: what is read is nested as its numbers say, and its matrices are looked at.
void csg(std::string_view text);
/// A style file; one that is read is written, and reads back as the same.
void style(std::string_view text);
/// An illustration file, and what it asks; its models are not read.
void illustration(std::string_view text);
/// A drawing file; one that is read is written in every format of text.
void drawing(std::string_view text);
/// Options as the command line and Python pass them on: NAME=VALUE, a line each.
void options(std::string_view text);
/// What burin-probe says of a plug-in, and what the host keeps of that.
void plugin(std::string_view text);

}  // namespace burin::fuzz
