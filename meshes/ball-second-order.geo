// The octant of a ball of ball-quarter.geo in cells of second order with 20 nodes, those of `contact` on the sphere.
// Make the mesh with
//   gmsh -3 -format msh41 ball-second-order.geo -o ball-second-order.msh

Include "ball-quarter.geo";
Mesh.ElementOrder          = 2;
Mesh.SecondOrderIncomplete = 1;
