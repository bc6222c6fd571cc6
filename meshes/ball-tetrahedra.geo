// One octant of a ball, tetrahedra of second order, finer towards the lowest point.
// Centre (0,0,R), lowest point (0,0,0); the part x >= 0, y >= 0, z <= R.
// Make the mesh with
//   gmsh -3 -format msh41 ball-tetrahedra.geo -o ball-tetrahedra.msh

SetFactory("OpenCASCADE");

DefineConstant[
  R     = 1,    // radius
  size  = 0.4,  // of the cells far away
  fine  = 0.02, // and at the lowest point
  order = 2
];

Sphere(1) = {0, 0, R, R};
Box(2) = {0, 0, 0, R, R, R};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };

e = 1e-3;
Physical Volume("ball", 1) = {3};
faces() = Boundary{ Volume{3}; };
For i In {0:#faces() - 1}
  f = Abs(faces(i));
  b() = BoundingBox Surface{f};
  If (b(3) < e)
    Physical Surface("symmetry_x", 13) += {f};
  ElseIf (b(4) < e)
    Physical Surface("symmetry_y", 14) += {f};
  ElseIf (b(2) > R - e)
    Physical Surface("top", 12) += {f};
  Else
    Physical Surface("contact", 11) += {f};
  EndIf
EndFor

Field[1] = Ball;
Field[1].Radius = 0.08 * R;
Field[1].VIn = fine * R;
Field[1].VOut = size * R;
Field[1].Thickness = 0.8 * R;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Mesh.ElementOrder = order;
Mesh.HighOrderOptimize = 1;
Mesh.Binary = 0;
