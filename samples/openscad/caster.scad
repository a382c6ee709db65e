// A swivel caster of six parts: burin draw samples/openscad/caster.scad -o caster.svg --style engraving
// With --explode auto it comes apart as explode() says; --callouts numbers its parts.
use <burin.scad>

wheel = 50;  // diameter
$fn = 64;

view([2, -3, 1.2]);

explode([0, 0, 40]) callout(1) part("plate") color("silver") plate();
part("fork") color("silver") fork();
explode([0, 0, -45]) {
  part("tyre") color("dimgray") on_axle() tyre();
  part("hub") color("white") on_axle() hub();
}
explode([0, -60, 0]) part("axle") color("gray") on_axle() axle();
explode([0, 60, 0]) callout(6) part("nut") color("gray") on_axle() translate([0, 0, -19]) nut();

module on_axle() translate([18, 0, -wheel / 2 - 12]) rotate([90, 0, 0]) children();

module plate() {
  difference() {
    hull() for (x = [-1, 1], y = [-1, 1]) translate([20 * x, 16 * y, 3]) cylinder(r = 5, h = 4);
    for (x = [-1, 1], y = [-1, 1]) translate([19 * x, 15 * y, 0]) cylinder(d = 5.5, h = 20, $fn = 32);
    translate([0, 0, 5]) cylinder(d = 9, h = 20, $fn = 32);
  }
  // The race that the fork turns in.
  rotate_extrude() translate([14, 3]) difference() {
    translate([-3, -5]) square([6, 5]);
    translate([0, -5]) circle(d = 4, $fn = 32);
  }
}

module fork() {
  difference() {
    union() {
      translate([0, 0, -6]) cylinder(r = 17, h = 4);
      for (side = [-1, 1]) hull() {
        translate([0, 13 * side, -6]) rotate([90, 0, 0]) cylinder(r = 8, h = 3, center = true);
        translate([18, 13 * side, -wheel / 2 - 12]) rotate([90, 0, 0]) cylinder(r = 8, h = 3, center = true);
      }
    }
    on_axle() cylinder(d = 8, h = 40, center = true, $fn = 32);
    // What of the arms' rounded ends would stand above the ring.
    translate([0, 0, 23]) cube([60, 40, 50], center = true);
  }
}

module tyre() rotate_extrude() translate([wheel / 2 - 6, 0]) difference() {
  hull() for (y = [-1, 1]) translate([2, 5 * y]) circle(r = 4, $fn = 48);
  translate([-5, -10]) square([5, 20]);
}

module hub() difference() {
  union() {
    cylinder(r = wheel / 2 - 6, h = 14, center = true);
    cylinder(r = 7, h = 22, center = true);
  }
  cylinder(d = 8, h = 40, center = true, $fn = 32);
  for (side = [-1, 1]) rotate([90 - 90 * side, 0, 0]) translate([0, 0, 3]) difference() {
    cylinder(r = wheel / 2 - 9, h = 10);
    cylinder(r = 9, h = 30, center = true);
    for (i = [0 : 4]) rotate(72 * i) translate([0, -2, -5]) cube([40, 4, 20]);
  }
}

module axle() {
  cylinder(d = 8, h = 42, center = true, $fn = 32);
  translate([0, 0, 15]) cylinder(d = 14, h = 5, $fn = 6);
}

module nut() difference() {
  cylinder(d = 14, h = 5, center = true, $fn = 6);
  cylinder(d = 8, h = 10, center = true, $fn = 32);
}
