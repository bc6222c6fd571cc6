// One octant of a ball, all hexahedra: a quarter of the lower half-ball.
// Centre (0,0,R), lowest point (0,0,0); the part x >= 0, y >= 0, z <= R.
// Make the mesh with
//   gmsh -3 -format msh41 ball-quarter.geo -o ball-quarter.msh
// Another radius or number of cells, for example: -setnumber R 8 -setnumber n 3
//
// Blocks as in deal.II's ball octant: one cube-like inner block at the centre
// of the ball and three blocks between it and the sphere. The lowest point is a
// right-angled corner of the lower outer block.

DefineConstant[
  R  = 1,    // radius
  n  = 2,    // cells per direction in the inner block, so along the sphere too
  nr = 2     // cells from the inner block to the sphere
];

// vertices of the inner block, relative to R (chosen for the scaled Jacobian):
a = 0.500;   // on the axes:                    (a,0,0)
b = 0.410;   // on the diagonals of the faces:  (b,b,0)
c = 0.345;   // on the diagonal of the octant:  (c,c,c)

s2 = R/Sqrt(2);
s3 = R/Sqrt(3);

Mesh.SaveAll      = 0;   // only what has a physical name
Mesh.ElementOrder = 1;
Mesh.Binary       = 0;

// inner block (the centre of the ball is point 1; "down" is -z)
Point(1) = {0,   0,   R};
Point(2) = {a*R, 0,   R};
Point(3) = {0,   a*R, R};
Point(4) = {b*R, b*R, R};
Point(5) = {0,   0,   R - a*R};
Point(6) = {b*R, 0,   R - b*R};
Point(7) = {0,   b*R, R - b*R};
Point(8) = {c*R, c*R, R - c*R};

// on the sphere, radially outward from points 2..8
Point(12) = {R,  0,  R};
Point(13) = {0,  R,  R};
Point(14) = {s2, s2, R};
Point(15) = {0,  0,  0};         // the lowest point
Point(16) = {s2, 0,  R - s2};
Point(17) = {0,  s2, R - s2};
Point(18) = {s3, s3, R - s3};

// lines of the inner block
Line(1)  = {1, 2};  Line(2)  = {3, 4};  Line(3)  = {5, 6};  Line(4)  = {7, 8};
Line(5)  = {1, 3};  Line(6)  = {2, 4};  Line(7)  = {5, 7};  Line(8)  = {6, 8};
Line(9)  = {1, 5};  Line(10) = {2, 6};  Line(11) = {3, 7};  Line(12) = {4, 8};

// radial lines
Line(22) = {2, 12};  Line(23) = {3, 13};  Line(24) = {4, 14};
Line(25) = {5, 15};  Line(26) = {6, 16};  Line(27) = {7, 17};  Line(28) = {8, 18};

// arcs on the sphere, each parallel to a line of the inner block
Circle(32) = {13, 1, 14};  Circle(33) = {15, 1, 16};  Circle(34) = {17, 1, 18};
Circle(36) = {12, 1, 14};  Circle(37) = {15, 1, 17};  Circle(38) = {16, 1, 18};
Circle(40) = {12, 1, 16};  Circle(41) = {13, 1, 17};  Circle(42) = {14, 1, 18};

// faces of the inner block
Curve Loop(1) = {1, 6, -2, -5};      Plane Surface(1) = {1};    // z = R
Curve Loop(2) = {1, 10, -3, -9};     Plane Surface(2) = {2};    // y = 0
Curve Loop(3) = {5, 11, -7, -9};     Plane Surface(3) = {3};    // x = 0
Curve Loop(4) = {3, 8, -4, -7};      Surface(4) = {4};          // towards -z
Curve Loop(5) = {6, 12, -8, -10};    Surface(5) = {5};          // towards +x
Curve Loop(6) = {2, 12, -4, -11};    Surface(6) = {6};          // towards +y

// faces on the sphere
Curve Loop(14) = {33, 38, -34, -37};  Surface(14) = {14} In Sphere {1};
Curve Loop(15) = {36, 42, -38, -40};  Surface(15) = {15} In Sphere {1};
Curve Loop(16) = {32, 42, -34, -41};  Surface(16) = {16} In Sphere {1};

// faces from the inner block to the sphere
Curve Loop(22) = {2, 24, -32, -23};   Plane Surface(22) = {22};  // z = R
Curve Loop(26) = {6, 24, -36, -22};   Plane Surface(26) = {26};  // z = R
Curve Loop(23) = {3, 26, -33, -25};   Plane Surface(23) = {23};  // y = 0
Curve Loop(30) = {10, 26, -40, -22};  Plane Surface(30) = {30};  // y = 0
Curve Loop(27) = {7, 27, -37, -25};   Plane Surface(27) = {27};  // x = 0
Curve Loop(31) = {11, 27, -41, -23};  Plane Surface(31) = {31};  // x = 0
Curve Loop(24) = {4, 28, -34, -27};   Surface(24) = {24};        // between blocks
Curve Loop(28) = {8, 28, -38, -26};   Surface(28) = {28};
Curve Loop(32) = {12, 28, -42, -24};  Surface(32) = {32};

Surface Loop(1) = {1, 2, 3, 4, 5, 6};          Volume(1) = {1};  // inner
Surface Loop(2) = {4, 14, 23, 28, 24, 27};     Volume(2) = {2};  // lower
Surface Loop(3) = {5, 15, 26, 32, 28, 30};     Volume(3) = {3};  // +x
Surface Loop(4) = {6, 16, 22, 32, 24, 31};     Volume(4) = {4};  // +y

Transfinite Curve {1:12, 32, 33, 34, 36, 37, 38, 40, 41, 42} = n + 1;
Transfinite Curve {22:28} = nr + 1;
Transfinite Surface "*";
Recombine Surface "*";
Transfinite Volume "*";

Physical Volume("ball", 1)        = {1, 2, 3, 4};
Physical Surface("contact", 11)    = {14, 15, 16};
Physical Surface("top", 12)        = {1, 22, 26};
Physical Surface("symmetry_x", 13) = {3, 27, 31};
Physical Surface("symmetry_y", 14) = {2, 23, 30};
