#pragma once
/// Parts of a STEP assembly that stand in files of their own, which it names: OCCT reads them.

#include "cad_file.h"

class STEPCAFControl_Reader;

namespace burin {

/// Lets `reader`, which has parsed `source`, look for them in the folder of `source`. Without this
/// OCCT looks in the folder that the program was started in.
void seek_beside(STEPCAFControl_Reader& reader, const Source& source);

/// To be called after the transfer. Says which files were not read; throws InputError, which names
/// them, where nothing else is to be drawn.
void report_external(STEPCAFControl_Reader& reader, const Source& source, CadFile& file);

}  // namespace burin
