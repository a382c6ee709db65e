// A flange with a neck, bolt holes and a keyway: burin draw samples/flange.scad -o flange.svg -D bolts=8
bolts = 6;
$fn = 48;
difference() {
  union() {
    cylinder(r = 40, h = 10);
    cylinder(r1 = 26, r2 = 20, h = 30);
    cylinder(r = 20, h = 42);
  }
  translate([0, 0, -1]) cylinder(r = 13, h = 50);
  for (i = [0 : bolts - 1]) rotate(360 / bolts * (i + 0.5)) translate([32, 0, -1]) cylinder(r = 3.5, h = 20, $fn = 20);
  translate([-2.5, 0, 20]) cube([5, 16, 30]);
  translate([0, 0, 36]) rotate([90, 0, 0]) cylinder(r = 3, h = 60, center = true, $fn = 20);
}
