// Two blocks, one on the other, all hexahedra: the 3D contact patch test PUB-01
// with interface meshes that are non-matching and distorted in their plane.
// y is the vertical; the footprint is 0 <= x, z <= L. Each block is an
// unstructured quadrilateral mesh of the footprint, extruded along y. The blocks
// touch at y = H and share no nodes there.
// Make the mesh with
//   gmsh -3 -format msh41 distorted-blocks.geo -o distorted-blocks.msh

DefineConstant[
  L  = 10,   // width of both blocks in x and z
  H  = 5,    // height of each block
  m1 = 2,    // cells over the height, lower block
  m2 = 3     // the same, upper block
];

Mesh.SaveAll      = 0;   // only what has a physical name
Mesh.ElementOrder = 1;
Mesh.Binary       = 0;
Mesh.Algorithm    = 6;               // frontal-Delaunay (8, "for quads", crashes gmsh 4.8.4 here)
Mesh.RecombinationAlgorithm = 1;     // blossom

// This kernel does not merge coincident points, so the blocks stay apart.
SetFactory("OpenCASCADE");

// The numbers of cells on the sides z=0, x=L, z=L, x=0 of a footprint: different on
// opposite sides, so that the mesh cannot be regular, and different in the two
// blocks. The sum over the four sides must be even. Even so, blossom leaves a few
// triangles (so prisms) with some numbers: deal.II refuses such a mesh, "The Element
// Identifier <6> is not supported"; take other numbers then.

// lower block, from y = 0 upwards
Point(1) = {0, 0, 0};  Point(2) = {L, 0, 0};
Point(3) = {L, 0, L};  Point(4) = {0, 0, L};
Line(1) = {1, 2};  Line(2) = {2, 3};  Line(3) = {3, 4};  Line(4) = {4, 1};
Transfinite Curve {1} = 5 + 1;
Transfinite Curve {2} = 4 + 1;
Transfinite Curve {3} = 4 + 1;
Transfinite Curve {4} = 5 + 1;
Curve Loop(1) = {1, 2, 3, 4};  Plane Surface(1) = {1};
Recombine Surface {1};
lo[] = Extrude {0, H, 0} { Surface{1}; Layers{m1}; Recombine; };

// upper block, from y = 2 H downwards
Point(101) = {0, 2*H, 0};  Point(102) = {L, 2*H, 0};
Point(103) = {L, 2*H, L};  Point(104) = {0, 2*H, L};
Line(101) = {101, 102};  Line(102) = {102, 103};
Line(103) = {103, 104};  Line(104) = {104, 101};
Transfinite Curve {101} = 4 + 1;
Transfinite Curve {102} = 3 + 1;
Transfinite Curve {103} = 5 + 1;
Transfinite Curve {104} = 4 + 1;
Curve Loop(101) = {101, 102, 103, 104};  Plane Surface(101) = {101};
Recombine Surface {101};
up[] = Extrude {0, -H, 0} { Surface{101}; Layers{m2}; Recombine; };

// An extrusion returns the far end, the volume, and the sides in the order of the
// curve loop.
Physical Volume("lower", 1) = {lo[1]};
Physical Volume("upper", 2) = {up[1]};
Physical Surface("lower_bottom", 11) = {1};       // y = 0
Physical Surface("lower_right", 12)  = {lo[3]};   // x = L
Physical Surface("lower_top", 13)    = {lo[0]};   // y = H, contact
Physical Surface("lower_left", 14)   = {lo[5]};   // x = 0
Physical Surface("lower_front", 15)  = {lo[4]};   // z = L
Physical Surface("lower_back", 16)   = {lo[2]};   // z = 0
Physical Surface("upper_bottom", 21) = {up[0]};   // y = H, contact
Physical Surface("upper_right", 22)  = {up[3]};   // x = L
Physical Surface("upper_top", 23)    = {101};     // y = 2 H
Physical Surface("upper_left", 24)   = {up[5]};   // x = 0
Physical Surface("upper_front", 25)  = {up[4]};   // z = L
Physical Surface("upper_back", 26)   = {up[2]};   // z = 0
