// Two rectangular blocks, one on the other, with non-matching meshes: the 2D
// contact patch test PUB-01. The blocks touch at y = H and share no nodes there.
// Make the mesh (in the older MSH format 2.2) with
//   gmsh -2 -format msh22 two-blocks.geo -o two-blocks.msh

DefineConstant[
  L  = 10,   // width of both blocks
  H  = 5,    // height of each block
  n1 = 7,    // cells along the interface, lower block
  n2 = 5,    // the same, upper block
  m1 = 3,    // cells over the height, lower block
  m2 = 2     // the same, upper block
];

Mesh.SaveAll      = 0;   // only what has a physical name
Mesh.ElementOrder = 1;
Mesh.Binary       = 0;
Geometry.AutoCoherence = 0;   // keep the coincident points of the interface apart

// lower block
Point(1) = {0, 0, 0};  Point(2) = {L, 0, 0};
Point(3) = {L, H, 0};  Point(4) = {0, H, 0};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};

// upper block, with points and lines of its own
Point(5) = {0, H, 0};    Point(6) = {L, H, 0};
Point(7) = {L, 2*H, 0};  Point(8) = {0, 2*H, 0};
Line(5) = {5, 6};  Line(6) = {6, 7};  Line(7) = {7, 8};  Line(8) = {8, 5};
Curve Loop(2) = {5, 6, 7, 8};  Plane Surface(2) = {2};

Transfinite Curve {1, 3} = n1 + 1;
Transfinite Curve {2, 4} = m1 + 1;
Transfinite Curve {5, 7} = n2 + 1;
Transfinite Curve {6, 8} = m2 + 1;
Transfinite Surface {1, 2};
Recombine Surface {1, 2};

Physical Surface("lower", 1) = {1};
Physical Surface("upper", 2) = {2};
Physical Curve("lower_bottom", 11) = {1};   // y = 0
Physical Curve("lower_right", 12)  = {2};   // x = L
Physical Curve("lower_top", 13)    = {3};   // y = H, contact
Physical Curve("lower_left", 14)   = {4};   // x = 0
Physical Curve("upper_bottom", 21) = {5};   // y = H, contact
Physical Curve("upper_right", 22)  = {6};   // x = L
Physical Curve("upper_top", 23)    = {7};   // y = 2 H
Physical Curve("upper_left", 24)   = {8};   // x = 0
