// The half x >= 0 of the lower half of a disc (so a quarter disc), all
// quadrilaterals: a cylinder pressed down, with one symmetry plane.
// Centre (0,R), lowest point (0,0); the part x >= 0, y <= R.
// Make the mesh with
//   gmsh -2 -format msh41 half-cylinder.geo -o half-cylinder.msh
// Another radius or number of cells, for example: -setnumber R 50 -setnumber n 3

DefineConstant[
  R  = 1,    // radius
  n  = 2,    // cells per direction in the inner block, so along the arc too
  nr = 2     // cells from the inner block to the arc
];

// vertices of the inner block, relative to R (chosen for the scaled Jacobian):
a = 0.52;    // on the axes:      (a,0)
b = 0.41;    // on the diagonal:  (b,b)

s2 = R/Sqrt(2);

Mesh.SaveAll      = 0;   // only what has a physical name
Mesh.ElementOrder = 1;
Mesh.Binary       = 0;

Point(1) = {0,   R,       0};    // the centre
Point(2) = {a*R, R,       0};
Point(3) = {0,   R - a*R, 0};
Point(4) = {b*R, R - b*R, 0};
Point(5) = {R,   R,       0};
Point(6) = {0,   0,       0};    // the lowest point
Point(7) = {s2,  R - s2,  0};

Line(1) = {1, 2};  Line(2) = {3, 4};    // inner block
Line(3) = {1, 3};  Line(4) = {2, 4};
Line(5) = {2, 5};  Line(6) = {3, 6};  Line(7) = {4, 7};    // radial
Circle(8) = {6, 1, 7};  Circle(9) = {7, 1, 5};             // the arc

// all counter-clockwise
Curve Loop(1) = {3, 2, -4, -1};    Plane Surface(1) = {1};   // inner
Curve Loop(2) = {6, 8, -7, -2};    Plane Surface(2) = {2};   // lower
Curve Loop(3) = {7, 9, -5, 4};     Plane Surface(3) = {3};   // right

Transfinite Curve {1, 2, 3, 4, 8, 9} = n + 1;
Transfinite Curve {5, 6, 7} = nr + 1;
Transfinite Surface "*";
Recombine Surface "*";

Physical Surface("cylinder", 1)  = {1, 2, 3};
Physical Curve("contact", 11)     = {8, 9};
Physical Curve("top", 12)         = {1, 5};
Physical Curve("symmetry", 13)    = {3, 6};
