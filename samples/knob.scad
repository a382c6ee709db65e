// A knob with grip flutes and a domed top.
flutes = 12;
difference() {
  union() {
    intersection() {
      cylinder(r = 22, h = 24, $fn = 60);
      translate([0, 0, -26]) sphere(r = 50, $fn = 90);
    }
    translate([0, 0, -8]) cylinder(r = 9, h = 9, $fn = 40);
    translate([0, 0, -6]) cylinder(r = 15, h = 3, $fn = 6);
  }
  for (i = [0 : flutes - 1]) rotate(360 / flutes * i) translate([25, 0, -1]) cylinder(r = 5, h = 30, $fn = 30);
  translate([0, 0, -9]) cylinder(r = 4, h = 20, $fn = 24);
}
