#pragma once
/// The entry header of libburin, the CMake target `burin::burin`: all that a program needs to draw,
/// stage by stage or all at once. Files are read and written by `burin/io.h`.

// All that a drawing shows of a scene, as one value, and one call that draws it.
#include <burin/arrange/arrange.h>
// What is drawn, and whence.
#include <burin/camera/sheet.h>
#include <burin/camera/standards.h>
#include <burin/surface/scene.h>
// Where strokes go, how dark, and the strokes.
#include <burin/field/catalogue.h>
#include <burin/stroke/stroke.h>
#include <burin/tone/tone.h>
// The lines of the shape, and what hides what.
#include <burin/feature/feature.h>
#include <burin/visibility/occluder.h>
#include <burin/visibility/visible_spans.h>
// The sheet.
#include <burin/drawing/drawing.h>
#include <burin/drawing/writers.h>
// All of it in the right order.
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>
#include <burin/illustrate/view_probe.h>
