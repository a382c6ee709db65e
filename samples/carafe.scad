// A vessel turned from a curve.
function radius(z) = 22 + 10 * sin(z * 3.2 + 20) - 0.08 * z;
n = 30;
height = 100;
rotate_extrude($fn = 60)
  polygon(concat([[0, 0]], [for (i = [0 : n]) [radius(height * i / n), height * i / n]],
                 [for (i = [n : -1 : 2]) [radius(height * i / n) - 2.5, height * i / n]], [[0, 4]]));
