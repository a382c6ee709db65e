// What a model says to Burin: names of parts, ink, the view, how it comes apart, numbers.
// Save it beside your model, or in OpenSCAD's library folder, and begin with
//
//     use <burin.scad>
//
// OpenSCAD itself draws the children as if these modules were not there.

// The children are one part, called `name`.
module part(name) {
  burin_says("part", [name]);
  children();
}

// The children are drawn in a style: a built-in one (burin styles) or a file NAME.json.
module ink(style) {
  burin_says("ink", [style]);
  children();
}

// Where the drawing is looked at from: a name ("iso", "front", ...) or the way to the viewer, [x, y, z].
// To stand at the top, not within a difference or a hull.
module view(from, up) {
  burin_says("view", [from, up]);
}

// In an exploded view the children are moved by `by`, [x, y, z] in mm. Modules that move the children
// turn the way as well.
module explode(by) {
  burin_says("explode", [by]);
  children();
}

// The children get a number at the end of a leader: this one, or the next that is free.
module callout(number) {
  burin_says("callout", [number]);
  children();
}

// The children have a thread on their shafts and in their holes that fit its size, "M6" or "M6x0.75":
// all along, or `length` mm from the open end.
module thread(size, length) {
  burin_says("thread", [size, length]);
  children();
}

// Words beside the drawing, with a leader to the children. A line ends with "\n"; {part.name}, {item} and
// {volume} are the children's own.
module note(text) {
  burin_says("note", [text]);
  children();
}

// An arrow before the children, the way that they move, [x, y, z].
module arrow(along) {
  burin_says("arrow", [along]);
  children();
}

// A polyhedron without faces, which OpenSCAD makes nothing of; its points hold what is said.
module burin_says(what, arguments) {
  polyhedron(points = concat([[0.271828, 0.314159, 0.141421]], burin_points(concat([what], arguments))),
             faces = []);
}

function burin_points(v) =
  is_undef(v) ? [[0, 0, 0]]
  : is_bool(v) ? [[1, v ? 1 : 0, 0]]
  : is_num(v) ? [[2, v, 0]]
  : is_string(v) ? concat([[3, len(v), 0]], [for (c = v) [ord(c), 0, 0]])
  : concat([[4, len(v), 0]], [for (item = v) each burin_points(item)]);
