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
x() = Surface In BoundingBox {-e, -e, -e, e, R + e, R + e};
y() = Surface In BoundingBox {-e, -e, -e, R + e, e, R + e};
top() = Surface In BoundingBox {-e, -e, R - e, R + e, R + e, R + e};
rest() = Boundary{ Volume{3}; };
rest() -= {x(), y(), top()};
Physical Surface("contact", 11) = {rest()};
Physical Surface("top", 12) = {top()};
Physical Surface("symmetry_x", 13) = {x()};
Physical Surface("symmetry_y", 14) = {y()};
Physical Volume("ball", 1) = {3};

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
