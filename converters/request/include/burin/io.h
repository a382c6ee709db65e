#pragma once
/// The entry header of libburin_io: files in and out, and drawings asked for by the words of the
/// command line and of illustration files. The CMake target is `burin::io`; what is drawn with is
/// in `burin/burin.h`.

// Files in: models, drawings, illustrations.
#include <burin/converters/illustration.h>
#include <burin/converters/load_plugins.h>
#include <burin/converters/read.h>
#include <burin/converters/read_drawing.h>
// Options by name, and what they make of a scene.
#include <burin/converters/catalogues.h>
#include <burin/converters/diff.h>
#include <burin/converters/messages.h>
#include <burin/converters/plan.h>
#include <burin/converters/request.h>
// Files out: drawings, parts lists, step books.
#include <burin/converters/output.h>
#include <burin/converters/write.h>
#include <burin/converters/write_book.h>
