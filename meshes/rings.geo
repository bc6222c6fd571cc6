// Two rings, one shrunk onto the other, PUB-03: the quarter x >= 0, y >= 0, in cells of second order, whose mid-side nodes
// lie on the circles. Each ring has points and lines of its own. Make the mesh with
//   gmsh -2 -format msh41 rings.geo -o rings.msh

Mesh.SaveAll      = 0;
Mesh.ElementOrder = 2;   // 9 nodes a cell
Mesh.Binary       = 0;
Geometry.AutoCoherence = 0;   // keep coincident points of different rings apart

Point(1) = {0, 0, 0};

// p: first point, a and b: inner and outer radius, around and through: cells
Macro Ring
  Point(p)     = {a, 0, 0};  Point(p + 1) = {b, 0, 0};
  Point(p + 2) = {0, b, 0};  Point(p + 3) = {0, a, 0};
  Line(p) = {p, p + 1};  Circle(p + 1) = {p + 1, 1, p + 2};
  Line(p + 2) = {p + 2, p + 3};  Circle(p + 3) = {p + 3, 1, p};
  Curve Loop(p) = {p, p + 1, p + 2, p + 3};  Plane Surface(p) = {p};
  Transfinite Curve {p, p + 2} = through + 1;
  Transfinite Curve {p + 1, p + 3} = around + 1;
  Transfinite Surface {p};
  Recombine Surface {p};
Return

p = 10;  a = 20;  b = 30.06;  around = 12;  through = 2;
Call Ring;
p = 20;  a = 30;  b = 45;  around = 17;  through = 2;
Call Ring;

Physical Surface("inner ring", 1) = {10};
Physical Surface("outer ring", 2) = {20};
Physical Curve("symmetry_y", 11) = {10, 20};   // y = 0
Physical Curve("symmetry_x", 12) = {12, 22};   // x = 0
Physical Curve("bore", 13)       = {13};
Physical Curve("fit", 14)        = {11, 23};   // contact, of either ring
Physical Curve("rim", 15)        = {21};
